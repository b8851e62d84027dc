// The page in a real browser: Chromium, headless, drawing in software. Needs web/dist (web/build)
// and Chromium (Debian's package chromium, or the environment variable CHROMIUM).

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { assertGolden } from "./golden.mjs";
import * as helpers from "./helpers.mjs";
import { NO_GL, PATIENCE, SHOTS, SOFTWARE_GL, firstFrame, launch, picture, state, untilState } from "./helpers.mjs";
import { serve } from "./server.mjs";

let browser;
let server;
const others = []; // servers of single tests
const serveChanged = async (change) => {
  others.push(await serve({ change }));
  return others.at(-1);
};
before(async () => {
  server = await serve();
  browser = await launch(SOFTWARE_GL);
});
after(async () => {
  await browser?.close();
  for (const each of [server, ...others]) await each?.close();
});

// --- helpers ----------------------------------------------------------------------------------

const open = ({ from = browser, ...how } = {}) => helpers.open(from, how);

// The state after that many frames: a page at which nothing moves draws none, until a pointer wakes it.
async function stirred(page, frames) {
  const end = Date.now() + PATIENCE.timeout;
  for (let x = 300; ; x = 300 + ((x + 7) % 200)) {
    await page.mouse.move(x, 400);
    const now = await state(page);
    if (now.frames > frames) return now;
    assert.ok(Date.now() < end, "frames are drawn");
    await new Promise((resolve) => setTimeout(resolve, PATIENCE.polling));
  }
}

async function errorPage(page, title) {
  await page.locator("#failed").waitFor({ state: "visible", timeout: PATIENCE.timeout });
  assert.equal(await page.locator("#failed-title").innerText(), title);
  assert.equal(await page.locator("#reload").isVisible(), true);
  assert.match(await page.locator("#failed").innerText(), /current versions of Chrome, Edge, Firefox and Safari/);
}

// --- the console ------------------------------------------------------------------------------

test("the console draws, gives the golden digests and obeys the target-Ra slider", async (t) => {
  const { page, context, wrong } = await open({
    // Write down what the loading page says.
    prepare: () => {
      window.phases = [];
      document.addEventListener("DOMContentLoaded", () => {
        const phase = document.getElementById("phase");
        new MutationObserver(() => window.phases.push(phase.textContent)).observe(phase, { childList: true });
      });
    },
  });
  await page.goto(server.url);
  const first = await firstFrame(page);
  assert.equal(await page.title(), "SteadyCut");
  assert.equal(first.screen, "console");
  assert.equal(first.error, null);

  const phases = await page.evaluate(() => window.phases);
  const [, done, total] = phases.findLast((text) => text.startsWith("Loading:")).match(/^Loading: ([\d.]+) of ([\d.]+) MB$/);
  assert.equal(done, total, "the bar ends at the full size");
  assert.equal(phases.at(-1), "Starting…");

  await t.test("digests", async () => {
    assertGolden(await page.evaluate(() => window.steadycut.preset_digests()));
  });

  await t.test("slider", async () => {
    const old = await untilState(page, (now) => now.rects?.target_ra_slider?.length === 4);
    const [x0, y0, x1, y1] = old.rects.target_ra_slider;
    assert.ok(x1 - x0 > 20 && y1 - y0 > 4, `the slider's place: ${old.rects.target_ra_slider}`);
    const y = (y0 + y1) / 2;
    const at = (share) => x0 + share * (x1 - x0);
    // Press at one place and pull to another: wherever the handle was, the target changes.
    await page.mouse.move(at(0.15), y);
    await page.mouse.down();
    const pressed = await untilState(page, (now, was) => now.frames > was.frames + 1, old);
    await page.mouse.move(at(0.3), y, { steps: 4 });
    const pulled = await untilState(page, (now, was) => now.target_ra_um !== was.target_ra_um, pressed);
    await page.mouse.up();
    assert.ok(pulled.target_ra_um > 0);
    await untilState(page, (now, was) => Math.abs(now.ra_um - was.ra_um) > 1e-6, old);
  });

  await picture(page, "console");

  // Screens with a key each, as the program lists them; the others are shown by their tabs, which
  // the tests of the console do.
  assert.ok(first.screens.length > 1);
  for (const { key, id: screen } of first.screens.slice(1).filter(({ key }) => key)) {
    await t.test(`screen ${screen}`, async () => {
      await page.keyboard.press(key);
      const shown = await untilState(page, (now, screen) => now.screen === screen, screen);
      await stirred(page, shown.frames + 5);
      await picture(page, screen);
    });
  }
  assert.deepEqual(wrong, []);
  await context.close();
});

