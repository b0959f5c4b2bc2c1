// SPDX-License-Identifier: MIT
// A reader of the page of a scene: opens it from disk in a browser without network, filters, sorts, picks pairs in the
// table and in the picture, switches configurations and ghosts.
//     node study_page_test.mjs PAGE.html          of corpus/scenes/twenty.urdf, with --verify
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { asked, browser, colours, dataOf, errors, filled, folder, open, settled, withoutWebgl } from "../browser.mjs";
import { daylight } from "../chart.mjs";

const { frameOf, standIn } = daylight;

const given = resolve(process.argv[2]),
  address = pathToFileURL(given).href;
const study = dataOf(given);

const status = async (page) => (await settled(page), page.locator(".pairs [role=status]").innerText());
const column = async (page, name) => (
  await settled(page),
  page.locator(`.findings tbody td.c-${name}`).allInnerTexts()
);
const told = async (page, name) => (
  await settled(page),
  page.evaluate((key) => new URLSearchParams(location.hash.slice(1)).get(key), name)
);
const inPicture = async (page, x, y) => {
  const box = await page.locator(".stage canvas").boundingBox();
  return [box.x + x * box.width, box.y + y * box.height];
};

/** The distance of two segments, by going to and fro between them: good to 1e-6 of what is drawn. */
function wayBetween(a, b) {
  const dot = (u, v) => u[0] * v[0] + u[1] * v[1] + u[2] * v[2],
    sub = (u, v) => u.map((x, i) => x - v[i]);
  const at = (s, t) => s.center.map((x, i) => x + t * s.axis[i]),
    onto = (s, p) => Math.max(-s.half, Math.min(s.half, dot(sub(p, s.center), s.axis)));
  let t = 0,
    u = 0;
  for (let i = 0; i < 500; ++i) {
    t = onto(a, at(b, u));
    u = onto(b, at(a, t));
  }
  return Math.hypot(...sub(at(a, t), at(b, u)));
}

/** What is drawn of a model says what the model said. */
function ghostsAreTheModels() {
  const frame = frameOf(study),
    compared = { sphere: 0, "outer capsule": 0, "inner capsule": 0 };
  for (const kept of study.kept)
    for (const [i, seen] of kept.pairs.entries())
      for (const model of Object.keys(compared)) {
        const [a, b] = study.pairs[i].bodies.map((body) => standIn(frame.solid(kept.cylinders[body]), model));
        const gap = wayBetween(a, b) - a.radius - b.radius - study.clearance / frame.unit;
        if (Math.abs(gap) < 1e-5) continue;
        assert.equal(
          gap < 0,
          seen.wrong.includes(model) !== seen.within,
          `${model} of ${study.pairs[i].a} and ${study.pairs[i].b}, configuration ${kept.configuration}`,
        );
        compared[model] += gap < 0 ? 1 : 0;
      }
  assert.ok(
    Object.values(compared).every((n) => n > 0),
    JSON.stringify(compared),
  );
}

async function readsWhatIsRecommended(page) {
  const { words } = study;
  const numbers = (await page.locator("#recommendation .numbers b").allInnerTexts()).map((text) => parseInt(text, 10));
  const simple = study.pairs.filter(({ needs }) => ["sphere", "outer capsule"].includes(needs)).length,
    within = study.pairs.filter(({ known, within }) => known && within > 0).length;
  assert.deepEqual(numbers, [simple, within, study.pairs.filter(({ known }) => !known).length]);
  const text = await page.locator("#recommendation").innerText();
  for (const sentence of [
    `${words.recommended}: ${words.cost.split(";")[0]}`.replaceAll(" us ", " \u00b5s "),
    ...words.remarks,
    words.pairs,
    words.enough,
    words.capsules,
    words.rounding[0],
    words.closest.replace(" - ", " \u2013 "),
    words.verified,
    words.configurations,
  ])
    assert.ok(text.toLowerCase().includes(sentence.toLowerCase()), sentence);
  assert.match(await page.locator("header .run").innerText(), /twenty\.urdf .* seed 1 /);
}

