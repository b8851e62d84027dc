// Adds the screen of CONTRIBUTING.md to a copy of the project and compiles it, tests included: a screen that
// needed a second line elsewhere would fail here. The copy shares what is compiled of other crates.

import { execFileSync, spawnSync } from "node:child_process";
import { copyFileSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const root = join(dirname(fileURLToPath(import.meta.url)), "..");
const target = join(root, "target");
const copy = join(target, "tmp", "screen");

rmSync(copy, { recursive: true, force: true });
for (const file of execFileSync("git", ["ls-files"], { cwd: root, encoding: "utf8" }).trim().split("\n")) {
  mkdirSync(dirname(join(copy, file)), { recursive: true });
  copyFileSync(join(root, file), join(copy, file));
}

const guide = readFileSync(join(copy, "CONTRIBUTING.md"), "utf8");
const section = guide.split("\n## ").find((text) => text.startsWith("Add a screen\n"));
const named = (start) => section.split(start)[1].split("`")[1];
const [text, line] = [...section.matchAll(/```rust\n([^]*?)```/g)].map((block) => block[1]);
if (line.trim().split("\n").length !== 1) throw new Error(`not one line: ${line}`);

const file = join(copy, named("The file, "));
const list = join(copy, named("list `screens!` of "));
const before = readFileSync(list, "utf8");
const start = before.indexOf("\nscreens! {\n");
const end = before.indexOf("\n}", start) + 1;
if (start < 0 || end < 1) throw new Error(`no list of screens in ${list}`);
writeFileSync(list, before.slice(0, end) + line + before.slice(end));

const check = () =>
  spawnSync("cargo", ["check", "--locked", "--tests", "-p", "steadycut", "--target-dir", target], {
    cwd: copy,
    encoding: "utf8",
  });

writeFileSync(file, text);
const whole = check();
if (whole.status !== 0) throw new Error(`the screen of the guide does not compile:\n${whole.stderr}`);

// The compiler names what is left out.
writeFileSync(file, text.replace("fn words(", "fn word("));
const lacking = check();
if (lacking.status === 0 || !/not all trait items implemented/.test(lacking.stderr)) {
  throw new Error(`a screen without its words compiled, or failed for another reason:\n${lacking.stderr}`);
}
rmSync(copy, { recursive: true, force: true });
console.log("one file and one line are a screen");
