// The release build must give the golden values of tests/golden.json, as debug and wasm do: the
// program by its runs of every preset, and the library by the whole file, variants included.
// Usage: node tests/release_digests.mjs target/release/steadycut target/release/examples/golden
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';

const [program, library] = process.argv.slice(2);
if (program === undefined || library === undefined) {
    console.error('usage: node tests/release_digests.mjs PROGRAM GOLDEN_EXAMPLE');
    process.exit(2);
}
const text = readFileSync(new URL('golden.json', import.meta.url), 'utf8');
const golden = JSON.parse(text);
const METRICS = ['ra_final_um', 'force_final_n', 'feed_final_mm_min', 'in_tolerance_percent'];
const rounded = (x) => (x === null ? null : Math.round(x * 1e6) / 1e6);

let wrong = 0;
for (const [preset, expected] of Object.entries(golden)) {
    const report = JSON.parse(execFileSync(program, ['run', preset, '--json']));
    const differ = ['digest', 'ticks'].filter((name) => report[name] !== expected[name]);
    differ.push(...METRICS.filter((name) => rounded(report[name]) !== expected[name]));
    wrong += differ.length === 0 ? 0 : 1;
    const end = differ.length === 0 ? '' : `: ${differ.join(', ')} differ`;
    console.log(`${differ.length === 0 ? 'ok  ' : 'FAIL'} ${preset} ${report.ticks} ${report.digest}${end}`);
}
const whole = execFileSync(library, { maxBuffer: 1e8 }).toString() === text;
console.log(`${whole ? 'ok  ' : 'FAIL'} the whole of tests/golden.json from the library`);
if (wrong > 0 || !whole || Object.keys(golden).length === 0) {
    console.error(`${wrong} presets differ from tests/golden.json`);
    process.exit(1);
}