async function filtersAndSorts(page) {
  const whole = await colours(page);
  assert.ok(whole.count > 50, `the drawing has ${whole.count} colours`);
  assert.equal(await status(page), `${study.pairs.length} pairs`);
  for (const model of ["sphere", "outer capsule", "cylinder"]) {
    const chip = page.locator(".seen .chip", { hasText: model }),
      count = study.pairs.filter((pair) => pair.needs === model).length;
    assert.equal(await chip.locator(".count").innerText(), String(count));
    await chip.click();
    assert.equal(await status(page), `${count} of ${study.pairs.length} pairs`);
    assert.ok((await column(page, "needs")).every((needs) => needs.startsWith(model)));
    assert.equal((await colours(page)).hash, whole.hash, "no lines before a pair is picked");
    await page.locator(".findings tbody tr[tabindex='0']").click();
    assert.notEqual((await colours(page)).hash, whole.hash, "the pair picked stands out");
    await page.getByRole("button", { name: "Show all" }).click();
    await chip.click();
  }
  assert.equal((await colours(page)).hash, whole.hash);
  const search = page.getByLabel("Search pairs by name");
  await search.fill("trunk right");
  assert.equal(
    await status(page),
    `${study.pairs.filter(({ a, b }) => a === "trunk" && b.startsWith("right")).length} of ${study.pairs.length} pairs`,
  );
  await search.fill("nobody");
  assert.equal(await status(page), `0 of ${study.pairs.length} pairs`);
  await search.fill("");

  const head = page.locator(".findings th", { hasText: "least" });
  await head.getByRole("button").click();
  assert.equal((await settled(page), await head.getAttribute("aria-sort")), "ascending");
  const least = study.pairs.reduce((x, y) => (y.least_distance < x.least_distance ? y : x));
  assert.deepEqual((await column(page, "pair"))[0].split("\n"), [least.a, least.b]);
  await head.getByRole("button").click();
  const most = study.pairs.reduce((x, y) => (y.least_distance > x.least_distance ? y : x));
  assert.deepEqual((await column(page, "pair"))[0].split("\n"), [most.a, most.b]);
}

async function picksInTheTable(page) {
  await page.getByRole("button", { name: "needs" }).click();
  const before = await colours(page);
  await page.locator(".findings tbody tr:not(.spacer)").nth(2).click();
  const named = (await column(page, "pair"))[2].split("\n");
  assert.equal((await page.locator(".picked h3").innerText()).includes(`${named[0]} \u2013`), true);
  const pair = study.pairs[Number(await told(page, "pair"))];
  assert.deepEqual([pair.a, pair.b], named);
  const bare = await colours(page);
  assert.ok(
    bare.opaque > 100 && bare.opaque < before.opaque / 2,
    `the others are faded: ${bare.opaque} of ${before.opaque}`,
  );
  const hashes = new Set([bare.hash]);
  for (const model of ["sphere", "outer capsule", "inner capsule"]) {
    await page.getByLabel(`Show the ${model} of both`).check();
    hashes.add((await colours(page)).hash);
  }
  assert.equal(hashes.size, 4, "each ghost is seen");
  assert.equal(await told(page, "ghosts"), "sphere,outer capsule,inner capsule");
  for (const model of ["sphere", "outer capsule", "inner capsule"])
    await page.getByLabel(`Show the ${model} of both`).uncheck();
  assert.equal((await colours(page)).hash, bare.hash);
  await page.getByRole("button", { name: "Close up" }).click();
  assert.notEqual((await colours(page)).hash, bare.hash);
  await page.locator(".pairs .virtual").focus();
  await page.keyboard.press("ArrowDown");
  assert.deepEqual(
    (await column(page, "pair"))[3].split("\n"),
    Object.values(study.pairs[Number(await told(page, "pair"))]).slice(0, 2),
  );
  await page.getByRole("button", { name: "Show all" }).click();
  assert.equal((await settled(page), await page.locator(".picked").count()), 0);
  assert.equal((await colours(page)).hash, before.hash);
}

/** Each kept configuration, by why it is kept: the pair, the ghost and what the model says there. */
async function switchesConfigurations(page) {
  const options = await page.locator(".stage-tools option").allInnerTexts();
  assert.equal(
    options.length,
    study.kept.reduce((n, k) => n + k.reasons.length, 0),
  );
  const seen = new Set();
  let at = 0;
  for (const [k, kept] of study.kept.entries())
    for (const reason of kept.reasons) {
      const words = options[at];
      await page.locator(".stage-tools select").selectOption({ index: at++ });
      assert.equal(await told(page, "at"), reason.pair === undefined && k === 0 ? null : String(k), words);
      seen.add((await colours(page)).hash);
      if (reason.pair === undefined) continue;
      const pair = study.pairs[reason.pair];
      assert.ok(words.includes(`${pair.a} \u2013 ${pair.b}`), words);
      assert.equal(await told(page, "pair"), String(reason.pair));
      if (!reason.model) continue;
      assert.equal(await page.getByLabel(`Show the ${reason.model} of both`).isChecked(), true);
      const row = page.locator(".picked tbody tr", { has: page.getByLabel(`Show the ${reason.model} of both`) });
      assert.match(await row.innerText(), reason.why === "missed" ? /apart: missed/ : /within: a false alarm/);
      assert.match(
        await page.locator(".picked p").innerText(),
        reason.why === "missed" ? /would miss that/ : /would raise a false alarm/,
      );
    }
  assert.equal(seen.size, options.length, "each looks another way");
  await page.getByText("Joints of this configuration").click();
  assert.match(
    await page.locator(".copy code").innerText(),
    /^\.\/daylight scene \S*twenty\.urdf --at left_1_joint=-?[0-9.]+ /,
  );
}

