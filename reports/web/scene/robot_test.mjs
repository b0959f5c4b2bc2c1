// SPDX-License-Identifier: MIT
// A reader of the robots on the pages of scenes: moves their joints, reads gaps, proofs, words and the CSV. What the
// page computes itself is held against what the executable wrote.
//     node study_robot_test.mjs PAGE.html ..     of several robots; those of crane.urdf and arm.urdf with --prove
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { basename, join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import {
  asked,
  browser,
  colours,
  dataOf,
  errors,
  filled,
  folder,
  open,
  settled,
  solverModule,
  withoutWebgl,
} from "../browser.mjs";
import { daylight } from "../chart.mjs";
import { assertContrast } from "../contrast.mjs";

const { csvOfStudy, freeJoints, gap, gapsOf, jointValues, placed, riskOf, studyRowsOf } = daylight;

await daylight.bringSolver(solverModule);

const pages = process.argv
  .slice(2)
  .map((file) => ({ address: pathToFileURL(resolve(file)).href, study: dataOf(file) }));
const pageOf = (name) => pages.find(({ study }) => basename(study.file) === name);

const told = async (page, name) => (
  await settled(page),
  page.evaluate((key) => new URLSearchParams(location.hash.slice(1)).get(key), name)
);
const shown = (x, digits = 3) => Number(x.toPrecision(digits)).toString().replace("-", "\u2212");

/** Every solid and box of every kept configuration, from the joints' values alone: to 1e-9. */
function movesRobotsAsTheExecutableDoes() {
  const kinds = new Set();
  let compared = 0;
  const same = (x, y, what) => {
    for (const [i, value] of x.entries()) assert.ok(Math.abs(value - y[i]) < 1e-9, `${what}: ${x} and ${y}`);
    compared += 1;
  };
  for (const { study } of pages) {
    for (const link of study.links) kinds.add(link.follows ? "follows" : link.motion);
    for (const kept of study.kept) {
      const { cylinders, boxes } = placed(study.links, study.bodies, jointValues(study.links, kept.joints));
      assert.deepEqual([cylinders.length, boxes.length], [kept.cylinders.length, kept.boxes.length]);
      for (const [i, c] of kept.cylinders.entries()) {
        same(c.center, cylinders[i].center, `${study.file}, ${study.bodies[i].name}`);
        same(c.axis, cylinders[i].axis, `${study.file}, ${study.bodies[i].name}`);
      }
      for (const [i, { body, center, axes }] of kept.boxes.entries()) {
        assert.equal(boxes[i].body, body);
        for (const [x, y] of [[center, boxes[i].center], ...axes.map((axis, k) => [axis, boxes[i].axes[k]])])
          same(x, y, `${study.file}, box of ${study.bodies[body].name}`);
      }
    }
  }
  assert.deepEqual([...kinds].sort(), ["fixed", "follows", "held", "slide", "turn"]);
  assert.ok(compared > 1000, `compared ${compared}`);
}

/** Apart or overlapping, rounded or not: the same doubles, and the nearest points are as far apart as they say. */
function measuresGapsAsTheExecutableDoes() {
  const seen = { apart: 0, overlapping: 0, rounded: 0 };
  for (const { study } of pages)
    for (const kept of study.kept)
      for (const [i, pair] of kept.pairs.entries()) {
        const [a, b] = study.pairs[i].bodies.map((body) => kept.cylinders[body]),
          found = gap(a, b),
          what = `${study.file}, ${study.pairs[i].a} and ${study.pairs[i].b}`;
        assert.equal(found.distance, pair.distance, what);
        const way = Math.hypot(...found.on_a.map((x, k) => x - found.on_b[k]));
        assert.ok(Math.abs(way - Math.abs(found.distance)) < 1e-9, `${what}: points ${way} apart`);
        seen[found.distance < 0 ? "overlapping" : "apart"] += 1;
        if (a.rounding || b.rounding) seen.rounded += 1;
      }
  assert.ok(seen.apart > 1000 && seen.overlapping > 30 && seen.rounded > 300, JSON.stringify(seen));
}

/** No gap within the clearance is left out to save time, nor the least one. */
function leavesNoNearPairOut() {
  let spared = 0;
  for (const { study } of pages)
    for (const kept of study.kept) {
      const least = Math.min(...kept.pairs.map(({ distance }) => distance)),
        clearance = 0.02;
      const found = gapsOf(
        kept.cylinders,
        study.pairs.map(({ bodies }) => bodies),
        clearance,
        1,
      );
      for (const [i, { distance }] of kept.pairs.entries()) {
        assert.ok(found[i] !== null || distance > Math.max(clearance, least), `${study.file}, pair ${i}: ${distance}`);
        spared += found[i] === null ? 1 : 0;
      }
    }
  assert.ok(spared > 100, `${spared} spared`);
}

/** Worst first, and every pair is there. */
function sortsPairsByRisk() {
  const order = ["comes within", "open", "not known", "not seen within", "never within"],
    met = new Set();
  // Where some pairs were not asked to be proved, all states are met in one table.
  const mixed = { ...arm.study, motions: arm.study.motions.filter((_, i) => i % 3 > 0) };
  for (const study of [...pages.map((page) => page.study), mixed]) {
    const rows = studyRowsOf(study, { models: new Set(), text: "" }, { column: "risk", down: false });
    assert.equal(new Set(rows).size, study.pairs.length, study.file);
    const worth = rows.map((i) => {
      const { known, within, least_distance, bodies } = study.pairs[i];
      const proof = study.motions?.find((p) => p.bodies.join() === bodies.join());
      const risk =
        proof?.verdict === "refuted" || proof?.verdict === "within" || (known && within > 0)
          ? "comes within"
          : proof
            ? { open: "open", never: "never within" }[proof.verdict]
            : known
              ? "not seen within"
              : "not known";
      assert.equal(riskOf(study, i), risk);
      met.add(risk);
      return [order.indexOf(risk), Math.min(least_distance, proof?.least_seen ?? Infinity)];
    });
    for (const [k, [risk, least]] of worth.slice(1).entries()) {
      const [before, nearer] = worth[k];
      assert.ok(before < risk || (before === risk && nearer <= least), study.file);
    }
  }
  assert.deepEqual([...met].sort(), [...order].sort(), "each is met");
  const ofMixed = new Set(mixed.pairs.map((_, i) => riskOf(mixed, i)));
  assert.ok(ofMixed.has("open") && ofMixed.has("not known"), [...ofMixed].join());
}

/** RFC 4180, read by its own grammar. */
function readCsv(text) {
  const rows = [[]];
  for (const [, quoted, plain, end] of text.matchAll(/(?:"((?:[^"]|"")*)"|([^",\r\n]*))(,|\r\n)/g)) {
    rows.at(-1).push(quoted === undefined ? plain : quoted.replaceAll('""', '"'));
    if (end === "\r\n") rows.push([]);
  }
  assert.deepEqual(rows.pop(), [], "ends with a line break");
  return rows;
}

