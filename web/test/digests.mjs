// The program in WebAssembly gives the same bits as natively: every preset's digest, metrics and
// variants against tests/golden.json, in Node, without a browser. Needs web/dist (web/build).

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
test("twice gives the same", () => assert.equal(program.preset_digests(), json));
