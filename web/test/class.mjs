// Missions in a class, in a real browser: packages that `steadycut mission pack` has made of web/dist run in a page
// with an open-source SCORM runtime (scorm-again) around them, send xAPI statements to a store, and work off line.
// Needs web/dist (web/build), Chromium, and the program: target/release/steadycut or target/debug/steadycut, or the
// path in the variable STEADYCUT.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { cpSync, existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createServer } from "node:http";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { inflateRawSync } from "node:zlib";
import { PATIENCE, SHOTS, SOFTWARE_GL, firstFrame, launch, open, picture, state, untilState } from "./helpers.mjs";
import { DIST, serve } from "./server.mjs";

const MISSION = "depth-step-at-constant-feed";
const ROOT = fileURLToPath(new URL("../../", import.meta.url));
const PROGRAM = [process.env.STEADYCUT, ...["release", "debug"].map((kind) => join(ROOT, "target", kind, "steadycut"))]
  .find((path) => path && existsSync(path));
// High enough to show a mission whole: what is pressed must be in sight.
const SIZE = { width: 1280, height: 1500 };

// The files of a zip, by its central directory (PKWARE's APPNOTE, 4.3.12): nothing of the program that wrote it.
function unzip(bytes, folder) {
  const end = bytes.lastIndexOf(Buffer.from("PK\x05\x06", "latin1"));
  let at = bytes.readUInt32LE(end + 16);
  for (let left = bytes.readUInt16LE(end + 10); left > 0; left -= 1) {
    assert.equal(bytes.readUInt32LE(at), 0x02014b50, "an entry of the directory");
    const [method, size, name, extra, comment] = [
      bytes.readUInt16LE(at + 10), bytes.readUInt32LE(at + 20), bytes.readUInt16LE(at + 28),
      bytes.readUInt16LE(at + 30), bytes.readUInt16LE(at + 32),
    ];
    const path = join(folder, bytes.toString("utf8", at + 46, at + 46 + name));
    const local = bytes.readUInt32LE(at + 42);
    const from = local + 30 + bytes.readUInt16LE(local + 26) + bytes.readUInt16LE(local + 28);
    const packed = bytes.subarray(from, from + size);
    mkdirSync(dirname(path), { recursive: true });
    writeFileSync(path, method === 0 ? packed : inflateRawSync(packed));
    at += 46 + name + extra + comment;
  }
}

// A page around the package, as a platform has it: the runtime's API in it, the package in a frame over all of it.
const PLATFORM = `<!doctype html><title>Platform</title><link rel="icon" href="data:,"><body style="margin: 0"><script src="scorm12.js"></script><script>
  window.begin = (address, kept) => {
    window.API = new Scorm12API({ autocommit: false, logLevel: 4 });
    if (kept) window.API.loadFromJSON(kept);
    window.commits = 0;
    window.API.on("LMSCommit", () => { window.commits += 1; });
    const frame = document.createElement("iframe");
    frame.name = "package";
    frame.src = address;
    frame.style.cssText = "position: fixed; inset: 0; width: 100%; height: 100%; border: 0";
    document.body.append(frame);
  };
  window.end = () => document.querySelector("iframe").remove();
  window.cmi = () => JSON.parse(JSON.stringify(window.API.renderCMIToJSONObject())).cmi;
</script>`;

let browser;
let server;
let folder;
before(async () => {
  assert.ok(PROGRAM, "cargo build, or the path of the program in STEADYCUT");
  assert.ok(existsSync(join(DIST, "index.html")), "web/build first");
  folder = mkdtempSync(join(tmpdir(), "steadycut-class-"));
  for (const kind of ["scorm", "xapi"]) {
    const zip = join(folder, `${kind}.zip`);
    const flags = ["--embed", "hide:screens,hide:files"];
    execFileSync(PROGRAM, ["mission", "pack", MISSION, "--page", DIST, `--${kind}`, ...flags, "--out", zip]);
    unzip(readFileSync(zip), join(folder, kind));
  }
  cpSync(createRequire(import.meta.url).resolve("scorm-again/scorm12"), join(folder, "scorm12.js"));
  writeFileSync(join(folder, "platform.html"), PLATFORM);
  server = await serve({ folder });
  browser = await launch(SOFTWARE_GL);
});
after(async () => {
  await browser?.close();
  await server?.close();
  if (folder) rmSync(folder, { recursive: true, force: true });
});