function writesACsvThatHolds() {
  const study = structuredClone(pageOf("crane.urdf").study);
  Object.assign(study.pairs[0], { a: '=HYPERLINK("x"),1', b: "-2\r\n+3" });
  const here = study.pairs.map((_, i) => (i === 1 ? null : 0.25));
  const [head, ...rows] = readCsv(
    csvOfStudy(
      study,
      study.pairs.map((_, i) => i),
      here,
    ),
  );
  assert.equal(rows.length, study.pairs.length);
  assert.ok(rows.every((row) => row.length === head.length));
  const cell = (i, name) => rows[i][head.indexOf(name)];
  assert.equal(cell(0, "a"), `'=HYPERLINK("x"),1`, "no spreadsheet takes a name for a formula");
  assert.equal(cell(0, "b"), "'-2\r\n+3");
  assert.deepEqual([cell(0, "gap_here [m]"), cell(1, "gap_here [m]")], ["0.25", ""]);
  for (const [i, pair] of study.pairs.entries()) {
    assert.equal(Number(cell(i, "sphere_false_alarm [m]")), pair.models[0].false_alarm);
    assert.equal(cell(i, "proved"), study.motions[i].verdict);
    assert.ok(Number(cell(i, "least_gap [m]")) <= pair.least_distance);
  }
}

const status = async (page) => (await settled(page), page.locator(".near [role=status]").innerText());

/** What stands within the clearance at these values, in the words of the page. */
function nearAt(study, values) {
  const { cylinders } = placed(study.links, study.bodies, jointValues(study.links, values));
  return study.pairs.flatMap(({ a, b, bodies: [i, j] }) => {
    const { distance } = gap(cylinders[i], cylinders[j]);
    return distance <= study.clearance ? [{ names: `${a} \u2013 ${b}`, distance }] : [];
  });
}