test("the console draws on a phone", async () => {
  const { page, context, wrong } = await open({
    // Scale 1: the size in device pixels that Chromium reports ignores an emulated scale.
    settings: { viewport: { width: 390, height: 844 }, deviceScaleFactor: 1, hasTouch: true, isMobile: true, colorScheme: "dark" },
  });
  await page.goto(server.url);
  const first = await firstFrame(page);
  const size = await page.evaluate(() => [innerWidth, innerHeight, document.documentElement.scrollWidth, document.documentElement.scrollHeight]);
  assert.deepEqual(size, [390, 844, 390, 844], "the page fits the screen and does not scroll");
  await page.touchscreen.tap(195, 420);
  await untilState(page, (now, was) => now.frames > was.frames, first);
  await picture(page, "phone");
  assert.deepEqual(wrong, []);
  await context.close();
});

test("a bad link is reported, and the console runs", async () => {
  const { page, context, wrong } = await open();
  await page.goto(`${server.url}#v=1&target.ra_um=abc`);
  await firstFrame(page);
  const { error } = await untilState(page, (now) => now.error !== null && now.frames > 2);
  assert.match(error, /target\.ra_um/);
  await picture(page, "bad-link");
  assert.deepEqual(wrong, []);
  await context.close();
});

test("a good link opens its scenario, and one pasted into the open page replaces it", async () => {
  const { page, context, wrong } = await open();
  await page.goto(`${server.url}#v=1&target.ra_um=0.6`);
  const first = await firstFrame(page);
  assert.equal(first.target_ra_um, 0.6);
  // The page reloads: the program of before is gone until the new one draws.
  await page.evaluate(() => { location.hash = "#v=1&target.ra_um=1.3"; });
  await page.waitForFunction(
    () => window.steadycut && JSON.parse(window.steadycut.state_json() || "{}").target_ra_um === 1.3,
    null,
    PATIENCE,
  );
  assert.deepEqual(wrong, []);
  await context.close();
});

// Whether a key is left to the browser: nobody has kept it from acting there.
const isLeft = (page, key) =>
  page.evaluate(
    (key) => document.getElementById("canvas").dispatchEvent(new KeyboardEvent("keydown", { bubbles: true, cancelable: true, code: key.key, ...key })),
    key,
  );

test("each key acts in the page or in the browser", async () => {
  const { page, context, wrong } = await open();
  await page.goto(server.url);
  await firstFrame(page);
  await page.keyboard.press("Space");
  await page.keyboard.press("Shift+ArrowRight");
  const old = await untilState(page, (now) => !now.playing && now.playhead_s > 0.5);
  for (const key of [
    { key: "ArrowLeft", altKey: true },
    { key: "4", code: "Digit4", ctrlKey: true },
    { key: "l", code: "KeyL", ctrlKey: true },
    { key: "e", code: "KeyE", ctrlKey: true },
    { key: "F5" },
  ]) {
    assert.equal(await isLeft(page, key), true, `${JSON.stringify(key)} is the browser's`);
  }
  const now = await stirred(page, old.frames + 3);
  assert.deepEqual([now.screen, now.playhead_s, now.link], [old.screen, old.playhead_s, null]);
  for (const key of [{ key: "ArrowLeft" }, { key: "z", code: "KeyZ", ctrlKey: true }, { key: "End" }, { key: "Tab" }]) {
    assert.equal(await isLeft(page, key), false, `${JSON.stringify(key)} is the console's`);
  }
  // Escape until nothing is left to close, then Tab leads out.
  // Several keys of one frame count as one: pressed again until it has had a frame to itself.
  const end = Date.now() + PATIENCE.timeout;
  while (!(await page.evaluate(() => window.steadycut.tab_leaves()))) {
    assert.ok(Date.now() < end, "Escape leads out");
    await page.keyboard.press("Escape");
    await stirred(page, (await state(page)).frames + 1);
  }
  assert.equal(await isLeft(page, { key: "Tab" }), true);
  assert.deepEqual(wrong, []);
  await context.close();
});