async function picksInThePicture(page) {
  await page.locator(".stage-tools select").selectOption({ index: 0 });
  if (await page.getByRole("button", { name: "Show all" }).isEnabled())
    await page.getByRole("button", { name: "Show all" }).click();
  await page.locator(".stage canvas").scrollIntoViewIfNeeded();
  // Where a body is: the pointer says its name.
  const names = new Map();
  for (let y = 0.1; y < 0.95; y += 0.12)
    for (let x = 0.1; x < 0.95; x += 0.12) {
      await page.mouse.move(...(await inPicture(page, x, y)));
      await page.evaluate(
        () =>
          new Promise((done) => {
            requestAnimationFrame(() => requestAnimationFrame(done));
          }),
      );
      const name = await page.locator(".under").allInnerTexts();
      if (name.length > 0 && !name[0].includes("\u2013") && !names.has(name[0])) names.set(name[0], [x, y]);
    }
  assert.ok(names.size >= 2, `found ${[...names.keys()].join()}`);
  const index = (name) => study.bodies.findIndex((body) => body.name === name);
  const ofBoth = ([x, y]) =>
    study.pairs.findIndex(({ bodies }) => bodies.includes(index(x)) && bodies.includes(index(y)));
  const [first, second] = [...names.keys()]
    .flatMap((x) => [...names.keys()].map((y) => [x, y]))
    .find(([x, y]) => x !== y && ofBoth([x, y]) >= 0);
  const click = async (name) => {
    await page.mouse.click(...(await inPicture(page, ...names.get(name))));
    await settled(page);
  };
  await click(first);
  assert.ok(
    study.pairs[Number(await told(page, "pair"))].bodies.includes(index(first)),
    "a pair of the body that was clicked",
  );
  await click(second);
  assert.equal(await told(page, "pair"), String(ofBoth([first, second])), "the pair of both");
  const before = await colours(page);
  await page.mouse.move(...(await inPicture(page, 0.5, 0.5)));
  await page.mouse.down();
  await page.mouse.move(...(await inPicture(page, 0.7, 0.6)), { steps: 3 });
  await page.mouse.up();
  assert.notEqual((await colours(page)).hash, before.hash, "turned, it looks another way");
  assert.equal(await told(page, "pair"), String(ofBoth([first, second])), "to turn is not to click");
  await page.mouse.click(...(await inPicture(page, 0.02, 0.98)));
  assert.equal((await settled(page), await page.locator(".picked").count()), 0, "a click beside it picks none");
}

async function readsTheChart(page) {
  await page.locator("#cost").scrollIntoViewIfNeeded();
  await page.waitForSelector("#cost .plot svg");
  const points = await page.locator("#cost .plot [aria-label=dot] path, #cost .plot [aria-label=dot] circle").all();
  assert.equal(points.length, 7);
  const labels = await Promise.all(points.map((p) => p.getAttribute("aria-label")));
  const outer = study.models.find((m) => m.model === "outer capsule");
  assert.ok(
    outer.wrong > 0 &&
      labels.some((l) => l.startsWith("outer capsule alone") && l.includes(`${outer.wrong} wrong answer`)),
    labels.join("\n"),
  );
  assert.ok(labels.some((l) => l.startsWith("recommended") && l.includes("no wrong answer")));
  assert.ok(
    (await page.locator("#cost .plot [aria-label='y-axis tick label'] text").allTextContents()).includes("none"),
    "that nothing is wrong has its place on the scale",
  );
  const rows = await page.locator("#cost tbody tr").allInnerTexts();
  assert.equal(rows.length, 7);
  assert.ok(rows[1].includes(String(outer.wrong)) && rows[1].includes(String(outer.suffices)));
}