async function movesJoints({ address, study }) {
  const page = await open(address);
  const free = freeJoints(study.links).map((link) => study.links[link]);
  const names = await page.locator(".joint .name").allInnerTexts();
  assert.deepEqual(
    names,
    free.map(({ joint }) => joint),
  );
  const before = await colours(page),
    kept = await page.locator(".near li").allInnerTexts();
  const values = { ...study.kept[0].joints };
  for (const [i, { joint, motion, limits }] of free.entries()) {
    const slider = page.getByRole("slider", { name: joint, exact: true });
    await slider.focus();
    await page.keyboard.press(i % 2 ? "Home" : "End");
    values[joint] = limits[i % 2 ? 0 : 1];
    await settled(page);
    const words = await page.locator(".joint .value").nth(i).innerText(),
      value = motion === "turn" ? `${shown((values[joint] * 180) / Math.PI, 4)}\u00b0` : `${shown(values[joint])} m`;
    assert.equal(words, value, joint);
  }
  assert.notEqual((await colours(page)).hash, before.hash, "the robot moves");
  const near = nearAt(study, values);
  const lines = await page.locator(".near li.bad").allInnerTexts();
  assert.equal(lines.length, near.length);
  for (const { names: pair, distance } of near)
    assert.ok(
      lines.some((l) => l.startsWith(pair) && (distance >= 0 || l.includes(`overlap by ${shown(-distance)} m`))),
      `${pair} ${distance}: ${lines}`,
    );
  assert.match(await status(page), new RegExp(`^${near.length === 0 ? "None of the" : `${near.length} of`} ${study.pairs.length} checked pairs (is|are) within the clearance here`));
  for (const { joint, follows } of study.links.filter((link) => link.follows)) {
    const value = follows.multiplier * values[study.links[follows.link].joint] + follows.offset;
    assert.ok((await page.locator(".joints").innerText()).includes(`${joint} follows`), joint);
    assert.ok((await page.locator(".joints").innerText()).includes(`: ${shown(value)} m`), `${joint} ${value}`);
  }
  const there = (await told(page, "joints")).split(",").map(Number);
  there.forEach((x, i) => assert.ok(Math.abs(x - values[free[i].joint]) < 1e-9));
  const again = await open(page.url());
  assert.deepEqual(await again.locator(".near li").allInnerTexts(), await page.locator(".near li").allInnerTexts());
  await again.context().close();
  await page.getByRole("button", { name: "Back to the sampled configuration" }).click();
  assert.deepEqual((await settled(page), await page.locator(".near li").allInnerTexts()), kept);
  assert.equal((await colours(page)).hash, before.hash);
  await page.context().close();
  return near.map(({ distance }) => distance);
}

function withClearance({ study }, clearance) {
  const file = join(folder, "wide.html");
  writeFileSync(file, filled({ ...study, clearance }));
  return { address: pathToFileURL(file).href, study: { ...study, clearance } };
}

/** The button of a proof sets the sliders to where the referee refuted it: there the pair is within the clearance. */
async function showsWhatIsRefuted({ address, study }) {
  const refuted = study.motions.findIndex(({ verdict }) => verdict === "refuted"),
    proof = study.motions[refuted],
    pair = study.pairs.findIndex(({ bodies }) => bodies.join() === proof.bodies.join());
  const page = await open(address);
  await page.goto(`${address}#at=0&pair=${pair}`); // at once, before the page has drawn all of itself
  await page.reload();
  assert.equal(await told(page, "pair"), String(pair), "the address stays as it was given");
  assert.match(await page.locator(".picked p.bad").innerText(), /^Proof over all motions: refuted, /);
  await page.locator(".picked").getByRole("button", { name: /^Show where/ }).click();
  assert.ok((await status(page)).includes("within the clearance here"));
  const near = await page.locator(".near li.bad").allInnerTexts();
  assert.ok(near.some((line) => line.startsWith(`${proof.a} \u2013 ${proof.b}`)));
  const values = (await told(page, "joints")).split(",").map(Number);
  for (const [i, link] of freeJoints(study.links).entries()) {
    const { joint } = study.links[link];
    if (joint in proof.joints) assert.equal(values[i], proof.joints[joint], joint);
  }
  const states = await page.locator(".findings tbody td.c-risk").allInnerTexts();
  assert.ok(states[0].startsWith("comes within\nrefuted,"), states[0]);
  const never = study.motions.filter(({ verdict }) => verdict === "never");
  assert.ok(never.some(({ bound }) => states.some((s) => s.includes(`proved: more than ${shown(bound)} m`))));
  const rows = await page.locator(".exemptions tbody tr").allInnerTexts();
  assert.equal(rows.length, study.exemptions.length);
  for (const { link1, link2, verdict } of study.exemptions)
    assert.ok(rows.some((row) => row.includes(link1) && row.includes(link2) && row.includes(verdict)));
  await page.context().close();
}