for (const [what, prepare] of [
  ["refuses", () => Object.defineProperty(navigator, "clipboard", { value: { writeText: () => Promise.reject(new Error("denied")) } })],
  ["is missing", () => Object.defineProperty(navigator, "clipboard", { value: undefined })],
]) {
  test(`where the clipboard ${what} the link is put up, and nothing false is said`, async () => {
    const { page, context, wrong } = await open({ prepare });
    await page.goto(server.url);
    await firstFrame(page);
    await page.keyboard.press("l");
    const now = await untilState(page, (now) => now.link !== null);
    assert.match(now.link, /^http.*#/);
    assert.equal(now.error, null);
    await picture(page, "link");
    assert.deepEqual(wrong, []);
    await context.close();
  });
}

test("the address has the last change, and a hidden page stands still", async () => {
  const { page, context, wrong } = await open();
  await page.goto(`${server.url}#v=1&target.ra_um=0.6`);
  await firstFrame(page);
  const hide = (hidden) =>
    page.evaluate((hidden) => {
      Object.defineProperty(document, "hidden", { value: hidden, configurable: true });
      document.dispatchEvent(new Event("visibilitychange"));
    }, hidden);
  await untilState(page, (now) => now.playing && now.playhead_s > 0);
  await hide(true);
  await new Promise((resolve) => setTimeout(resolve, 300)); // a frame that was on its way
  const old = await state(page);
  await new Promise((resolve) => setTimeout(resolve, 1500));
  const now = await state(page);
  assert.equal(now.playhead_s, old.playhead_s);
  await hide(false);
  await untilState(page, (now, was) => now.playhead_s > was.playhead_s, now);
  await page.keyboard.press("Space");
  const [x0, y0, x1, y1] = now.rects.target_ra_slider;
  await page.mouse.click(x0 + 0.3 * (x1 - x0), (y0 + y1) / 2, { delay: 300 });
  await untilState(page, (now) => now.target_ra_um !== 0.6);
  for (const key of ["z", "y", "z"]) await page.keyboard.press(`Control+${key}`);
  await untilState(page, (now) => now.target_ra_um === 0.6 && now.address_is_current);
  await page.reload();
  assert.equal((await firstFrame(page)).target_ra_um, 0.6);
  assert.deepEqual(wrong, []);
  await context.close();
});

test("a finger that scrolls changes nothing, and one that goes across does", async () => {
  const { page, context, wrong } = await open({ settings: { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true } });
  await page.goto(server.url);
  const first = await firstFrame(page);
  const touch = await context.newCDPSession(page);
  const swipe = async (from, way) => {
    const at = (share) => [{ x: from[0] + share * way[0], y: from[1] + share * way[1] }];
    await touch.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: at(0) });
    await new Promise((resolve) => setTimeout(resolve, 600));
    for (const share of [0.2, 0.5, 0.8, 1]) {
      await touch.send("Input.dispatchTouchEvent", { type: "touchMove", touchPoints: at(share) });
      await new Promise((resolve) => setTimeout(resolve, 400)); // a frame under software drawing
    }
    await touch.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
    await new Promise((resolve) => setTimeout(resolve, 600));
    return state(page);
  };
  const now = await untilState(page, (now) => now.rects.target_ra_slider?.length === 4);
  const [x0, y0, x1, y1] = now.rects.target_ra_slider;
  const middle = [(x0 + x1) / 2, (y0 + y1) / 2];
  assert.equal((await swipe(middle, [8, -180])).target_ra_um, first.target_ra_um);
  const moved = (await state(page)).rects.target_ra_slider;
  const across = [moved[0] + 0.5 * (moved[2] - moved[0]), (moved[1] + moved[3]) / 2];
  assert.notEqual((await swipe(across, [80, 0])).target_ra_um, first.target_ra_um);
  assert.deepEqual(wrong, []);
  await context.close();
});

