// SPDX-License-Identifier: MIT
// The data of the page before it draws, and the charts, as built into the page.
//     node --test data_test.mjs
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { test } from "node:test";
import { charts, daylight } from "../chart.mjs";
import { sample, untriaged } from "./sample.mjs";

const { chosen, expand, full, glossary, pareto, prove, rowsOf, sentenceOf, shellQuoted } = daylight;

test("findings get back the pair, the answers and the command", () => {
  const packed = sample();
  packed.run.folder = "a b'c";
  const findings = new Map(expand(packed).findings.map((f) => [f.id, f]));
  for (const { id, case: at, margin, method } of packed.findings) {
    const f = findings.get(id),
      { pair, said } = packed.cases[at];
    assert.equal(f.replay, `./daylight replay 'a b'\\''c:${id}'`);
    assert.deepEqual([f.pair, f.margin], [pair, margin]);
    const [[answer]] = said.filter(([, who]) => who.includes(method));
    assert.deepEqual(f.answers[method], answer);
  }
});

test("every certificate of the sample holds", () => {
  for (const f of expand(sample()).findings) assert.notEqual(prove(f.pair, f.truth).holds, false, f.id);
});

test("a filter is a text and three selections", () => {
  const report = expand(sample()),
    rows = rowsOf(report);
  for (const [filter, passes] of [
    [{}, () => true],
    [{ library: "fcl", family: "lattice" }, (f) => f.method.startsWith("fcl-") && f.family === "lattice"],
    [{ kind: "wrong_disjoint" }, (f) => f.kind === "wrong_disjoint"],
    [{ text: "Wrong disjoint ode" }, (f) => f.kind === "wrong_disjoint" && f.method.startsWith("ode")],
    [{ text: "beyond its claim" }, (f) => f.severity === "contract"],
  ]) {
    const found = chosen(rows.findings, filter);
    assert.deepEqual(found, report.findings.filter(passes), JSON.stringify(filter));
    assert.ok(found.length > 0);
  }
  const causes = chosen(rows.causes, { library: "fcl" });
  assert.deepEqual(causes, report.causes.filter((b) => b.methods.some((m) => /^fcl/.test(m))));
});

test("the order of causes and findings is that of the data", () => {
  const packed = sample();
  for (const of of [packed.causes, packed.findings]) of.reverse();
  const { causes, findings } = expand(packed);
  assert.deepEqual(causes.map((b) => b.key), packed.causes.map((b) => b.key));
  assert.deepEqual(findings.map((f) => f.id), packed.findings.map((f) => f.id));
});

test("a sentence has the largest margin of its cause", () => {
  const [b] = expand(sample()).causes;
  const of = (kind, margin, methods_of_kind = ["ode"]) => {
    const libraries_of_kind = new Set(methods_of_kind.map((name) => name.split("-")[0]));
    return sentenceOf({ ...b, kind, margin, methods_of_kind, libraries_of_kind: [...libraries_of_kind] });
  };
  assert.match(of("wrong_disjoint", [1e-9, 0.41]), /^ode reports \u201cdisjoint\u201d, .* up to about 0.41 of their/);
  assert.match(of("wrong_intersecting", [0, 31], ["ode", "fcl-indep"]), /^2 methods of 2 libraries report .* about 31 of/);
  assert.equal(of("wrong_disjoint", [0, 0]), "ode reports \u201cdisjoint\u201d, but the cylinders touch");
  assert.match(of("distance_outside", [0, Infinity], ["ode", "ode-unrefined"]), /^ode \(2 methods\) .* more than 1e308/);
});