/** A pair that the SRDF exempts is no row of the table, and is computed all the same where its button leads. */
async function computesWhatIsExempt({ address, study }) {
  const page = await open(address);
  const worst = study.exemptions[0].pairs.reduce((p, q) => (p.least_seen <= q.least_seen ? p : q));
  assert.ok(!study.pairs.some(({ bodies }) => bodies.join() === worst.bodies.join()), "it is exempt");
  await page.locator(".exemptions").getByRole("button", { name: /^Show/ }).first().click();
  const text = (await page.locator(".exempt").innerText()).replace(/\s+/g, " ");
  assert.ok(text.includes(`${worst.a} \u2013 ${worst.b}, not among the ${study.pairs.length} checked pairs: `), text);
  assert.ok(text.includes(`here they are ${shown(worst.least_seen)} m apart`), text);
  await page.locator(".near li button").first().click();
  assert.equal(await page.locator(".exempt").count(), 0, "another pair is picked");
  await page.context().close();
}

/** A word that heads a column, names a model or says a state stands in the list at the end. */
async function tellsItsWords({ address }) {
  const page = await open(`${address}#at=0&pair=0`);
  await page.waitForSelector(".picked");
  const listed = new Set(await page.locator("#words dt").allTextContents());
  const words = await page.evaluate(() => [
    ...[...document.querySelectorAll("#page th, .c-risk span:first-child")].map((e) => e.textContent),
    ...[...document.querySelectorAll(".picked td:nth-child(2), #cost td:first-child")].map((e) => e.textContent),
    ...[...document.querySelectorAll(".exemptions td:nth-child(3)")].map((e) => e.textContent),
  ]);
  assert.ok(words.length > 30);
  for (const word of words) {
    const plain = word.replace(/ \[.*\]$/, "").replace("\u2605 ", "");
    assert.ok(listed.has(plain), `nothing tells what "${plain}" is`);
  }
  for (const word of ["certified", "inner capsule", "tolerated", "referee", "clearance"])
    assert.ok(listed.has(word), word);
  const text = await page.locator("#page").innerText();
  assert.ok(!/\bdecides\b|\balone ns\b/.test(text), "replaced by plain words");
  await page.context().close();
}

/** Boxes are drawn, a floor, and the three axes in their colours. */
async function drawsTheRobotWhole({ address, study }) {
  assert.ok(study.kept[0].boxes.length > 0);
  const page = await open(address),
    whole = await colours(page);
  const hue = () =>
    page.evaluate(() => {
      const canvas = document.querySelector(".stage canvas"),
        { width, height } = canvas;
      const flat = Object.assign(document.createElement("canvas"), { width, height }).getContext("2d");
      flat.drawImage(canvas, 0, 0);
      const { data } = flat.getImageData(0, 0, width, height),
        seen = { x: 0, y: 0, z: 0 };
      const css = getComputedStyle(document.documentElement);
      const wanted = Object.keys(seen).map((k) => [k, css.getPropertyValue(`--axis-${k}`).trim().match(/\w\w/g)]);
      for (let i = 0; i < data.length; i += 4)
        for (const [k, rgb] of wanted)
          if (data[i + 3] > 200 && rgb.every((h, j) => Math.abs(parseInt(h, 16) - data[i + j]) < 12)) seen[k] += 1;
      return seen;
    });
  const axes = await hue();
  assert.ok(axes.x > 20 && axes.y > 20 && axes.z > 20, JSON.stringify(axes));
  await page.context().close();
  const hashWithout = async (change) => {
    const copy = structuredClone(study);
    change(copy);
    writeFileSync(join(folder, "less.html"), filled(copy));
    const less = await open(pathToFileURL(join(folder, "less.html")).href),
      { hash } = await colours(less);
    await less.context().close();
    return hash;
  };
  assert.equal(await hashWithout(() => {}), whole.hash);
  const withoutBox = await hashWithout((s) => {
    // As high as before, so that the floor stays, and without width.
    for (const kept of s.kept) for (const box of kept.boxes) box.axes = box.axes.map((axis) => [0, 0, axis[2]]);
  });
  assert.notEqual(withoutBox, whole.hash, "a box is seen");
  assert.match(await floorText({ address }), /squares of the floor are [0-9.]+ m wide/);
}
async function floorText({ address }) {
  const page = await open(address),
    text = await page.locator(".seen > p.soft").innerText();
  await page.context().close();
  return text;
}

