// SPDX-License-Identifier: MIT
// A reader of the page: opens it from disk in a browser without network, filters, sorts, opens findings and causes,
// turns the drawing, proves again and tampers.
//     node page_test.mjs                          a made-up run
//     node page_test.mjs --shots FOLDER [PAGE]    only pictures of every section, light and dark
//     node page_test.mjs --times FINDINGS         how long such a run takes to open and to filter
import assert from "node:assert/strict";
import { mkdirSync, writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { asked, browser, colours, errors, folder, open, settled, without_webgl } from "./browser.mjs";
import { filled, sample } from "./sample.mjs";

const [option, argument, given] = process.argv.slice(2);
let address = "";

function write(report) {
  writeFileSync(join(folder, "report.html"), filled(report));
  address = pathToFileURL(join(folder, "report.html")).href;
}
const open_page = (options) => open(address, options);

const rows_told = async (page) => (
  await settled(page),
  Number((await page.locator(".filters [role=status]").innerText()).split(" ")[0].replaceAll(",", ""))
);

async function shots(to) {
  mkdirSync(to, { recursive: true });
  for (const scheme of ["light", "dark"]) {
    const page = await open_page({ scheme });
    for (const id of ["summary", "findings", "speed", "maps", "calibration", "stability", "methods", "faults"]) {
      const section = page.locator(`section#${id}`);
      await section.scrollIntoViewIfNeeded();
      await page.waitForTimeout(250);
      await section.screenshot({ path: `${to}/${id}-${scheme}.png` });
    }
    for (const [name, link] of [
      ["finding", ".findings tbody a"],
      ["bucket", ".buckets a"],
    ]) {
      await page.evaluate(() => {
        location.hash = "#/findings";
      });
      if ((await page.locator(link).count()) === 0) continue;
      await page.locator(link).first().click();
      await page.waitForSelector(".case");
      if ((await page.locator(".prove").count()) > 0) await page.locator(".prove").click();
      await page.waitForTimeout(300);
      await page.screenshot({ path: `${to}/${name}-${scheme}.png`, fullPage: true });
    }
    await page.context().close();
  }
  const page = await open_page();
  await page.emulateMedia({ media: "print" });
  await page.pdf({ path: `${to}/print.pdf` }).catch(() => {});
}

const go = (page, hash) =>
  page.evaluate((hash) => {
    location.hash = hash;
  }, hash);
const hash_of = (page) => page.evaluate(() => location.hash);
const causes_shown = async (page) => (await settled(page), page.locator(".buckets tbody tr a").allInnerTexts());
const bucket_column = (page, n) => page.locator(`.buckets tbody td:nth-child(${n})`).allInnerTexts();

/** The first line says what changed, each word shows those causes; the new ones stand on top. */
async function leads_to_what_is_new(page, report) {
  const { changes, buckets } = report;
  const line = page.locator("main.overview > *").first();
  assert.match(
    await line.innerText(),
    new RegExp(`^1 new cause, ${changes.back} back, ${changes.known} known, ${changes.rare} rare, 1 gone, `),
  );
  const rank = ["new", "back", "known", "rare", "gone"];
  const order = (await bucket_column(page, 7)).map((word) => rank.indexOf(word));
  assert.equal(order.length, buckets.length);
  assert.deepEqual(order, [...order].sort());
  assert.equal(order[0], 0);
  for (const word of rank) {
    await line.locator("a", { hasText: word }).click();
    assert.deepEqual(
      (await causes_shown(page)).sort(),
      buckets.filter((b) => b.standing === word).map((b) => b.key).sort(),
    );
  }
  assert.equal(await rows_told(page), 0, "a gone cause has no findings");
  await page.getByRole("button", { name: "Clear" }).click();
  assert.equal((await causes_shown(page)).length, buckets.length);
  await settled(page);
  assert.equal(await hash_of(page), "#/findings");

  const head = page.locator(".buckets th", { hasText: "findings" });
  await head.getByRole("button").click();
  await settled(page);
  assert.equal(await head.getAttribute("aria-sort"), "descending");
  const counts = (await bucket_column(page, 4)).map((text) => Number(text.replaceAll(",", "")));
  assert.deepEqual(counts, [...counts].sort((x, y) => y - x));
  assert.equal(await page.locator(".buckets th[aria-sort=none]").count(), 7);
  await go(page, "#/findings?method=ode");
  await settled(page);
  await page.getByRole("button", { name: "Clear" }).click();
}

/** Chips and search reach both tables, and what they show stands in the address. */
async function keeps_what_is_shown(page, report) {
  const kind = page.locator(".chips[aria-label=Kind] .chip", { hasText: "distance outside" });
  const steps = await page.evaluate(() => history.length);
  await kind.click();
  const causes = await causes_shown(page);
  assert.ok(causes.length > 0 && causes.length < report.buckets.length);
  assert.ok(causes.every((key) => key.includes("distance_outside")));
  const search = page.getByLabel("Search causes and findings");
  await search.pressSequentially("ode");
  const found = await rows_told(page);
  await page.locator(".findings th", { hasText: "margin" }).getByRole("button").click();
  await settled(page);
  assert.equal(await page.evaluate(() => history.length), steps, "nothing for the Back button");
  const [top] = await page.locator(".findings tbody td.c-id").allInnerTexts();
  await page.reload();
  assert.equal(await rows_told(page), found);
  assert.equal((await page.locator(".findings tbody td.c-id").allInnerTexts())[0], top);
  assert.equal(await search.inputValue(), "ode");
  assert.equal(await kind.getAttribute("aria-pressed"), "true");
  await page.locator(".findings tbody tr[tabindex='0']").click();
  await page.waitForSelector(".detail h2");
  await page.goBack();
  assert.equal(await rows_told(page), found, "Back finds it as it was");
  await page.getByRole("button", { name: "Clear" }).click();

  const rows_of_text = async (text) => (await search.fill(text), rows_told(page));
  const of = (passes) => report.findings.filter(passes).length;
  const disjoint = of((f) => f.kind === "wrong_disjoint");
  assert.equal(await rows_of_text("wrong disjoint"), disjoint);
  assert.equal(await rows_of_text("wrong_disjoint"), disjoint);
  const family = of((f) => f.family === "touching_side_rim");
  assert.equal(await rows_of_text("touching_side_rim"), family);
  assert.ok((await rows_of_text("touching side rim")) >= family);
  assert.equal(await rows_of_text("beyond its claim"), of((f) => f.severity === "contract"));
  const both = of((f) => f.severity === "contract" && f.family === "touching_side_rim");
  assert.equal(await rows_of_text("touching_side_rim  Beyond its claim"), both);
  assert.ok(await rows_of_text("asked upstream"), "the note of a cause");
  assert.equal((await causes_shown(page)).length, 1);
  await search.fill("");
  await settled(page);
}

/** The rows on the screen, as the texts of one column. */
const column = async (page, name) => (
  await settled(page),
  page.locator(`.findings tbody td.c-${name}`).allInnerTexts()
);

async function reads_the_findings(page) {
  assert.equal(await rows_told(page), 400);
  assert.ok((await page.locator(".findings tbody tr").count()) < 60, "only the rows on the screen are elements");
  const chip = page.locator(".chips[aria-label=Kind] .chip", { hasText: "crash" });
  const promised = Number(await chip.locator(".count").innerText());
  await chip.click();
  assert.equal(await rows_told(page), promised);
  assert.ok((await column(page, "kind")).every((kind) => kind === "crash"));
  assert.equal(await chip.getAttribute("aria-pressed"), "true");
  await page.getByRole("button", { name: "Clear" }).click();
  assert.equal(await rows_told(page), 400);

  const head = page.locator(".findings th", { hasText: "#" });
  await head.getByRole("button").click();
  await settled(page);
  assert.equal(await head.getAttribute("aria-sort"), "ascending");
  assert.deepEqual((await column(page, "id")).slice(0, 3), ["1", "2", "3"]);
  await head.getByRole("button").click();
  await settled(page);
  assert.equal(await head.getAttribute("aria-sort"), "descending");
  assert.equal((await column(page, "id"))[0], "400");
  assert.equal(await page.locator(".findings th[aria-sort=ascending]").count(), 0);

  await page.locator(".virtual").focus();
  await page.keyboard.press("End");
  await page.waitForSelector(".findings tr.at");
  assert.equal(await page.locator(".findings tr.at .c-id").innerText(), "1", "the last row came onto the screen");
  await page.keyboard.press("ArrowUp");
  await page.keyboard.press("Enter");
  await page.waitForSelector(".detail h2");
  assert.match(await page.locator(".detail h2").innerText(), /^#2 /);
  await page.goBack();
  await settled(page);
  assert.equal(await page.locator("main.overview").isVisible(), true);
}

async function proves_and_turns(page) {
  const first = await colours(page);
  assert.ok(first.count > 50, `the drawing has ${first.count} colours`);
  const box = await page.locator(".stage canvas").boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2 + 90, box.y + box.height / 2 + 30, { steps: 3 });
  await page.mouse.up();
  assert.notEqual((await colours(page)).hash, first.hash, "turned, it looks another way");

  await page.locator(".prove").click();
  await settled(page);
  assert.equal(await page.locator(".proof").getAttribute("data-holds"), "true");
  const field = page.locator(".prover textarea"),
    certificate = JSON.parse(await field.inputValue());
  const tampered = certificate.direction
    ? { ...certificate, direction: [0, 0, 1] }
    : { ...certificate, point: [certificate.point[0], 5, 0] };
  await field.fill(JSON.stringify(tampered));
  await settled(page);
  assert.equal(await page.locator(".proof").count(), 0, "an old proof does not stand beside a new certificate");
  await page.locator(".prove").click();
  await settled(page);
  assert.equal(await page.locator(".proof").getAttribute("data-holds"), "false");
  await page.getByRole("button", { name: "As it was" }).click();
  await page.locator(".prove").click();
  await settled(page);
  assert.equal(await page.locator(".proof").getAttribute("data-holds"), "true");
}

async function reads_a_cause(page) {
  await page.locator(".buckets a").first().click();
  await page.waitForSelector(".tabs");
  await proves_and_turns(page);
  await page.getByRole("tab", { name: "Worst" }).click();
  await settled(page);
  assert.equal(await page.getByRole("tab", { name: "Worst" }).getAttribute("aria-selected"), "true");
  await proves_and_turns(page);
  assert.equal(await page.locator("canvas").count(), 1, "one canvas serves all views");
}

async function reads_a_narrow_gap(page, report) {
  const narrow = report.findings.find((f) => report.cases[f.case].margin[0] < 1e-11);
  await page.evaluate((id) => {
    location.hash = `#/finding/${id}`;
  }, narrow.id);
  await page.waitForSelector(".pair-view figcaption .warn");
  assert.match(
    await page.locator(".pair-view figcaption").innerText(),
    /^Not to scale: the (gap|overlap) of \S+ is drawn \S+ times as wide/,
  );
  const wide = await colours(page);
  await page.getByRole("button", { name: /^Widen/ }).click();
  await settled(page);
  assert.match(await page.locator(".pair-view figcaption").innerText(), /^To scale/);
  assert.notEqual((await colours(page)).hash, wide.hash);
}

async function follows_a_heat_cell(page) {
  await page.evaluate(() => {
    location.hash = "#/summary";
  });
  await page.locator("td.heat.bad a").first().click();
  await page.waitForFunction(() => location.hash.startsWith("#/findings?"));
  await settled(page);
  const chosen = await page.evaluate(() => new URLSearchParams(location.hash.split("?")[1]).get("family"));
  assert.equal(await page.locator(".chips[aria-label=Family] .chip[aria-pressed=true]").count(), 1);
  assert.match(
    await page.locator(".chips[aria-label=Family] .chip[aria-pressed=true]").innerText(),
    new RegExp(chosen.replaceAll("_", " ")),
  );
}

async function draws_every_plot(page) {
  for (const [id, plots] of [
    ["speed", 2],
    ["maps", 6],
    ["calibration", 1],
    ["stability", 3],
  ]) {
    await page.locator(`section#${id}`).scrollIntoViewIfNeeded();
    for (const plot of await page.locator(`section#${id} .plot`).all()) await plot.scrollIntoViewIfNeeded();
    await page.waitForFunction(
      ([id, plots]) => document.querySelectorAll(`#${id} .plot svg`).length === plots,
      [id, plots],
    );
  }
  assert.equal(await page.locator(".missing").count(), 0, "the made-up run has everything");
}

/** A point leads to its method's findings, a cell of a map to a case; the pointer shows the numbers. */
async function follows_the_plots(page) {
  const cell = page.locator("#maps .plot a").nth(3);
  await cell.scrollIntoViewIfNeeded();
  await cell.hover();
  await settled(page);
  assert.match(await page.locator("#maps .plot [aria-label=tip]", { hasText: "asked" }).first().textContent(), /asked/);
  await cell.click();
  await page.waitForSelector(".detail .case");
  await page.goBack();
  const point = page.locator("#speed .plot a", { has: page.locator("[aria-label^=ode]") }).first();
  await point.scrollIntoViewIfNeeded();
  await point.click();
  await settled(page);
  assert.equal(await page.locator(".filters .chip", { hasText: "method ode" }).count(), 1);
  assert.ok((await column(page, "method")).every((m) => m === "ode"));
}

async function fits_a_laptop(page) {
  await page.evaluate(() => {
    location.hash = "#/summary";
  });
  await page.getByRole("button", { name: "Unfold all methods" }).click();
  await settled(page);
  const [inner, outer] = await page.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
  assert.ok(inner <= outer, `the page is ${inner} wide in a window of ${outer}`);
  assert.equal(
    await page.evaluate(
      () => [...document.querySelectorAll(".scroll")].filter((e) => e.scrollWidth > e.clientWidth + 1).length,
    ),
    0,
  );
}

/** What a run without triage and bench has: each gap names the command that fills it. */
async function says_what_is_missing() {
  write({
    ...sample(40),
    buckets: [],
    maps: [],
    honesty: [],
    speed: [],
    cost: [],
    paths: [],
    backward: [],
    builds: [],
    kill_matrix: null,
    history: null,
    alarm: null,
  });
  const page = await open_page();
  const commands = await page.locator(".missing code").allInnerTexts();
  assert.equal(commands.length, 9);
  assert.ok(
    commands.every((c) => c.startsWith("./daylight ")),
    commands.join(),
  );
  await page.context().close();
}

/** Text of a store may be anything. */
async function shows_hostile_text_as_text() {
  const hostile = "</script><img src=x onerror=alert(1)>\u202e\u0001",
    report = sample(8);
  Object.assign(report.run, { id: hostile, seed: hostile, status: hostile, build: hostile, command: hostile });
  report.findings.forEach((f) => Object.assign(f, { method: hostile, family: hostile, reason: hostile }));
  report.methods[0].name = report.methods[0].claim.source = hostile;
  report.cases[0].note = hostile;
  write(report);
  const page = await open_page();
  await page.evaluate(() => {
    location.hash = "#/finding/1";
  });
  await page.waitForSelector(".case");
  assert.equal(await page.locator("img").count(), 0);
  assert.ok(!(await page.locator("body").innerText()).includes("\u202e"));
  await page.context().close();
}

async function draws_lines_without_webgl() {
  write(sample(8));
  const page = await open_page({ first: without_webgl });
  await page.evaluate(() => {
    location.hash = "#/finding/1";
  });
  await page.waitForSelector(".stage.flat svg.projection");
  assert.ok(await page.locator(".projection").isVisible());
  assert.ok((await page.locator(".projection path").count()) >= 6);
  errors.length = 0; // three.js says itself that it got no context
  await page.context().close();
}

async function test() {
  const report = sample(400);
  write(report);
  const page = await open_page();
  for (const step of [
    (p) => leads_to_what_is_new(p, report),
    (p) => keeps_what_is_shown(p, report),
    reads_the_findings,
    reads_a_cause,
    (p) => reads_a_narrow_gap(p, report),
    follows_a_heat_cell,
    draws_every_plot,
    follows_the_plots,
    fits_a_laptop,
  ])
    await step(page);
  await page.context().close();
  assert.deepEqual(errors, []);
  await says_what_is_missing();
  await shows_hostile_text_as_text();
  assert.deepEqual(errors, []);
  await draws_lines_without_webgl();
  assert.deepEqual(asked, [], "nothing is asked from the network");
}

async function times(findings) {
  write(sample(findings));
  const page = await open_page();
  await page.waitForSelector(".findings tbody tr");
  const loaded = await page.evaluate(() => performance.now());
  const filter = await page.evaluate(async () => {
    const chips = [...document.querySelectorAll(".chips[aria-label=Kind] .chip")],
      took = [];
    for (const chip of [...chips, ...chips]) {
      const start = performance.now();
      chip.click();
      await new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
      took.push(performance.now() - start);
    }
    return took;
  });
  console.log(
    `${findings} findings: ${Math.round(loaded)} ms until the table stands; a filter ` +
      `${Math.round(Math.min(...filter))} to ${Math.round(Math.max(...filter))} ms until it is drawn`,
  );
}

if (option === "--shots") {
  if (given) address = pathToFileURL(resolve(given)).href;
  else write(sample(400));
  await shots(argument);
  console.log(`errors: ${errors.join("; ") || "none"}`);
} else if (option === "--times") {
  await times(Number(argument));
} else {
  await test();
  console.log("page_test: all well");
}
await browser.close();