async function fits(page) {
  const [inner, outer] = await page.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
  assert.ok(inner <= outer, `the page is ${inner} wide in a window of ${outer}`);
  const names = await page.evaluate(() =>
    [...document.querySelectorAll("#cost .plot svg > [aria-label=text] text")].map((e) => {
      const b = e.getBoundingClientRect();
      return [b.left, b.right, b.top, b.bottom, e.textContent];
    }),
  );
  assert.equal(names.length, 7);
  for (const [i, x] of names.entries())
    for (const y of names.slice(i + 1))
      assert.ok(
        x[1] <= y[0] || y[1] <= x[0] || x[3] <= y[2] + 2 || y[3] <= x[2] + 2,
        `${x[4]} and ${y[4]} lie on each other`,
      );
}

/** The address of a view opens it again. */
async function opensAViewByItsAddress() {
  const at = study.kept.findIndex((k) => k.reasons.some((r) => r.model === "outer capsule")),
    { pair } = study.kept[at].reasons.find((r) => r.model === "outer capsule");
  const page = await open(`${address}#${new URLSearchParams({ at, pair, ghosts: "outer capsule", close: "1" })}`, {
    scheme: "dark",
    width: 700,
  });
  assert.match(
    await page.locator(".picked p").innerText(),
    /the outer capsule would raise a false alarm|and the outer capsule would/,
  );
  assert.equal(await page.getByLabel("Show the outer capsule of both").isChecked(), true);
  await readsTheChart(page);
  await fits(page);
  await page.context().close();
  const lost = await open(`${address}#at=99&pair=-1&ghosts=none`);
  assert.equal(await lost.locator(".picked").count(), 0);
  await lost.context().close();
}

/** Names of a file may be anything. */
async function showsHostileTextAsText() {
  const hostile = "</script><img src=x onerror=alert(1)>\u202e\u0001",
    copy = structuredClone(study);
  Object.assign(copy, { file: hostile, notes: [hostile], left_out: [hostile] });
  copy.words.closest = copy.words.counts = hostile;
  copy.words.left_out = [hostile];
  for (const body of copy.bodies) body.name = hostile;
  for (const pair of copy.pairs) pair.a = pair.b = hostile;
  copy.kept[0].joints = { [hostile]: 1 };
  writeFileSync(join(folder, "hostile.html"), filled(copy));
  const page = await open(`${pathToFileURL(join(folder, "hostile.html")).href}#at=0&pair=0`);
  await page.waitForSelector(".picked");
  await page.getByText("Joints of this configuration").click();
  assert.equal(await page.locator("img").count(), 0);
  const text = await page.locator("body").innerText();
  assert.ok(!text.includes("\u202e") && text.includes("<img src=x"));
  await page.context().close();
}

/** A scene with nothing to check, and a template that nobody filled. */
async function saysThatThereIsNothing() {
  const alone = {
    ...structuredClone(study),
    pairs: [],
    words: {
      ...Object.fromEntries(Object.keys(study.words).map((key) => [key, ""])),
      ...{ left_out: [], remarks: [], rounding: [] },
    },
  };
  for (const kept of alone.kept) Object.assign(kept, { pairs: [], reasons: [{ why: "drawn first" }] });
  writeFileSync(join(folder, "alone.html"), filled(alone));
  const page = await open(pathToFileURL(join(folder, "alone.html")).href);
  assert.equal(await page.locator("h2").first().innerText(), "Nothing to check");
  assert.ok((await colours(page)).count > 50);
  await page.context().close();
  writeFileSync(join(folder, "bare.html"), readFileSync(new URL("../page_template.html", import.meta.url)));
  const bare = await open(pathToFileURL(join(folder, "bare.html")).href);
  assert.match(await bare.locator("body").innerText(), /without its data/);
  await bare.context().close();
}

async function drawsLinesWithoutWebgl() {
  const page = await open(`${address}#at=0&pair=3`, { first: withoutWebgl });
  await page.waitForSelector(".stage.flat svg.projection");
  assert.equal(await page.locator(".projection .body").count(), study.cylinders);
  assert.equal(await page.locator(".projection .gap").count(), 1);
  errors.length = 0; // three.js says itself that it got no context
  await page.context().close();
}

ghostsAreTheModels();
const page = await open(address);
for (const step of [
  readsWhatIsRecommended,
  filtersAndSorts,
  picksInTheTable,
  switchesConfigurations,
  picksInThePicture,
  readsTheChart,
  fits,
])
  await step(page);
await page.context().close();
await opensAViewByItsAddress();
await showsHostileTextAsText();
await saysThatThereIsNothing();
assert.deepEqual(errors, []);
await drawsLinesWithoutWebgl();
assert.deepEqual(asked, [], "nothing is asked from the network");
console.log("study_page_test: all well");
await browser.close();
