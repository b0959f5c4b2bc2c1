// SPDX-License-Identifier: MIT
// The solver in WebAssembly answers bit for bit as the native one: verdicts, certificates, distances and witnesses.
//     compare_test.mjs PRINT_ANSWERS PAIRS [SEED]
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { resolve } from "node:path";
import { fileURLToPath } from "node:url";

const here = (name) => fileURLToPath(new URL(name, import.meta.url));
const [program, pairs, seed = "1"] = process.argv.slice(2);
const questionSize = 18,
  fields = {
    "verdict of intersect": 1,
    "verdict of decide": 1,
    "kind of certificate": 1,
    hulls: 2,
    "steps of decide": 1,
    direction: 3,
    point: 6,
    "verdict of distance": 1,
    distance: 1,
    "error bound": 1,
    least: 1,
    "steps of distance": 1,
    "direction of the distance": 3,
    witnesses: 6,
  };
const names = Object.entries(fields).flatMap(([name, count]) => Array(count).fill(name));

const { exports } = new WebAssembly.Instance(new WebAssembly.Module(readFileSync(here("../solver.wasm"))));
const inside = (at, count) => new BigUint64Array(exports.memory.buffer, at, count);
const question = inside(exports.question(), questionSize),
  answers = inside(exports.answers(), names.length);

const { stdout, status } = spawnSync(resolve(program), [here("../../../corpus/cases"), pairs, seed], {
  maxBuffer: 1 << 30,
});
assert.equal(status, 0, "the native solver's answers");
const row = questionSize + names.length;
const native = new BigUint64Array(stdout.buffer, stdout.byteOffset, stdout.byteLength / 8);
assert.equal(native.length % row, 0, "whole rows");

const differing = {},
  verdicts = new Map(),
  proofs = new Map();
const count = (map, bits) => map.set(bits, (map.get(bits) ?? 0) + 1);
for (let at = 0; at < native.length; at += row) {
  question.set(native.subarray(at, at + questionSize));
  exports.answer();
  count(verdicts, answers[1]);
  count(proofs, answers[2]);
  for (const [i, name] of names.entries())
    if (answers[i] !== native[at + questionSize + i]) differing[name] = (differing[name] ?? 0) + 1;
}
const rows = native.length / row;
console.log(`${rows} pairs, ${names.length} numbers each; differing: ${JSON.stringify(differing)}`);
assert.deepEqual(differing, {}, "run reports/web/wasm/build.sh");
assert.ok(rows > Number(pairs) + 400, "the cases are among the pairs");
assert.equal(verdicts.size, 4, "disjoint, intersecting, undecided and invalid occur"); // decide() says no touching
assert.equal(proofs.size, 4, "every kind of certificate occurs, and none");
