// SPDX-License-Identifier: MIT
// What the page does with its data before it draws, and the charts, as built into the page.
//     node --test data_test.mjs
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { daylight } from "../chart.mjs";
import { sourcesHash } from "../stamp.mjs";
import { sample, untriaged } from "./sample.mjs";

const { causesOf, charts, expand, filterOf, filtered, full, glossary, isOrdinary, pareto, plainDocument } = daylight;
const { prove, queryOf, rowsOf, sentenceOf, shellQuoted } = daylight;
const filterBy = (query) => filterOf(new URLSearchParams(query));

test("the committed page was built from the committed sources", () => {
  const head = readFileSync(new URL("../page_template.html", import.meta.url), "utf8").slice(0, 400);
  assert.ok(head.includes(sourcesHash()), "page_template.html is older than its sources: run node build.mjs");
});

test("findings get back the pair, the answers and the command", () => {
  const packed = sample(),
    { findings } = expand(packed);
  for (const [i, f] of findings.entries()) {
    const of = packed.cases[packed.findings[i].case];
    assert.equal(f.replay, `./daylight replay runs/sample:${f.id}`);
    assert.deepEqual(f.pair, of.pair);
    assert.deepEqual(f.pair_margin, of.margin);
    assert.deepEqual(f.margin, packed.findings[i].margin);
    const [[answer]] = of.said.filter(([, who]) => who.some((n) => packed.names[n] === f.method));
    assert.deepEqual(f.answers[f.method], answer);
  }
  assert.ok(findings.some((f) => f.kind === "distance_outside" && f.margin[0] !== f.pair_margin[0]));
  packed.run.folder = "a b'c";
  assert.equal(expand(packed).findings[0].replay, `./daylight replay 'a b'\\''c:${findings[0].id}'`);
});

test("every certificate of the sample holds", () => {
  for (const f of expand(sample()).findings) assert.notEqual(prove(f.pair, f.truth).holds, false, f.id);
});

test("a filter is a text and a value for each facet", () => {
  const report = expand(sample()),
    rows = rowsOf(report),
    causes = causesOf(report);
  const found = (query) => filtered(rows, filterBy(query)).map(({ f }) => f.id).sort();
  const byHand = (passes) => report.findings.filter(passes).map((f) => f.id).sort();
  assert.deepEqual(found(""), byHand(() => true));
  for (const [query, passes] of [
    ["library=fcl&family=lattice", (f) => f.method.startsWith("fcl-") && f.family === "lattice"],
    ["severity=contract", (f) => f.severity === "contract"],
    ["text=Wrong+disjoint", (f) => f.kind === "wrong_disjoint"],
    ["text=wrong_disjoint++ode", (f) => f.kind === "wrong_disjoint" && f.method.startsWith("ode")],
    ["text=beyond+its+claim", (f) => f.severity === "contract"],
  ]) {
    assert.deepEqual(found(query), byHand(passes), query);
    assert.ok(found(query).length > 0, query);
  }
  const shown = filtered(causes, filterBy("standing=known&severity=contract")).map(({ b }) => b);
  assert.equal(shown.length, report.buckets.filter((b) => b.standing === "known" && b.severity === "contract").length);
  assert.equal(filtered(causes, filterBy("library=fcl")).every(({ b }) => b.methods.some((m) => /^fcl/.test(m))), true);
});

test("the address keeps the filter", () => {
  for (const query of ["", "severity=contract&library=ode&text=a+b"]) assert.equal(queryOf(filterBy(query)), query);
});

test("new causes come first, then those beyond a claim, then those of ordinary size, then the frequent", () => {
  const packed = sample();
  packed.buckets.forEach((b, i) => Object.assign(b, { standing: ["gone", "known", "rare", "back", "new"][i % 5] }));
  const ranked = causesOf(expand(packed)).map(({ b }) => b);
  const key = (b) => [
    ["new", "back", "rare", "known", "gone"].indexOf(b.standing),
    b.severity,
    !isOrdinary(b.simplest.pair),
    -b.count,
  ];
  for (let i = 1; i < ranked.length; ++i) {
    const [x, y] = [key(ranked[i - 1]), key(ranked[i])],
      at = x.findIndex((part, k) => part !== y[k]);
    assert.ok(at < 0 || x[at] < y[at], `${x} before ${y}`);
  }
});

