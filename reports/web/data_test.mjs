// SPDX-License-Identifier: MIT
// What the page does with its data before it draws, and the charts, as built into the page.
//     node --test data_test.mjs
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import {
  chip_counts,
  charts,
  expand,
  filter_of,
  filtered,
  pareto,
  plain_document,
  prove,
  rows_of,
  sorted,
} from "./chart.mjs";
import { sample } from "./sample.mjs";
import { sources_hash } from "./stamp.mjs";

test("the committed page was built from the committed sources", () => {
  const head = readFileSync(new URL("page_template.html", import.meta.url), "utf8").slice(0, 400);
  assert.ok(head.includes(sources_hash()), "page_template.html is older than its sources: run node build.mjs");
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
  const rows = rows_of(expand(sample(400)));
  const filter = filter_of(new URLSearchParams("kind=crash&library=ode&library=fcl"));
  const shown = filtered(rows, filter),
    by_hand = rows.filter((r) => r.f.kind === "crash" && /^(ode|fcl)/.test(r.f.method));
  assert.ok(by_hand.length > 0 && by_hand.length < 100);
  assert.deepEqual(shown, by_hand);
  const counts = chip_counts(rows, filter);
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
    filtered(rows, filter_of(new URLSearchParams("method=fcl-libccd"))).every((r) => r.f.method === "fcl-libccd"),
    true,
  );
});

test("sorting is stable, and failures sort by severity first", () => {
  const rows = rows_of(expand(sample(400)));
  const up = sorted(rows, { column: "kind", down: false });
  for (let i = 1; i < up.length; ++i)
    assert.ok(up[i - 1].f.kind < up[i].f.kind || (up[i - 1].f.kind === up[i].f.kind && up[i - 1].f.id < up[i].f.id));
  const down = sorted(rows, { column: "margin", down: true });
  for (let i = 1; i < down.length; ++i) assert.ok(down[i - 1].margin >= down[i].margin);
});

test("nobody on the front is beaten in both", () => {
  const p = (ns, digits) => ({ ns, digits });
  assert.deepEqual(pareto([p(30, 9), p(10, 5), p(20, 5), p(20, 9), p(40, 3), p(50, 15), p(1, null)]), [
    p(10, 5),
    p(20, 9),
    p(50, 15),
  ]);
});

test("every plot is drawn as a whole SVG", () => {
  const files = charts(expand(sample(40)), plain_document());
  for (const name of [
    "families",
    "speed-verdict-all",
    "speed-certificate-all",
    "wrong-verdict-random",
    "map-angle-margin-ode",
    "map-scale-offset-intersect",
    "honesty",
    "cost",
    "backward",
    "path-through_touching-intersect",
  ])
    assert.ok(files.has(name), `${name} among ${[...files.keys()].slice(0, 8)}`);
  for (const [name, text] of files) {
    assert.ok(text.startsWith("<?xml") && text.trimEnd().endsWith("</svg>"), name);
    assert.ok(!/NaN|undefined|Infinity|var\(/.test(text), `${name} has a number or colour that is none`);
  }
  const empty = { ...sample(1), maps: [], honesty: [], speed: [], cost: [], paths: [], backward: [] };
  assert.deepEqual([...charts(expand(empty), plain_document()).keys()], ["families"]);
});