async function savesTheTable({ address, study }) {
  const page = await open(address);
  const [download] = await Promise.all([
    page.waitForEvent("download"),
    page.getByRole("button", { name: "Save as CSV" }).click(),
  ]);
  assert.equal(download.suggestedFilename(), `${basename(study.file)}-pairs.csv`);
  const rows = readCsv(readFileSync(await download.path(), "utf8"));
  assert.equal(rows.length, study.pairs.length + 1, "a line a pair, and the head");
  const first = await page.locator(".findings tbody td.c-pair").first().innerText();
  assert.deepEqual(rows[1].slice(0, 2), first.split("\n"), "in the order of the table");
  await page.context().close();
}

/** In no window does the page scroll sideways, and in a wide one no table does. */
async function fitsItsWindow({ address }) {
  for (const width of [390, 500, 1400]) {
    const page = await open(address, { width });
    const [inner, outer] = await page.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
    assert.ok(inner <= outer, `the page is ${inner} wide in a window of ${outer}`);
    const cut = () => [...document.querySelectorAll(".scroll")].filter((e) => e.scrollWidth > e.clientWidth + 1).length;
    if (width === 1400) assert.equal(await page.evaluate(cut), 0, "tables that are cut");
    await page.context().close();
  }
}

/** The chart, the swatches and, where there is no WebGL, the outlines. */
async function standsOut({ address }) {
  for (const scheme of ["light", "dark"]) {
    const page = await open(address, { scheme, first: withoutWebgl });
    await page.locator("#cost").scrollIntoViewIfNeeded();
    await page.waitForSelector("#cost .plot svg");
    const least = await assertContrast(page, scheme);
    console.log(`contrast, ${scheme}: ${JSON.stringify(least)}`);
    assert.ok(least.word[1] > 100 && least.mark[1] > 20, JSON.stringify(least));
    await page.context().close();
  }
}

async function worksWithoutWebgl({ address }) {
  const page = await open(address, { first: withoutWebgl });
  await page.waitForSelector(".stage.flat svg.projection");
  assert.match(await page.locator(".seen > p.soft").innerText(), /no WebGL/);
  const before = await page.locator(".projection").innerHTML();
  await page.getByRole("slider").first().focus();
  await page.keyboard.press("End");
  await settled(page);
  assert.notEqual(await page.locator(".projection").innerHTML(), before, "the outlines move");
  errors.length = 0; // three.js says itself that it got no context
  await page.context().close();
}

const crane = pageOf("crane.urdf"),
  arm = pageOf("arm.urdf");
assert.ok(crane?.study.motions && arm?.study.motions && pages.length >= 5, "robots with proofs, and others");
for (const check of [
  movesRobotsAsTheExecutableDoes,
  measuresGapsAsTheExecutableDoes,
  leavesNoNearPairOut,
  sortsPairsByRisk,
  writesACsvThatHolds,
])
  check();
await movesJoints(pageOf("porter.urdf"));
const within = await movesJoints(withClearance(crane, 0.5));
assert.ok(within.length > 0, "pairs are within so wide a clearance");
await movesJoints(withClearance(crane, Math.max(...within) + 1e-3)); // one of them only just
await showsWhatIsRefuted(crane);
await computesWhatIsExempt(crane);
for (const one of [crane, pageOf("hand.xml")]) await tellsItsWords(one);
await drawsTheRobotWhole(crane);
await savesTheTable(crane);
for (const one of [crane, arm]) await fitsItsWindow(one);
assert.deepEqual(errors, []);
await standsOut(crane);
await worksWithoutWebgl(crane);
assert.deepEqual(asked, [], "nothing is asked from the network");
console.log("study_robot_test: all well");
await browser.close();
