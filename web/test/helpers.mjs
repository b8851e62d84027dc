// What the tests in a browser share: Chromium, drawing in software, pages that remember what went wrong in them, and the
// program's state for tests. Needs Chromium (Debian's package chromium, or the environment variable CHROMIUM).

import assert from "node:assert/strict";
import { mkdirSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";

export const SHOTS = fileURLToPath(new URL("shots", import.meta.url));
export const PATIENCE = { timeout: 120_000, polling: 200 }; // software drawing on a busy machine is slow
const QUIET = [
  "--no-sandbox",
  "--no-first-run",
  "--disable-quic",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
];
export const SOFTWARE_GL = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"];
export const NO_GL = ["--disable-gpu", "--disable-3d-apis"];

export const launch = (flags) =>
  chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: [...QUIET, ...flags] });

mkdirSync(SHOTS, { recursive: true });

// A fresh page (own storage, own service worker) that remembers everything that went wrong in it.
export async function open(from, { settings = {}, prepare } = {}) {
  const context = await from.newContext({ viewport: { width: 1280, height: 800 }, serviceWorkers: "block", ...settings });
  const page = await context.newPage();
  const wrong = [];
  page.on("console", (message) => message.type() === "error" && wrong.push(`console: ${message.text()}`));
  page.on("pageerror", (error) => wrong.push(`page: ${error.stack ?? error}`));
  if (prepare) await page.addInitScript(prepare);
  return { page, context, wrong };
}

// Frames drawn, or the error page: whichever comes first.
export async function firstFrame(page) {
  await page.waitForFunction(
    () => !document.getElementById("failed").hidden || (window.steadycut && JSON.parse(window.steadycut.state_json()).frames > 0),
    null,
    PATIENCE,
  );
  assert.equal(await page.locator("#failed").isVisible(), false, `the error page: ${await page.locator("#failed").innerText()}`);
  assert.equal(await page.locator("#loading").isVisible(), false, "the loading page is still there");
  return state(page);
}

export const state = async (page) => JSON.parse(await page.evaluate(() => window.steadycut.state_json()));

// Waits until `check(state, argument)`, run in the page, is true; `timeout` in ms, where it shall not be the usual one.
export async function untilState(page, check, argument, timeout = PATIENCE.timeout) {
  const source = `(argument) => (${check})(JSON.parse(window.steadycut.state_json()), argument)`;
  await page.waitForFunction(new Function(`return ${source}`)(), argument, { ...PATIENCE, timeout });
  return state(page);
}

// A screenshot, kept in shots/, that must show a picture: many colours, none nearly everywhere.
export async function picture(page, name) {
  const png = await page.screenshot({ path: `${SHOTS}/${name}.png` });
  const context = await page.context().browser().newContext();
  const counts = await (await context.newPage()).evaluate(async (base64) => {
    const bitmap = await createImageBitmap(await (await fetch(`data:image/png;base64,${base64}`)).blob());
    const canvas = new OffscreenCanvas(bitmap.width, bitmap.height).getContext("2d");
    canvas.drawImage(bitmap, 0, 0);
    const pixels = new Uint32Array(canvas.getImageData(0, 0, bitmap.width, bitmap.height).data.buffer);
    const count = new Map();
    for (const pixel of pixels) count.set(pixel, (count.get(pixel) ?? 0) + 1);
    return { colours: count.size, commonest: Math.max(...count.values()) / pixels.length };
  }, png.toString("base64"));
  await context.close();
  assert.ok(counts.colours > 20 && counts.commonest < 0.98, `${name}: hardly a picture: ${JSON.stringify(counts)}`);
}
