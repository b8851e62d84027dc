// Holds deny.toml: licences, banned and duplicate crates, sources. cargo-deny does the same and more,
// but takes longer to build from nothing than all else here; the format is its own.
// Usage: node .ci/deny.mjs
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";

const root = new URL("..", import.meta.url);

// The part of TOML that deny.toml is written in: tables, strings, booleans, arrays, inline tables.
function parse(text) {
  const bare = text.replace(/^\s*#.*$/gm, "");
  const found = {};
  for (const section of bare.split(/^(?=\[\w+\]\s*$)/m).filter((part) => part.trim() !== "")) {
    const [, name, body] = section.match(/^\s*\[(\w+)\]\s*\n([^]*)$/) ?? [];
    if (name === undefined) throw new Error(`deny.toml: no table begins at ${section.trim()}`);
    found[name] = {};
    for (const entry of body.split(/^(?=[\w-]+\s*=)/m).filter((part) => part.trim() !== "")) {
      const [, key, value] = entry.match(/^([\w-]+)\s*=([^]*)$/) ?? [];
      if (key === undefined) throw new Error(`deny.toml: no entry at ${entry.trim()}`);
      const json = value.replace(/([{,]\s*)([\w-]+)\s*=/g, '$1"$2":').replace(/,(\s*\])/g, "$1");
      found[name][key] = JSON.parse(json);
    }
  }
  return found;
}

// Whether an SPDX expression can be met by allowed licences; `/` is the old form of OR.
function met(expression, allowed) {
  const tokens = expression.replaceAll("/", " OR ").match(/[()]|[^\s()]+/g);
  let at = 0;
  const one = () => {
    if (tokens[at] === "(") {
      at += 1;
      const inner = either();
      at += 1;
      return inner;
    }
    let name = tokens[at++];
    if (tokens[at] === "WITH") {
      name += ` WITH ${tokens[at + 1]}`;
      at += 2;
    }
    return allowed.includes(name);
  };
  const both = () => {
    let all = one();
    while (tokens[at] === "AND") {
      at += 1;
      all = one() && all;
    }
    return all;
  };
  const either = () => {
    let any = both();
    while (tokens[at] === "OR") {
      at += 1;
      any = both() || any;
    }
    return any;
  };
  const result = either();
  if (at !== tokens.length) throw new Error(`no licence expression: ${expression}`);
  return result;
}

const deny = parse(readFileSync(new URL("deny.toml", root), "utf8"));
const targets = deny.graph.targets.flatMap((target) => ["--filter-platform", target]);
const text = execFileSync(
  "cargo",
  ["metadata", "--locked", "--format-version", "1", "--all-features", ...targets],
  { cwd: root, maxBuffer: 1e9, stdio: ["ignore", "pipe", "inherit"] },
);
const metadata = JSON.parse(text);
const built = new Set(metadata.resolve.nodes.map((node) => node.id));
const crates = metadata.packages.filter((crate) => built.has(crate.id));

const problems = [];
const exceptions = new Map(deny.licenses.exceptions.map((entry) => [entry.crate, entry.allow]));
const banned = new Set(deny.bans.deny.map((entry) => entry.crate));
const skipped = new Set(deny.bans.skip);
const versions = new Map();
for (const { name, version, license, source, dependencies } of crates) {
  const id = `${name}@${version}`;
  const allowed = [...deny.licenses.allow, ...(exceptions.get(name) ?? [])];
  if (license === null) problems.push(`${id} states no licence`);
  else if (!met(license, allowed)) problems.push(`${id} is under ${license}`);
  exceptions.delete(name);
  if (banned.has(name)) problems.push(`${id} is banned`);
  if (source !== null && !deny.sources["allow-registry"].some((url) => source === `registry+${url}`)) {
    problems.push(`${id} comes from ${source}`);
  }
  if (source === null) {
    for (const needed of dependencies.filter((one) => one.req === "*" && one.path === undefined)) {
      problems.push(`${id} takes any version of ${needed.name}`);
    }
  }
  if (!skipped.delete(id)) versions.set(name, [...(versions.get(name) ?? []), version]);
}
for (const [name, found] of versions) {
  if (found.length > 1) problems.push(`${name} is there in versions ${found.join(", ")}`);
}
for (const id of skipped) problems.push(`deny.toml skips ${id}, which is not there`);
for (const name of exceptions.keys()) problems.push(`deny.toml excepts ${name}, which is not there`);
if (crates.length < 100) problems.push(`only ${crates.length} crates found`);

// The reader of licences itself, since nothing else would notice if it said yes to everything.
for (const [expression, expected] of [
  ["MIT", true], ["GPL-3.0", false], ["GPL-3.0 OR MIT", true], ["GPL-3.0 AND MIT", false],
  ["(MIT OR GPL-3.0) AND ISC", true], ["MIT/GPL-2.0", true], ["Apache-2.0 WITH LLVM-exception", true],
  ["Apache-2.0 WITH other", false],
]) {
  if (met(expression, deny.licenses.allow) !== expected) problems.push(`misread: ${expression}`);
}

for (const problem of problems) console.error(`deny.toml: ${problem}`);
console.log(`${crates.length} crates, ${problems.length} problems`);
process.exit(problems.length === 0 ? 0 : 1);