test("findings beyond a claim come first, then those of ordinary size, then those wrong by more", () => {
  const rows = rowsOf(expand(sample()));
  const rank = ({ f }) => [["contract", "resolution"].indexOf(f.severity), !isOrdinary(f.pair), -f.margin[0]];
  for (let i = 1; i < rows.length; ++i) {
    const [x, y] = [rank(rows[i - 1]), rank(rows[i])],
      at = x.findIndex((part, k) => part !== y[k]);
    assert.ok(at < 0 || x[at] < y[at], `${x} before ${y}`);
  }
  const solid = (x, radius) => ({ center: [x, 0, 0], axis: [0, 0, 1], radius, height: 2 * radius });
  assert.ok(isOrdinary({ a: solid(0, 1), b: solid(3, 1) }));
  for (const [x, radius] of [
    [0, 1e4],
    [0, 1e-5],
    [1e3, 1],
    [1e308, 1e308],
  ])
    assert.ok(!isOrdinary({ a: solid(0, 1e-5), b: solid(x, radius) }));
});

test("a sentence has the largest margin of its cause", () => {
  const [b] = expand(sample()).buckets;
  const of = (kind, margin, methods_of_kind = ["ode"]) => sentenceOf({ ...b, kind, margin, methods_of_kind });
  assert.equal(of("wrong_disjoint", [1e-9, 0.41]), "ode reports cylinders as disjoint that overlap by up to about 0.41 of their size");
  assert.match(of("wrong_intersecting", [0, 31], ["ode", "fcl-indep"]), /^2 methods of 2 libraries report .* up to about 31 of/);
  assert.equal(of("wrong_disjoint", [0, 0]), "ode reports cylinders as disjoint that touch");
  assert.match(of("distance_outside", [0, Infinity], ["ode", "ode-unrefined"]), /^ode \(2 methods\) returns .* more than 1e308/);
});

test("an open end of a distance or a margin is beyond all", () => {
  const report = sample();
  report.cases[report.findings[0].case].truth.distance = ["-inf", -1.797e308];
  report.findings[0].margin = [0.5, "inf"];
  report.buckets[0].margin = [1e-9, "inf"];
  const { findings, buckets } = expand(report);
  assert.deepEqual(findings[0].truth.distance, [-Infinity, -1.797e308]);
  assert.deepEqual(findings[0].margin, [0.5, Infinity]);
  assert.deepEqual(buckets[0].margin, [1e-9, Infinity]);
});

test("long numbers have exponents, and every digit", () => {
  assert.deepEqual([0.5, -0, 1e300, 123456].map(full), ["0.5", "-0", "1e+300", "123456"]);
  for (const x of [1 / 3, -1e5 / 3, 1e-9 / 7, Math.PI]) assert.equal(Number(full(x)), x);
  assert.equal(full(100 / 3), "33.333333333333336");
  assert.equal(full(1e9 / 3), "3.333333333333333e8");
  assert.equal(full(Math.PI), "3.141592653589793");
});

test("a shell reads a word as it is, and a reader sees all of it", () => {
  for (const text of ["plain/word", "", "two words", "o'hara", "$HOME `x` \\", "a\u202eb\u00017", "\u00e9 \u200b'\\"]) {
    const quoted = shellQuoted(text);
    assert.doesNotMatch(quoted, /[\u0000-\u001f\u200b-\u202e]/);
    assert.equal(spawnSync("bash", ["-c", `printf %s ${quoted}`], { encoding: "utf8" }).stdout, text);
  }
});

test("each word has one sentence", () => {
  for (const [word, sentence] of Object.entries(glossary)) {
    assert.equal(word, word.toLowerCase());
    assert.match(sentence, /^[A-Z][^.]*\.$/, word);
  }
});