test("an open end of a distance or a margin is beyond all", () => {
  const report = sample(),
    [{ id, case: at }] = report.findings;
  report.cases[at].truth.distance = ["-inf", -1.797e308];
  report.findings[0].margin = [0.5, "inf"];
  report.causes = [{ ...report.causes[0], margin: [1e-9, "inf"] }];
  const { findings, causes } = expand(report),
    f = findings.find((f) => f.id === id);
  assert.deepEqual([f.truth.distance, f.margin], [[-Infinity, -1.797e308], [0.5, Infinity]]);
  assert.deepEqual(causes[0].margin, [1e-9, Infinity]);
});

test("long numbers have exponents, and every digit", () => {
  assert.deepEqual([0.5, -0, 1e300, 123456].map(full), ["0.5", "-0", "1e+300", "123456"]);
  for (const x of [1 / 3, -1e5 / 3, 1e-9 / 7, Math.PI]) assert.equal(Number(full(x)), x);
  assert.equal(full(100 / 3), "33.333333333333336");
  assert.equal(full(1e9 / 3), "3.333333333333333e8");
  assert.equal(full(Math.PI), "3.141592653589793");
});

test("a shell reads a word as it is, and a reader sees all characters", () => {
  for (const text of ["plain/word", "", "two words", "o'hara", "$HOME `x` \\", "a\u202eb\u00017", "\u00e9 \u200b'\\"]) {
    const quoted = shellQuoted(text);
    assert.doesNotMatch(quoted, /[\u0000-\u001f\u200b-\u202e]/);
    assert.equal(spawnSync("bash", ["-c", `printf %s ${quoted}`], { encoding: "utf8" }).stdout, text);
  }
});

test("each word has one or two sentences", () => {
  for (const [word, sentence] of Object.entries(glossary)) {
    assert.equal(word, word.toLowerCase());
    assert.match(sentence, /^[A-Z][^.]*\.( [A-Z][^.]*\.)?$/, word);
  }
});

test("no point on the front is beaten in both", () => {
  const p = (ns, digits_low) => ({ ns, digits: 15, digits_low });
  const front = pareto([p(30, 9), p(10, 5), p(20, 5), p(20, 9), p(40, 3), p(50, 15), p(1, null)]);
  assert.deepEqual(front, [p(10, 5), p(20, 9), p(50, 15)]);
});

test("maps and curves separate a claim kept from one broken, and declined from undecided", () => {
  const cell = { y: 0, asked: 10, wrong_disjoint: 0, wrong_intersecting: 0, failed: 0, undecided: 0 };
  const axis = { title: "t", labels: ["0", "1"] };
  const cells = [
    { ...cell, x: 0, wrong_disjoint: 4, within_disjoint: 4 },
    { ...cell, x: 1, wrong_disjoint: 4, within_disjoint: 2, declined: 3 },
  ];
  const files = charts(expand({ ...sample(), maps: [{ method: "ode", plane: "angle-margin", x: axis, y: axis, cells }] }));
  const rects = files.get("map-angle-margin-ode").match(/<rect [^>]*aria-label="angle [^>]*>/g);
  assert.match(rects[0], /wrongly reported disjoint 4 \(40 %\)\nwithin the claim 4" fill="#68727d"/);
  assert.match(rects[1], /declined 3 \(30 %\)\nwithin the claim 2" fill="#8f1612"/);
  const said = files.get("calibration").match(/wrong \d+ of \d+/g);
  assert.deepEqual(said, ["wrong 8 of 17", "wrong 0 of 17"], "of its answers");
});

test("every plot is drawn as a whole SVG", () => {
  const files = charts(expand(sample())),
    names = [...files.keys()];
  assert.ok(files.has("map-angle-margin-ode") && files.has("calibration"), names.join());
  for (const [name, text] of files) {
    assert.ok(text.startsWith("<?xml") && text.trimEnd().endsWith("</svg>"), name);
    assert.ok(!/NaN|undefined|Infinity|var\(/.test(text), `${name} has a number or colour that is none`);
  }
  assert.match(files.get("speed-verdict"), /always right if the margin exceeds/);
  assert.equal(charts(expand(untriaged())).size, 0);
});
