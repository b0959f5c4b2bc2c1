// SPDX-License-Identifier: MIT
// What the page does with its data before it draws, and the charts, as built into the page.
//     node --test data_test.mjs
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { daylight } from "../chart.mjs";
import { sample } from "./sample.mjs";
import { sourcesHash } from "../stamp.mjs";

const { causesOf, chipCounts, charts, csvCell, csvOf, expand, filterOf, filtered, filteredCauses, full } = daylight;
const { glossary, logGamma, pareto, plainDocument, prove, queryOf, rowsOf, sameRateProbability } = daylight;
const { shellQuoted, sorted, isOrdinary, sortedCauses, worstFirst, viewOf, wrongDistance } = daylight;

test("the committed page was built from the committed sources", () => {
  const head = readFileSync(new URL("../page_template.html", import.meta.url), "utf8").slice(0, 400);
  assert.ok(head.includes(sourcesHash()), "page_template.html is older than its sources: run node build.mjs");
});

test("findings get back the pair, the answers and the command", () => {
  const report = expand(sample(9)),
    f = report.findings[5];
  assert.equal(f.id, 6);
  assert.equal(f.replay, "./daylight replay runs/sample:6");
  assert.equal(f.answers["fcl-libccd"].verdict, f.truth.verdict === "disjoint" ? "intersecting" : "disjoint");
  assert.deepEqual(f.answers.ode, { failed: "crash", reason: "SIGABRT" });
  assert.equal(f.answers["bullet-cylinder"], undefined);
  assert.equal(report.findings[4].pair, f.pair);
  const quoted = sample(1);
  quoted.run.folder = "a b'c";
  assert.equal(expand(quoted).findings[0].replay, "./daylight replay 'a b'\\''c:1'");
});

test("every certificate of the sample holds", () => {
  for (const f of expand(sample(200)).findings) assert.equal(prove(f.pair, f.truth).holds, true);
});

test("chips filter and count", () => {
  const rows = rowsOf(expand(sample(400)));
  const filter = filterOf(new URLSearchParams("kind=crash&library=ode&library=fcl"));
  const shown = filtered(rows, filter),
    byHand = rows.filter((r) => r.f.kind === "crash" && /^(ode|fcl)/.test(r.f.method));
  assert.ok(byHand.length > 0 && byHand.length < 100);
  assert.deepEqual(shown, byHand);
  const counts = chipCounts(rows, filter);
  assert.equal(counts.library.get("ode") + counts.library.get("fcl"), shown.length);
  assert.equal(
    counts.library.get("bullet"),
    rows.filter((r) => r.f.kind === "crash" && r.f.method.startsWith("bullet")).length,
    "what the chip would add",
  );
  assert.equal(
    [...counts.severity.values()].reduce((n, c) => n + c),
    shown.length,
  );
  assert.equal(
    filtered(rows, filterOf(new URLSearchParams("method=fcl-libccd"))).every((r) => r.f.method === "fcl-libccd"),
    true,
  );
});

test("sorting is stable, and failures sort by severity first", () => {
  const rows = rowsOf(expand(sample(400)));
  const up = sorted(rows, { column: "kind", down: false });
  for (let i = 1; i < up.length; ++i)
    assert.ok(up[i - 1].f.kind < up[i].f.kind || (up[i - 1].f.kind === up[i].f.kind && up[i - 1].f.id < up[i].f.id));
  const down = sorted(rows, { column: "margin", down: true });
  for (let i = 1; i < down.length; ++i) assert.ok(down[i - 1].margin >= down[i].margin);
});

