// The program in WebAssembly gives the same bits as natively: every preset's digest, metrics and
// variants against tests/golden.json, and two searches for a formula, in Node, without a browser. Needs web/dist (web/build).

import assert from "node:assert/strict";
import { cpSync, readFileSync, rmSync } from "node:fs";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { assertGolden, bases, presets } from "./golden.mjs";
import { DIST } from "./server.mjs";

// Node takes .js files for ES modules only under a package.json that says so, as this folder's does.
const glue = fileURLToPath(new URL(".glue", import.meta.url));
rmSync(glue, { recursive: true, force: true });
cpSync(DIST, glue, { recursive: true, filter: (path) => !path.endsWith(".wasm") });

const program = await import("./.glue/steadycut.js");
program.initSync({ module: readFileSync(`${DIST}/steadycut_bg.wasm`) });
const json = program.preset_digests();

test("the presets are those of tests/golden.json", () => {
  assert.deepEqual(Object.keys(JSON.parse(json)).sort(), [...presets].sort());
  assert.notEqual(presets.length, 0);
  assert.notEqual(bases.length, 0);
});
for (const preset of presets) {
  test(`${preset}: the same digest in WebAssembly`, () => assertGolden(json, preset));
}
const gp = new URL("../../crates/study/tests/data/gp/", import.meta.url);
const digests = JSON.parse(readFileSync(new URL("digests.json", gp)));
for (const [table, target, inputs] of [
  ["k4_clean", "force_n", ["feed_mm_min", "speed_rpm"]],
  ["nguyen05", "y", ["x1"]],
]) {
  test(`${table}: the search for a formula gives the same digest in WebAssembly`, () => {
    const text = readFileSync(new URL(`${table}.csv`, gp), "utf8");
    assert.equal(program.search_digest(text, target, inputs, 1, 15), digests[table]);
  });
}
test("twice gives the same", () => assert.equal(program.preset_digests(), json));