test("an edit storm leaves a short address, and it holds the last change", async () => {
  const { page, context, wrong } = await open();
  await page.goto(server.url);
  await firstFrame(page);
  const now = await untilState(page, (now) => now.rects.target_ra_slider?.length === 4 && now.playhead_s > 0.3);
  const [x0, y0, x1, y1] = now.rects.target_ra_slider;
  await page.mouse.move((x0 + x1) / 2, (y0 + y1) / 2);
  await page.mouse.down();
  const end = Date.now() + 10_000;
  for (let share = 0; Date.now() < end; share += 0.13) {
    await page.mouse.move(x0 + (0.5 + 0.4 * Math.sin(share)) * (x1 - x0), (y0 + y1) / 2);
    await new Promise((resolve) => setTimeout(resolve, 50));
  }
  await page.mouse.up();
  const last = await untilState(page, (now) => now.address_is_current);
  const address = await page.evaluate(() => location.hash);
  assert.ok(address.length < 700, `${address.length} characters: ${address}`);
  await page.reload();
  const again = await firstFrame(page);
  // The playhead begins anew; at its end the cut has the last target.
  await page.keyboard.press("End");
  await untilState(page, (now, target) => now.target_ra_um === target, last.target_ra_um);
  assert.equal(again.error, null);
  assert.deepEqual(wrong, []);
  await context.close();
});

test("a WebGPU without an adapter falls back to WebGL", async () => {
  const { page, context, wrong } = await open({
    prepare: () => Object.defineProperty(navigator, "gpu", { value: { requestAdapter: async () => null }, configurable: true }),
  });
  await page.goto(server.url);
  await firstFrame(page);
  assert.deepEqual(wrong, []);
  await context.close();
});

test("the program is downloaded while the graphics are being asked for", async () => {
  const { page, context, wrong } = await open({
    // An adapter that takes its time.
    prepare: () => {
      const requestAdapter = () => new Promise((resolve) => setTimeout(resolve, 2500, null));
      Object.defineProperty(navigator, "gpu", { value: { requestAdapter }, configurable: true });
    },
  });
  const asked = {};
  page.on("request", (request) => (asked[new URL(request.url()).pathname] ??= Date.now()));
  await page.goto(server.url);
  await firstFrame(page);
  const wait = (path) => asked[path] - asked["/boot.js"];
  assert.ok(wait("/steadycut.js") < 2000, `steadycut.js asked for ${wait("/steadycut.js")} ms after boot.js`);
  assert.ok(wait("/steadycut_bg.wasm") < 2000, `steadycut_bg.wasm asked for ${wait("/steadycut_bg.wasm")} ms after boot.js`);
  assert.deepEqual(wrong, []);
  await context.close();
});

test("canvas and text field have a name, and the page can be enlarged", async () => {
  const { page, context, wrong } = await open();
  await page.goto(server.url);
  await firstFrame(page);
  const tree = await (await context.newCDPSession(page)).send("Accessibility.getFullAXTree");
  const named = tree.nodes.filter((node) => !node.ignored).map((node) => `${node.role.value}: ${node.name?.value ?? ""}`);
  assert.ok(named.some((node) => /^application: SteadyCut/.test(node)), `the canvas has a name: ${named}`);
  assert.ok(named.some((node) => /^textbox: \S/.test(node)), `the text field has a name: ${named}`);
  assert.match(await page.locator("#canvas").textContent(), /WebGL 2 or WebGPU/, "the canvas has a fallback");
  const viewport = await page.locator("meta[name=viewport]").getAttribute("content");
  assert.doesNotMatch(viewport, /maximum-scale|user-scalable/);
  assert.equal(await page.locator("#canvas").evaluate((canvas) => getComputedStyle(canvas).touchAction), "pinch-zoom");
  assert.deepEqual(wrong, []);
  await context.close();
});

