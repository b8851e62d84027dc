// The release build must give the golden digests of tests/golden.json, as debug and wasm do.
// Usage: node tests/release_digests.mjs target/release/steadycut
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';

const golden = JSON.parse(readFileSync(new URL('golden.json', import.meta.url)));
let wrong = 0;
for (const [preset, expected] of Object.entries(golden)) {
    const report = JSON.parse(execFileSync(process.argv[2], ['run', preset, '--json']));
    const same = report.digest === expected.digest && report.ticks === expected.ticks;
    wrong += same ? 0 : 1;
    console.log(`${same ? 'ok  ' : 'FAIL'} ${preset} ${report.ticks} ${report.digest}`);
}
if (wrong > 0 || Object.keys(golden).length === 0) {
    console.error(`${wrong} digests differ from tests/golden.json`);
    process.exit(1);
}
