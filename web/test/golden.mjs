// What the presets must give, natively and in WebAssembly alike: tests/golden.json.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";

const golden = JSON.parse(readFileSync(new URL("../../tests/golden.json", import.meta.url)));

export const presets = Object.keys(golden);

// Compares one preset, or all and their names if none is given, with the text of preset_digests().
export function assertGolden(json, preset) {
  const got = JSON.parse(json);
  const pick = ({ ticks, digest, variants } = {}) => ({ ticks, digest, variants });
  if (preset !== undefined) return assert.deepEqual(pick(got[preset]), pick(golden[preset]));
  assert.deepEqual(Object.keys(got).sort(), [...presets].sort(), "the presets");
  for (const name of presets) assert.deepEqual(pick(got[name]), pick(golden[name]), name);
}