// --- for screen readers -----------------------------------------------------------------------

// The page as a screen reader has it: Chromium's own tree, and the keyboard.
async function reader(page, context) {
  const cdp = await context.newCDPSession(page);
  const tree = async () => {
    const { nodes } = await cdp.send("Accessibility.getFullAXTree");
    return nodes.filter((node) => !node.ignored);
  };
  const named = (nodes, role, name) =>
    nodes.find((node) => node.role.value === role && (name instanceof RegExp ? name.test(node.name?.value ?? "") : node.name?.value === name));
  const find = async (role, name) => {
    const end = Date.now() + PATIENCE.timeout;
    for (;;) {
      const nodes = await tree();
      const found = named(nodes, role, name);
      if (found) return found;
      const there = nodes.filter((node) => node.role.value === role).map((node) => node.name?.value);
      assert.ok(Date.now() < end, `no ${role} ${name} among ${JSON.stringify(there)}`);
      await new Promise((resolve) => setTimeout(resolve, PATIENCE.polling));
    }
  };
  const press = async (role, name, key = "Enter") => {
    // What does nothing yet takes no focus: it is waited for until it does.
    for (const end = Date.now() + PATIENCE.timeout; ; ) {
      const { backendDOMNodeId } = await find(role, name);
      const refused = await cdp.send("DOM.focus", { backendNodeId: backendDOMNodeId }).then(() => null, (error) => error);
      if (!refused) break;
      if (Date.now() > end) throw refused;
      await new Promise((resolve) => setTimeout(resolve, PATIENCE.polling));
    }
    await page.keyboard.press(key);
  };
  return { tree, find, press };
}

test("the page keeps files of one's own: they are used, downloaded and deleted", async () => {
  const { page, context, wrong } = await open();
  await page.goto(server.url);
  await firstFrame(page);
  const text = [
    'version = 1\ntitle = "Mill of this test"\nsource = "none"\nshape = "square"\ndiameter_mm = 10.0\nteeth = 3\nhelix_deg = 35.0',
    "rake_deg = 10.0\noverhang_mm = 32.0\nelastic_modulus_n_mm2 = 5.8e5\ncompliance_um_n = 0.025\nrunout_um = 5.0\n",
  ].join("\n");
  await page.evaluate((text) => {
    localStorage.setItem("steadycut.file/mill.toml", `t${text}`);
    localStorage.setItem("steadycut.file/broken.toml", `t${text.replace("teeth = 3", "teeth = 30")}`);
  }, text);
  await page.evaluate(() => document.activeElement.blur());
  await page.keyboard.press("Shift+Tab");
  await page.keyboard.press("Enter");
  const { find, press } = await reader(page, context);
  await press("button", "More settings");
  await press("button", "My files\u2026");
  await untilState(page, (now) => now.files.join() === "broken.toml,mill.toml");
  await find("StaticText", /`teeth` cannot be 30/);
  await press("button", "mill.toml");
  await untilState(page, (now) => now.error?.includes("Mill of this test is taken as the cutter"));
  await find("button", "mill.toml, in use");
  const [download] = await Promise.all([page.waitForEvent("download", PATIENCE), press("button", "Download: mill.toml")]);
  assert.equal(download.suggestedFilename(), "mill.toml");
  await press("button", "Delete\u2026: mill.toml");
  await press("button", "Delete it: mill.toml");
  await untilState(page, (now) => now.files.join() === "broken.toml");
  assert.deepEqual(await page.evaluate(() => Object.keys(localStorage).filter((key) => key.startsWith("steadycut.file/"))), [
    "steadycut.file/broken.toml",
  ]);
  await picture(page, "own-files");
  assert.deepEqual(wrong, []);
  await context.close();
});