// --- helpers ----------------------------------------------------------------------------------

// Presses what the program has drawn under this name, once it stays where it is, until the state is as `check` says. A
// cut that is worked out meanwhile may have moved it under the press: then it is pressed where it is now.
async function press(page, frame, name, check, argument) {
  const TIMES = 4;
  for (let time = 1; ; time += 1) {
    await untilState(frame, (now, name) => now.rects?.lesson?.[name] !== undefined, name);
    const place = async () => (await state(frame)).rects.lesson[name];
    let rect = await place();
    for (let before; rect && `${before}` !== `${rect}`; ) {
      // Some frames: what came last moves what stands below it. A page at rest draws none.
      await new Promise((resolve) => setTimeout(resolve, 1000));
      [before, rect] = [rect, await place()];
    }
    const [x0, y0, x1, y1] = rect;
    assert.ok(y1 < SIZE.height, `${name} is in sight, at ${y1}`);
    await page.mouse.click((x0 + x1) / 2, (y0 + y1) / 2, { delay: 300 });
    if (time === TIMES) return untilState(frame, check, argument);
    const pressed = await untilState(frame, check, argument, 30_000).catch(() => null);
    if (pressed) return pressed;
  }
}

// Answers the questions of the first two steps: predicts an option, then says another of what the cut shows.
async function predict(page, frame, [first, second]) {
  await press(page, frame, `option ${first}`, (now) => now.rects.lesson.say !== undefined);
  await press(page, frame, "say", (now) => now.rects.lesson["step 2"] !== undefined);
  await press(page, frame, `option ${second}`, () => true);
  return press(page, frame, "say", (now) => now.rects.lesson.check !== undefined);
}

// Leaves both questions without an answer, which is asked twice, and hands the cut in as it is.
async function handIn(page, frame) {
  const sure = "skip all the same";
  await press(page, frame, "skip", (now, sure) => now.rects.lesson[sure] !== undefined, sure);
  await press(page, frame, sure, (now) => now.rects.lesson["step 2"] !== undefined);
  await press(page, frame, "skip", () => true);
  await press(page, frame, sure, (now) => now.rects.lesson.check !== undefined);
  return press(page, frame, "check", (now) => now.result !== null);
}

async function platform() {
  const opened = await open(browser, { settings: { viewport: SIZE } });
  await opened.page.goto(`${server.url}platform.html`);
  return opened;
}

// Opens the package in the platform, which has kept this of an earlier time.
async function launched(page, address, kept) {
  await page.evaluate(([address, kept]) => window.begin(address, kept), [address, kept]);
  const frame = await (await page.waitForSelector("iframe")).contentFrame();
  await frame.waitForFunction(() => window.steadycut !== undefined, null, PATIENCE);
  await untilState(frame, (now) => now.frames > 2 && now.mission !== null);
  return frame;
}

const cmi = (page) => page.evaluate(() => window.cmi());

// --- SCORM 1.2 --------------------------------------------------------------------------------

