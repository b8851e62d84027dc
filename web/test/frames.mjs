// What a frame costs in the page, in Chromium drawing in software: the page's own work (in the callback of
// requestAnimationFrame) and the whole frame, beside a bare eframe page with one egui_plot, built and drawn the
// same way. Needs web/dist. Prints a table; with --test it fails where the console's own work is above 6 ms or a
// screen's frame is above twice that of the bare page. Measure on a quiet machine.

import { chromium } from "playwright-core";
import { serve } from "./server.mjs";

const FRAMES = 40;
const MOST_OWN_MS = 6;
const MOST_TIMES = 2;
const SCREENS = ["console", "block_diagram", "workpiece", "machine"]; // those that play

const server = await serve();
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--no-first-run", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"],
});

// Notes when each frame begins and how long the page works in it.
const note = () => {
  const real = window.requestAnimationFrame.bind(window);
  window.frames_noted = [];
  window.requestAnimationFrame = (callback) =>
    real((time) => {
      const begin = performance.now();
      callback(time);
      window.frames_noted.push([begin, performance.now() - begin]);
    });
};

const median = (values) => [...values].sort((a, b) => a - b)[values.length >> 1];

async function measured(page) {
  await page.evaluate(() => { window.frames_noted = []; });
  await page.waitForFunction((count) => window.frames_noted.length > count, FRAMES, { timeout: 120_000, polling: 500 });
  const noted = (await page.evaluate(() => window.frames_noted)).slice(0, FRAMES + 1);
  const apart = noted.slice(1).map(([begin], i) => begin - noted[i][0]);
  return { own: median(noted.map(([, own]) => own)), frame: median(apart) };
}

async function open(prepare) {
  const page = await browser.newPage({ viewport: { width: 1280, height: 800 }, serviceWorkers: "block" });
  await page.addInitScript(note);
  await page.goto(server.url);
  await page.waitForFunction(() => window.steadycut && JSON.parse(window.steadycut.state_json()).frames > 0, null, { timeout: 120_000 });
  await prepare(page);
  const result = await measured(page);
  await page.close();
  return result;
}

const results = [];
const bare = await open((page) =>
  page.evaluate(async () => {
    window.steadycut.stop();
    const canvas = document.getElementById("canvas");
    const fresh = canvas.cloneNode(true);
    canvas.replaceWith(fresh);
    await window.steadycut.start_bare(fresh);
  }),
);
results.push(["bare page", bare]);
for (const screen of SCREENS) {
  const result = await open(async (page) => {
    const state = JSON.parse(await page.evaluate(() => window.steadycut.state_json()));
    const { key } = state.screens.find((each) => each.id === screen);
    await page.keyboard.press(key);
    // Well into the cut, so that the plots are full.
    await page.waitForFunction((screen) => {
      const now = JSON.parse(window.steadycut.state_json());
      return now.screen === screen && now.playhead_s > 8;
    }, screen, { timeout: 120_000, polling: 500 });
  });
  results.push([screen, result]);
}
await browser.close();
await server.close();

let failed = false;
for (const [name, { own, frame }] of results) {
  const times = frame / bare.frame;
  const fine = name === "bare page" || ((name !== "console" || own <= MOST_OWN_MS) && times <= MOST_TIMES);
  failed ||= !fine;
  console.log(`${name.padEnd(14)} own work ${own.toFixed(1).padStart(6)} ms, frame ${frame.toFixed(0).padStart(5)} ms, ${times.toFixed(2)} times the bare page${fine ? "" : "  TOO SLOW"}`);
}
if (failed && process.argv.includes("--test")) process.exit(1);