test("a mission is done with keyboard and screen reader alone", async () => {
  const { page, context, wrong } = await open();
  await page.goto(server.url);
  await firstFrame(page);
  // The switch is the page's first stop, before the canvas.
  await page.evaluate(() => document.activeElement.blur());
  await page.keyboard.press("Shift+Tab");
  assert.equal(await page.evaluate(() => document.activeElement.id), "mirror-switch");
  await picture(page, "mirror-switch");
  await page.keyboard.press("Enter");
  const { tree, find, press } = await reader(page, context);
  const slider = await find("slider", "Target Ra");
  assert.ok(slider.properties.some(({ name, value }) => name === "valuemax" && value.value > 0), "a slider tells its range");
  // Nothing that takes the keyboard is without a name.
  const stops = (await tree()).filter((node) => node.properties?.some(({ name, value }) => name === "focusable" && value.value));
  assert.ok(stops.length > 40, `${stops.length} stops`);
  for (const stop of stops) {
    const root = stop.role.value === "RootWebArea" || stop.role.value === "application";
    assert.ok(root || stop.name?.value, `${stop.role.value} without a name: ${JSON.stringify(stop)}`);
  }
  await press("button", "Learn");
  const title = "Why a deeper stretch breaks constant feed";
  await press("button", `Begin: ${title}`);
  await press("radio", "It gets rougher", "Space");
  await press("button", "That is my prediction");
  await press("radio", "It more than doubles", "Space");
  await press("button", "That is my answer");
  await press("button", /^Controller/);
  await press("button", /^Tracking/);
  // A key that is none of an element's own goes on to the console.
  await page.keyboard.press("End");
  await untilState(page, (now) => now.playhead_s > 10);
  await press("button", "Check my answer");
  await find("StaticText", /^Passed: \d of 3 stars/);
  assert.deepEqual(wrong, []);
  // Remembered in the next visit, and gone when it is switched off.
  await page.reload();
  await firstFrame(page);
  await press("button", "Controls for screen readers");
  await page.waitForFunction(() => document.getElementById("mirror").hidden, null, PATIENCE);
  await context.close();
});

test("lost graphics come back without reloading, and too many losses are told in plain words", async () => {
  const { page, context } = await open();
  await page.goto(`${server.url}?graphics=webgl#v=1&target.ra_um=0.65`);
  let before = await firstFrame(page);
  await page.evaluate(() => { window.sameProgram = true; });
  const lose = () =>
    page.locator("#canvas").evaluate((canvas) => canvas.getContext("webgl2").getExtension("WEBGL_lose_context").loseContext());
  for (let loss = 1; loss <= 3; loss++) {
    const old = await page.locator("#canvas").elementHandle();
    await lose();
    await page.waitForFunction((old) => document.getElementById("canvas") !== old, old, PATIENCE);
    before = await untilState(page, (now, was) => now.frames > was.frames + 3, before);
    assert.equal(before.target_ra_um, 0.65);
    assert.equal(await page.evaluate(() => window.sameProgram), true, "the page was not loaded anew");
    assert.equal(await page.locator("#failed").isVisible(), false);
  }
  await picture(page, "graphics-back");
  await lose();
  await errorPage(page, "The graphics were lost");
  assert.doesNotMatch(await page.locator("#failed").innerText(), /fault in the program/);
  await page.screenshot({ path: `${SHOTS}/graphics-lost.png` });
  await context.close();
});

// --- without a network ------------------------------------------------------------------------