test("a SCORM runtime receives score, completion and answers, and brings them back", async () => {
  const { page, context, wrong } = await platform();
  let frame = await launched(page, "scorm/index.html");
  assert.equal((await state(frame)).mission, `mission=${MISSION}`);
  assert.match(await frame.evaluate(() => location.hash), new RegExp(`^#embed=hide:screens,hide:files&mission=${MISSION}$`));
  assert.equal((await cmi(page)).core.lesson_status, "incomplete");

  const { result } = await handIn(page, frame);
  assert.equal(result.verdict.passed, false);
  assert.deepEqual(result.tries, { begun: 1, checked: 1 });
  for (const { answered, solution } of result.verdict.predictions) {
    assert.deepEqual([answered, solution], [false, ""], "nothing tells the right answers before it is passed");
  }
  await picture(page, "class-failed");
  let now = await cmi(page);
  assert.deepEqual([now.core.lesson_status, now.core.score], ["failed", { raw: "0", min: "0", max: "100" }]);
  assert.equal(now.core.lesson_location, MISSION);
  let kept = JSON.parse(now.suspend_data);
  assert.deepEqual([kept.passed, kept.stars, kept.tries], [false, 0, 1]);
  const commits = await page.evaluate(() => window.commits);
  assert.ok(commits >= 2, `${commits} commits`);

  // The page is left: it says good-bye.
  await page.evaluate(() => window.end());
  await page.waitForFunction(() => window.API.isTerminated());
  now = await cmi(page);
  assert.equal(now.core.exit, "suspend");
  assert.match(now.core.session_time, /^\d{2,4}:\d{2}:\d{2}(\.\d+)?$/);
  assert.notEqual(now.core.session_time, "00:00:00");

  // The next time with the cut that holds Ra, and with the right prediction.
  const link = result.answer.link;
  const solved = `scorm/index.html#embed=hide:screens,hide:files&mission=${MISSION}&${link}&controller.kind=tracking`;
  frame = await launched(page, solved, now);
  assert.equal((await cmi(page)).core.lesson_status, "failed", "it was not begun anew");
  await predict(page, frame, [3, 3]);
  const passed = await press(page, frame, "check", (now) => now.result !== null);
  assert.deepEqual([passed.result.verdict.passed, passed.result.verdict.stars], [true, 3]);
  assert.equal(passed.stars, 3, "the page remembers them as well");
  await picture(page, "class-passed");
  now = await cmi(page);
  assert.deepEqual([now.core.lesson_status, now.core.score.raw], ["passed", "100"]);
  kept = JSON.parse(now.suspend_data);
  assert.deepEqual([kept.passed, kept.stars, kept.tries], [true, 3, 2]);
  assert.deepEqual(kept.answer.predictions, [{ step: 1, choice: 3 }, { step: 2, choice: 3 }]);
  await page.evaluate(() => window.end());
  await page.waitForFunction(() => window.API.isTerminated());
  assert.equal((await cmi(page)).core.exit, "");

  // What the page says it got is true by the command line as well.
  const file = join(folder, "result.json");
  writeFileSync(file, JSON.stringify(passed.result));
  assert.match(execFileSync(PROGRAM, ["mission", "check", file]).toString(), /the result is true/);
  assert.deepEqual(wrong, []);
  await context.close();
});

test("without a platform around it the package says that nothing is recorded, and runs", async () => {
  const { page, context, wrong } = await open(browser);
  await page.goto(`${server.url}scorm/index.html`);
  await firstFrame(page);
  await page.locator("#pack-told").waitFor({ state: "visible" });
  assert.match(await page.locator("#pack-told").innerText(), /results are not recorded/);
  assert.equal((await untilState(page, (now) => now.mission !== null)).mission, `mission=${MISSION}`);
  await page.screenshot({ path: `${SHOTS}/class-alone.png` });
  assert.deepEqual(wrong, []);
  await context.close();
});

// --- xAPI, and off line -----------------------------------------------------------------------

// A store of records on another origin, as platforms have it.
async function store(port = 0) {
  const posts = [];
  const server = createServer((request, response) => {
    const headers = {
      "Access-Control-Allow-Origin": request.headers.origin ?? "*",
      "Access-Control-Allow-Headers": "authorization, content-type, x-experience-api-version",
      "Access-Control-Allow-Methods": "POST",
    };
    if (request.method === "OPTIONS") return response.writeHead(204, headers).end();
    let body = "";
    request.on("data", (part) => (body += part));
    request.on("end", () => {
      posts.push({ path: request.url, headers: request.headers, statements: JSON.parse(body) });
      response.writeHead(200, { ...headers, "Content-Type": "application/json" });
      response.end(JSON.stringify(posts.at(-1).statements.map(({ id }) => id)));
    });
  });
  await new Promise((resolve, reject) => server.once("error", reject).listen(port, "localhost", resolve));
  return {
    posts,
    port: server.address().port,
    statements: () => posts.flatMap((post) => post.statements),
    close: () => new Promise((resolve) => { server.close(resolve); server.closeAllConnections(); }),
  };
}

const verbs = (statements) => statements.map(({ verb }) => verb.id.split("/").at(-1));

