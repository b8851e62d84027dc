// What the presets must give, natively and in WebAssembly alike: tests/golden.json.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";

const golden = JSON.parse(readFileSync(new URL("../../tests/golden.json", import.meta.url)));

export const presets = Object.keys(golden);

// Compares one preset, or all and their names if none is given, with the text of preset_digests():
// ticks, digest, metrics and, where the file has them, the variants.
export function assertGolden(json, preset) {
  const got = JSON.parse(json);
  if (preset !== undefined) return assert.deepEqual(got[preset], golden[preset]);
  assert.deepEqual(got, golden);
}

// The presets that have variants: there must be some.
export const bases = presets.filter((preset) => Object.keys(golden[preset].variants ?? {}).length > 0);