test("works off line after the first visit, and shows a new build at once", async () => {
  let first = "";
  let build = "";
  const own = await serveChanged((path, bytes) =>
    build && /\.(html|js)$/.test(path) ? Buffer.from(bytes.toString().replaceAll(first, build)) : bytes,
  );
  const { page, context } = await open({ settings: { serviceWorkers: "allow" } });
  await page.goto(own.url);
  await firstFrame(page);
  first = await page.evaluate(() => new URL(document.getElementById("boot").src).searchParams.get("v"));
  assert.match(first, /^[0-9a-f]{16}$/);
  // Waits until the service worker of a build is at work, and its cache the only one.
  const cacheIs = async (name) => {
    const end = Date.now() + PATIENCE.timeout;
    let seen;
    do {
      await new Promise((resolve) => setTimeout(resolve, PATIENCE.polling));
      seen = await page.evaluate(async () => {
        const [{ active, waiting, installing } = {}] = await navigator.serviceWorker.getRegistrations();
        return `${active?.state} ${waiting?.state} ${installing?.state} ${await caches.keys()}`;
      });
    } while (seen !== `activated undefined undefined steadycut-${name}` && Date.now() < end);
    assert.equal(seen, `activated undefined undefined steadycut-${name}`);
  };
  await cacheIs(first);

  build = "a".repeat(16);
  await page.reload();
  await firstFrame(page);
  assert.match(await page.evaluate(() => document.getElementById("boot").src), /v=a{16}$/, "the new build is shown at the first visit");
  await cacheIs(build);

  await own.close();
  await page.reload();
  await firstFrame(page);
  assert.match(await page.evaluate(() => document.getElementById("boot").src), /v=a{16}$/, "off line, the newest build is there");
  await picture(page, "off-line");
  await context.close();
});

// --- when it goes wrong -----------------------------------------------------------------------

test("no WebGPU and no WebGL: the error page", async () => {
  const bare = await launch(NO_GL);
  try {
    const { page, wrong } = await open({ from: bare });
    await page.goto(server.url);
    await errorPage(page, "SteadyCut can't draw here");
    await page.screenshot({ path: `${SHOTS}/no-graphics.png` });
    assert.deepEqual(wrong, []);
  } finally {
    await bare.close();
  }
});

for (const [what, status] of [["steadycut_bg.wasm", 404], ["steadycut.js", 500]]) {
  test(`${what} does not arrive: the error page`, async () => {
    const broken = await serveChanged((path, bytes) => (path === `/${what}` ? status : bytes));
    const { page, context } = await open();
    await page.goto(broken.url);
    await errorPage(page, "SteadyCut could not be loaded");
    await context.close();
    });
}

test("boot.js does not arrive: the error page", async () => {
  const broken = await serveChanged((path, bytes) => (path === "/boot.js" ? 404 : bytes));
  const { page, context } = await open();
  await page.goto(broken.url);
  await page.locator("#failed").waitFor({ state: "visible" });
  assert.equal(await page.locator("#failed-title").innerText(), "SteadyCut could not be loaded");
  await context.close();
});

test("a cut-off program: the error page", async () => {
  const broken = await serveChanged((path, bytes) => (path.endsWith(".wasm") ? bytes.subarray(0, bytes.length / 2) : bytes));
  const { page, context } = await open();
  await page.goto(broken.url);
  await errorPage(page, "SteadyCut could not be loaded");
  await context.close();
});

test("a panic: the error page with the message, and the reload button starts again", async () => {
  const { page, context, wrong } = await open();
  await page.goto(server.url);
  await firstFrame(page);
  await page.evaluate(() => window.steadycutPanic("panicked at src/some.rs:1:2: a test of the error page"));
  await errorPage(page, "SteadyCut has stopped");
  assert.match(await page.locator("#failed-detail").innerText(), /a test of the error page/);
  await page.screenshot({ path: `${SHOTS}/panic.png` });
  await page.locator("#reload").click();
  await page.waitForFunction(() => !window.steadycut || document.getElementById("failed").hidden, null, PATIENCE);
  await firstFrame(page);
  assert.deepEqual(wrong, []);
  await context.close();
});