test("equal rows: those of ordinary size first, then those wrong by more", () => {
  const rows = rowsOf(expand(sample(400)));
  for (const [i, row] of rows.entries()) row.ordinary = i % 3 > 0;
  const shown = worstFirst(rows);
  for (let i = 1; i < shown.length; ++i) {
    const [x, y] = [shown[i - 1], shown[i]];
    assert.ok(x.ordinary > y.ordinary || (x.ordinary === y.ordinary && x.margin >= y.margin));
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

test("a search finds words as they are displayed, all of them", () => {
  const rows = rowsOf(expand(sample(400)));
  const found = (text) => filtered(rows, filterOf(new URLSearchParams({ text }))).map((r) => r.f.id);
  const byHand = (passes) => rows.filter(({ f }) => passes(f)).map((r) => r.f.id);
  const disjoint = byHand((f) => f.kind === "wrong_disjoint");
  assert.deepEqual(found("wrong disjoint"), disjoint);
  assert.deepEqual(found("wrong_disjoint"), disjoint);
  assert.deepEqual(
    found("Beyond its claim"),
    byHand((f) => f.severity === "contract"),
  );
  assert.deepEqual(
    found("#17"),
    byHand((f) => String(f.id).startsWith("17")),
  );
  assert.deepEqual(
    found("crash ode"),
    byHand((f) => f.kind === "crash" && f.method === "ode"),
  );
});

test("a cause is shown with its findings, one without them by what it says of itself", () => {
  const report = expand(sample(400)),
    rows = rowsOf(report),
    causes = causesOf(report);
  const shown = (query) => {
    const filter = filterOf(new URLSearchParams(query));
    return filteredCauses(causes, filtered(rows, filter), filter).map(({ b }) => b);
  };
  assert.equal(shown("").length, causes.length);
  assert.deepEqual(
    shown("standing=gone").map((b) => b.key),
    ["panda/wrong_intersecting/cap-rim/scale"],
  );
  assert.equal(shown("standing=gone&kind=crash").length, 0);
  assert.equal(shown("library=panda&kind=wrong_intersecting&text=scale").length, 1);
  const crashes = shown("kind=crash");
  assert.ok(crashes.length > 0 && crashes.every((b) => b.kind === "crash"));
  assert.equal(rows[0].standing, report.buckets.find((b) => b.key === rows[0].f.bucket).standing);
});

test("new causes come first, then those beyond a claim, then those of ordinary size, then the frequent", () => {
  const ranked = sortedCauses(causesOf(expand(sample(400))), { column: "standing", down: false }).map(({ b }) => b);
  const key = (b) => [
    ["new", "back", "known", "rare", "gone"].indexOf(b.standing),
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

test("the address keeps what is shown", () => {
  for (const query of ["", "kind=crash&kind=bad_witness&library=ode&method=ode&text=a+b&sort=-margin&causes=count"])
    assert.equal(queryOf(viewOf(new URLSearchParams(query))), query);
  assert.deepEqual(viewOf(new URLSearchParams("sort=nothing")).order, { column: "severity", down: false });
});

test("a finding has its own margin and that of its pair", () => {
  const packed = sample(400),
    { findings } = expand(packed);
  for (const [i, f] of findings.entries()) {
    assert.deepEqual(f.margin, packed.findings[i].margin);
    assert.deepEqual(f.pair_margin, packed.cases[packed.findings[i].case].margin);
  }
  assert.ok(findings.some((f) => f.kind === "distance_outside" && f.margin[0] !== f.pair_margin[0]));
});

test("a wrong distance is measured against the proved one, the size and the claim", () => {
  const solid = { center: [0, 0, 0], axis: [0, 0, 1], radius: 1, height: 1 };
  const of = (said, verdict = "disjoint") =>
    wrongDistance(
      { pair: { a: solid, b: solid }, truth: { verdict, distance: [1, 1.25] } },
      { distance: said },
      { relative: 0.125, absolute: 0.5, source: "" },
    );
  assert.equal(of(1.125).error, 0);
  assert.deepEqual([of(3.25).error, of(3.25).relative, of(3.25).claims], [2, 0.5, 2]);
  assert.equal(of(0.5).error, 0.5);
  assert.equal(of(0.5, "touching").error, 0.5);
  assert.equal(of(undefined), null);
});

test("a claim allows no less than the judge does", () => {
  const of = (scale, said, absolute) => {
    const solid = { center: [0, 0, 0], axis: [0, 0, 1], radius: scale, height: scale };
    const pair = { a: solid, b: solid },
      truth = { verdict: "disjoint", distance: [0, 0] };
    return wrongDistance({ pair, truth }, { distance: said }, { relative: 0, absolute, source: "" }).allowed;
  };
  assert.deepEqual(of(1, 5, 1e-6), { length: 4e-13 + 1e-6, by: "claim" });
  assert.deepEqual(of(1e9, 5, 1e-6), { length: 4e-4 + 1e-6, by: "size" });
  assert.deepEqual(of(1, 2 ** 60, 1e-6), { length: 2 ** 10, by: "distance" });
  assert.deepEqual(of(1, 0, 0), { length: 2 ** -48, by: "distance" });
});

test("an open end of a distance or a margin is beyond all", () => {
  const report = sample(9);
  report.cases[0].truth.distance = ["-inf", -1.797e308];
  report.findings[0].margin = [0.5, "inf"];
  report.buckets[0].margin = [1e-9, "inf"];
  const { findings, buckets } = expand(report);
  assert.deepEqual(findings[0].truth.distance, [-Infinity, -1.797e308]);
  assert.deepEqual(findings[0].margin, [0.5, Infinity]);
  assert.deepEqual(buckets[0].margin, [1e-9, Infinity]);
  assert.match(csvOf(rowsOf(expand(report)), expand(report)), /,0.5,inf,\w+,-inf,-1.797e\+308,/);
});

test("two counts under one rate", () => {
  for (const [x, value] of [
    [1, 0],
    [2, 0],
    [0.5, Math.log(Math.PI) / 2],
    [11, Math.log(3628800)],
    [171, 706.5730622457874],
  ])
    assert.ok(Math.abs(logGamma(x) - value) <= 1e-13 * Math.max(1, value), `of ${x}`);
  const near = (p, value) => assert.ok(Math.abs(p - value) <= 1e-9 * value, `${p} is not ${value}`);
  near(sameRateProbability(0, 100, 5, 100), 2 / 32);
  near(sameRateProbability(5, 100, 5, 100), 1);
  near(sameRateProbability(1, 10, 9, 10), 22 / 1024);
  near(sameRateProbability(0, 10, 0, 10), 1);
  near(sameRateProbability(3, 100, 0, 300), 1 / 64); // of 3, each falls to the first with 1/4
  near(sameRateProbability(0, 100, 3, 300), 1); // 27/64 is the likeliest, with one of three
  assert.equal(sameRateProbability(1, 0, 1, 5), null);
  assert.ok(sameRateProbability(1000, 1e6, 1010, 1e6) > 0.5);
});

test("cells of a table are quoted, and none is a formula", () => {
  assert.equal(csvCell("plain"), "plain");
  assert.equal(csvCell('a "b", c'), '"a ""b"", c"');
  assert.equal(csvCell("two\nlines"), '"two\nlines"');
  for (const sign of ["=", "+", "-", "@"]) assert.equal(csvCell(`${sign}1`), `'${sign}1`);
  assert.equal(csvCell('=HYPERLINK("x")'), '"\'=HYPERLINK(""x"")"');
  assert.deepEqual([-0.1, 1e-300, -0, 0.1 + 0.2].map(csvCell), ["-0.1", "1e-300", "-0", "0.30000000000000004"]);
  assert.deepEqual([null, undefined].map(csvCell), ["", ""]);
  const report = expand(sample(40)),
    lines = csvOf(rowsOf(report), report).split("\r\n");
  assert.equal(lines.length, 42);
  assert.equal(lines[0].split(",").length, 32);
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
    ...sample(1),
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
  const files = charts(expand(sample(40)), plainDocument());
  for (const name of [
    "families",
    "speed-verdict-all",
    "speed-certificate-all",
    "map-angle-margin-ode",
    "map-scale-offset-intersect",
    "honesty",
    "cost",
    "path-through_touching-intersect",
  ])
    assert.ok(files.has(name), `${name} among ${[...files.keys()].slice(0, 8)}`);
  for (const [name, text] of files) {
    assert.ok(text.startsWith("<?xml") && text.trimEnd().endsWith("</svg>"), name);
    assert.ok(!/NaN|undefined|Infinity|var\(/.test(text), `${name} has a number or colour that is none`);
  }
  const empty = { ...sample(1), maps: [], honesty: [], speed: [], cost: [], paths: [] };
  assert.deepEqual([...charts(expand(empty), plainDocument()).keys()], ["families"]);
});