async function until(check) {
  const end = Date.now() + PATIENCE.timeout;
  while (!(await check())) {
    assert.ok(Date.now() < end, `${check}`);
    await new Promise((resolve) => setTimeout(resolve, PATIENCE.polling));
  }
}

test("statements reach the store, wait while there is no network, and the page opens without one", async () => {
  const own = await serve({ folder: join(folder, "xapi") });
  let records = await store();
  const actor = { objectType: "Agent", name: "Ada", mbox: "mailto:ada@example.org" };
  const registration = "9a1b2c3d-0000-4000-8000-000000000000";
  const query = new URLSearchParams({
    endpoint: `http://localhost:${records.port}/xapi`, auth: "Basic YTpi", actor: JSON.stringify(actor), registration,
  });
  const { page, context } = await open(browser, { settings: { viewport: SIZE, serviceWorkers: "allow" } });
  await page.goto(`${own.url}index.html?${query}`);
  await firstFrame(page);
  await untilState(page, (now) => now.mission !== null);
  await until(() => records.statements().length === 1);
  const [{ path, headers, statements: [first] }] = records.posts;
  assert.equal(path, "/xapi/statements");
  assert.deepEqual([headers.authorization, headers["x-experience-api-version"]], ["Basic YTpi", "1.0.3"]);
  assert.deepEqual(first.actor, actor);
  assert.equal(first.context.registration, registration);
  assert.match(first.object.id, new RegExp(`^urn:steadycut:mission:${MISSION}:[0-9a-f]{16}$`));
  assert.match(readFileSync(join(folder, "xapi", "tincan.xml"), "utf8"), new RegExp(`<activity id="${first.object.id}"`));

  await predict(page, page, [1, 3]);
  await press(page, page, "check", (now) => now.result !== null);
  await until(() => records.statements().length === 4);
  assert.deepEqual(verbs(records.statements()), ["initialized", "answered", "answered", "failed"]);
  const [, answered, looked, failed] = records.statements();
  assert.deepEqual(answered.result, { response: "1", success: false });
  assert.equal(answered.object.id, `${first.object.id}/step/1`);
  assert.deepEqual(looked.result, { response: "3", success: true });
  assert.deepEqual(failed.result.score, { scaled: 0, raw: 0, min: 0, max: 3 });
  assert.equal(new Set(records.statements().map(({ id }) => id)).size, 4);

  // Page and store are gone; the worker has the page once it is at work.
  await page.evaluate(() => navigator.serviceWorker.ready);
  await until(() => page.evaluate(async () => (await caches.keys()).some((name) => name.startsWith("packed-steadycut-"))));
  await until(() => page.evaluate(async () => {
    const [name] = await caches.keys();
    // The page and what the package adds to it; boot, texts, mirror, glue, program and icon.
    return (await (await caches.open(name)).keys()).length === 8;
  }));
  await own.close();
  const port = records.port;
  await records.close();
  const link = (await state(page)).result.answer.link;
  await page.evaluate((hash) => history.replaceState(null, "", hash), `#embed=hide:screens,hide:files&mission=${MISSION}&${link}&controller.kind=tracking`);
  await page.reload();
  await firstFrame(page);
  await untilState(page, (now) => now.mission !== null);
  await predict(page, page, [3, 3]);
  const { result } = await press(page, page, "check", (now) => now.result !== null);
  assert.equal(result.verdict.stars, 3);
  await picture(page, "class-off-line");
  const waiting = () => page.evaluate(() => {
    const key = Object.keys(localStorage).find((key) => key.startsWith("steadycut.xapi."));
    return key ? JSON.parse(localStorage.getItem(key)).length : 0;
  });
  await until(async () => (await waiting()) === 5);

  // The network is back.
  records = await store(port);
  await page.evaluate(() => window.dispatchEvent(new Event("online")));
  await until(() => records.statements().length >= 5);
  assert.deepEqual(verbs(records.statements()), ["initialized", "answered", "answered", "passed", "completed"]);
  const completed = records.statements().at(-1).result;
  assert.deepEqual([completed.score.scaled, completed.success, completed.completion], [1, true, true]);
  assert.match(completed.duration, /^PT[\d.]+S$/);
  await until(async () => (await waiting()) === 0);
  await context.close();
  await records.close();
});