test("nobody on the front is beaten in both", () => {
  const p = (ns, digits_low) => ({ ns, digits: 15, digits_low });
  assert.deepEqual(pareto([p(30, 9), p(10, 5), p(20, 5), p(20, 9), p(40, 3), p(50, 15), p(1, null)]), [
    p(10, 5),
    p(20, 9),
    p(50, 15),
  ]);
});

test("maps and curves tell a claim kept from one broken, and declined from undecided", () => {
  const cell = { y: 0, asked: 10, wrong_disjoint: 0, wrong_intersecting: 0, failed: 0, undecided: 0 };
  const [x, y] = [2, 1].map((n) => ({ title: "t", labels: Array.from({ length: n }, (_, i) => `${i}`) }));
  const cells = [
    { ...cell, x: 0, wrong_disjoint: 4, within_disjoint: 4 },
    { ...cell, x: 1, wrong_disjoint: 4, within_disjoint: 2, declined: 3 },
  ];
  const bin = { decade: 0, asked: 100, wrong_disjoint: 2, wrong_intersecting: 0, undecided: 0, declined: 60 };
  const report = {
    ...sample(),
    maps: [{ method: "ode", plane: "scale-offset", x, y, cells }],
    honesty: [{ method: "ode", family: null, bins: [bin, { ...bin, decade: 1, wrong_disjoint: 0, declined: 100 }] }],
  };
  const files = charts(expand(report), plainDocument());
  const rects = files.get("map-scale-offset-ode").match(/<rect [^>]*aria-label="t: [^>]*>/g);
  assert.match(rects[0], /^<rect [^>]*fill="#68727d" [^>]*wrongly reported disjoint 4 \(40 %\), 4 of them within its claim"/);
  assert.match(rects[1], /^<rect [^>]*fill="#8f1612" [^>]*, 2 of them within its claim\ndeclined 3 \(30 %\)"/);
  const said = files.get("honesty").match(/wrong \d+ of \d+/g);
  assert.deepEqual(said, ["wrong 2 of 40", "wrong 0 of 40"], "of those it answered");
});

test("a map of what only one library has wrong leaves out the cells of others", () => {
  const cell = (x, wrong_disjoint, within_disjoint = 0) => ({ x, y: 0, asked: 9, wrong_disjoint, within_disjoint });
  const of = (method, cells) =>
    ({ method, plane: "scale-offset", cells: cells.map((c) => ({ ...c, wrong_intersecting: 0, failed: 0 })) });
  const mine = of("fcl-libccd", [cell(0, 2), cell(1, 2), cell(2, 0), cell(3, 2)]);
  const all = [mine, of("fcl-indep", [cell(0, 1)]), of("ode", [cell(1, 1), cell(2, 1), cell(3, 1, 1)])];
  assert.deepEqual(daylight.onlyHere(mine, all).cells.map((c) => c.x), [0, 2, 3]);
});

test("every plot is drawn as a whole SVG", () => {
  const files = charts(expand(sample()), plainDocument()),
    names = [...files.keys()];
  for (const name of ["families", "speed-verdict-all", "map-angle-margin-ode", "honesty"])
    assert.ok(files.has(name), `${name} among ${names}`);
  assert.ok(names.some((name) => name.startsWith("path-touching")), names.join());
  for (const [name, text] of files) {
    assert.ok(text.startsWith("<?xml") && text.trimEnd().endsWith("</svg>"), name);
    assert.ok(!/NaN|undefined|Infinity|var\(/.test(text), `${name} has a number or colour that is none`);
  }
  assert.match(files.get("speed-verdict-all"), /right down to a margin of/);
  assert.deepEqual([...charts(expand(untriaged()), plainDocument()).keys()], ["families"]);
});

test("the axis of a path is logarithmic, has a unit and a tick for decades", () => {
  const svg = [...charts(expand(sample()), plainDocument())].find(([name]) => /path-touching_/.test(name))[1];
  assert.match(svg, /gap \(overlap below 0\), part of the size, logarithmic/);
  assert.ok(svg.match(/>\u2212?[13]e-\d+</g).length >= 4, "ticks");
});
