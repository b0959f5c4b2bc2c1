// SPDX-License-Identifier: MIT
// A reader of the page: opens it from disk in a browser without network, filters, sorts, opens findings and causes,
// looks at the drawing, proves again and tampers.
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { asked, browser, errors, filled, folder, open, settled } from "../browser.mjs";
import { assertContrast } from "../contrast.mjs";
import { sample } from "./sample.mjs";

let address = "";

function write(report) {
  writeFileSync(join(folder, "report.html"), filled(report));
  address = pathToFileURL(join(folder, "report.html")).href;
}
const openPage = (options) => open(address, options);

const rowsTold = async (page) => (
  await settled(page),
  Number((await page.locator(".filters [role=status]").innerText()).split(" ")[0].replaceAll(",", ""))
);

const go = (page, hash) =>
  page.evaluate((hash) => {
    location.hash = hash;
  }, hash);
const hashOf = (page) => page.evaluate(() => location.hash);
const causesShown = async (page) => (await settled(page), page.locator(".causes tbody tr a").allInnerTexts());
const causeColumn = (page, n) => page.locator(`.causes tbody td:nth-child(${n})`).allInnerTexts();

/** The page begins with what is new and wrong, its picture and its command; then a line for each other standing. */
async function leadsToWhatIsNew(page, report) {
  const { changes, buckets } = report,
    fresh = buckets.find((b) => b.standing === "new");
  const band = page.locator("main.overview > section").first().locator(".band");
  assert.match(await band.innerText(), /^1 new fault: \S+[^]* (reports|returns|offers|crash)[^]*\.\s/);
  assert.equal(await band.locator("a").first().getAttribute("href"), `#/bucket/${fresh.key}`);
  assert.ok((await band.locator(".thumb .projection").boundingBox()).height > 100, "its picture");
  assert.equal(await copied(page, "Explain it"), `./daylight explain runs/sample ${fresh.key}`);
  assert.equal(await page.locator("header nav a").count(), 3);
  const told = await page.locator("#new .facts dd").nth(4).innerText();
  assert.equal(told, `${buckets.length - 1} and 1 only in earlier runs`);
  const rank = ["new", "back", "known", "rare", "gone"];
  const order = (await causeColumn(page, 4)).map((word) => rank.indexOf(word.trim()));
  assert.equal(order.length, buckets.length);
  assert.deepEqual(order, [...order].sort());
  assert.equal(order[0], 0);
  for (const word of rank.slice(1)) {
    const line = page.locator(".changes a", { hasText: word });
    assert.match(await line.innerText(), new RegExp(`^${changes[word]} causes? (is|are) ${word}$`));
    await line.click();
    assert.deepEqual(
      (await causesShown(page)).sort(),
      buckets
        .filter((b) => b.standing === word)
        .map((b) => b.key)
        .sort(),
    );
  }
  assert.equal(await rowsTold(page), 0, "a gone cause has no findings");
  await page.getByRole("button", { name: "Clear" }).click();
  assert.equal((await causesShown(page)).length, buckets.length);
  await settled(page);
  assert.equal(await hashOf(page), "#/findings");

  const head = page.locator(".causes th", { hasText: "findings" });
  await head.getByRole("button").click();
  await settled(page);
  assert.equal(await head.getAttribute("aria-sort"), "descending");
  const counts = (await causeColumn(page, 3)).map((text) => Number(text.replaceAll(",", "")));
  assert.deepEqual(
    counts,
    [...counts].sort((x, y) => y - x),
  );
  assert.equal(await page.locator(".causes th[aria-sort=none]").count(), 4);
  assert.equal(await page.locator(".causes .thumb path").count() > 4 * buckets.length, true, "each has a picture");
  await go(page, "#/findings?method=ode");
  await settled(page);
  await page.getByRole("button", { name: "Clear" }).click();
}

const search = (page) => page.getByLabel("Search causes and findings");
/** Chooses a filter of those that the field suggests. */
async function chooseFilter(page, words) {
  await search(page).fill(words);
  await page.getByRole("option", { name: words }).first().click();
  await settled(page);
}
const chips = (page) => page.locator(".filters .chip").allInnerTexts();

/** The field suggests, by pointer and by key; what is chosen can be removed. */
async function suggestsFilters(page, report) {
  await search(page).focus();
  const facets = await page.locator("#suggestions li .soft:first-child").allInnerTexts();
  assert.deepEqual([...new Set(facets)], ["severity", "kind", "library", "family", "since earlier runs"]);
  await search(page).pressSequentially("cra");
  const crashes = report.findings.filter((f) => f.kind === "crash").length;
  assert.match(await page.getByRole("option").first().innerText(), new RegExp(`^kind\\s+crash\\s+${crashes}$`));
  await page.keyboard.press("ArrowDown");
  const chosen = await search(page).getAttribute("aria-activedescendant");
  assert.equal(await page.locator(`#${chosen}`).getAttribute("aria-selected"), "true");
  await page.keyboard.press("Enter");
  await settled(page);
  assert.match((await chips(page)).join(), /^kind crash \S$/);
  assert.equal(await search(page).inputValue(), "");
  assert.equal(await rowsTold(page), crashes);
  await search(page).press("ArrowDown");
  await page.keyboard.press("Escape");
  assert.equal(await page.locator("#suggestions").isVisible(), false);
  await page.locator(".filters .chip").click();
  assert.equal(await rowsTold(page), report.findings.length);
}

/** Filters and search reach both tables, and what they show stands in the address. */
async function keepsWhatIsShown(page, report) {
  const steps = await page.evaluate(() => history.length);
  await chooseFilter(page, "distance outside");
  const causes = await causesShown(page);
  assert.ok(causes.length > 0 && causes.length < report.buckets.length);
  assert.ok(causes.every((key) => key.includes("distance_outside")));
  await search(page).pressSequentially("ode");
  const found = await rowsTold(page);
  await page.locator(".findings th", { hasText: "margin" }).getByRole("button").click();
  await settled(page);
  assert.equal(await page.evaluate(() => history.length), steps, "nothing for the Back button");
  const [top] = await page.locator(".findings tbody td.c-id").allInnerTexts();
  await page.reload();
  assert.equal(await rowsTold(page), found);
  assert.equal((await page.locator(".findings tbody td.c-id").allInnerTexts())[0], top);
  assert.equal(await search(page).inputValue(), "ode");
  assert.match((await chips(page)).join(), /^kind distance outside \S$/);
  await page.locator(".findings tbody tr[tabindex='0']").click();
  await page.waitForSelector(".detail h2");
  await page.goBack();
  assert.equal(await rowsTold(page), found, "Back finds it as it was");
  await page.getByRole("button", { name: "Clear" }).click();

  const rowsOfText = async (text) => (await search(page).fill(text), rowsTold(page));
  const of = (passes) => report.findings.filter(passes).length;
  const disjoint = of((f) => f.kind === "wrong_disjoint");
  assert.equal(await rowsOfText("wrong disjoint"), disjoint);
  assert.equal(await rowsOfText("wrong_disjoint"), disjoint);
  const family = of((f) => f.family === "touching_side_rim");
  assert.equal(await rowsOfText("touching_side_rim"), family);
  assert.ok((await rowsOfText("touching side rim")) >= family);
  assert.equal(
    await rowsOfText("beyond its claim"),
    of((f) => f.severity === "contract"),
  );
  const both = of((f) => f.severity === "contract" && f.family === "touching_side_rim");
  assert.equal(await rowsOfText("touching_side_rim  Beyond its claim"), both);
  assert.ok(await rowsOfText("known upstream"), "why a cause is suppressed");
  assert.equal((await causesShown(page)).length, 1);
  await search(page).fill("");
  await settled(page);
}

/** The rows on the screen, as the texts of one column. */
const column = async (page, name) => (
  await settled(page),
  page.locator(`.findings tbody td.c-${name}`).allInnerTexts()
);

async function readsTheFindings(page) {
  assert.equal(await rowsTold(page), 400);
  assert.ok((await page.locator(".findings tbody tr").count()) < 60, "only the rows on the screen are elements");
  await chooseFilter(page, "crash");
  assert.ok((await column(page, "kind")).every((kind) => kind === "crash"));
  await page.getByRole("button", { name: "Clear" }).click();
  assert.equal(await rowsTold(page), 400);

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

/** The drawing as it is in the page. */
const drawing = async (page) => (await settled(page), page.locator(".stage .projection").innerHTML());

async function looksAndProves(page) {
  const whole = await drawing(page),
    box = await page.locator(".stage .projection").boundingBox();
  assert.ok(box.width > 300 && box.height > 300, JSON.stringify(box));
  assert.ok((await page.locator(".stage .projection path").count()) >= 6);
  await page.getByRole("button", { name: "Contact" }).click();
  assert.notEqual(await drawing(page), whole, "close up, it looks another way");
  await page.getByRole("button", { name: "Whole pair" }).click();
  assert.equal(await drawing(page), whole);

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
  await page.getByRole("button", { name: "Reset" }).click();
  await page.locator(".prove").click();
  await settled(page);
  assert.equal(await page.locator(".proof").getAttribute("data-holds"), "true");
}

async function readsACause(page) {
  await page.locator(".causes a").first().click();
  await page.waitForSelector(".tabs");
  await looksAndProves(page);
  await page.getByRole("tab", { name: "Worst" }).click();
  await settled(page);
  assert.equal(await page.getByRole("tab", { name: "Worst" }).getAttribute("aria-selected"), "true");
  await looksAndProves(page);
}

async function readsANarrowGap(page, report) {
  const narrow = report.findings.find((f) => report.cases[f.case].margin[0] < 1e-11);
  await page.evaluate((id) => {
    location.hash = `#/finding/${id}`;
  }, narrow.id);
  await page.waitForSelector(".pair-view figcaption .warn");
  assert.match(
    await page.locator(".pair-view figcaption").innerText(),
    /^Not to scale: the (gap|overlap) of \S+ is drawn \S+ times as wide/,
  );
  const wide = await drawing(page);
  await page.getByRole("button", { name: /^Widen/ }).click();
  await settled(page);
  assert.match(await page.locator(".pair-view figcaption").innerText(), /^To scale/);
  assert.notEqual(await drawing(page), wide);
}

async function followsAHeatCell(page) {
  await page.evaluate(() => {
    location.hash = "#/new";
  });
  await page.locator("td.heat.bad a").first().click();
  await page.waitForFunction(() => location.hash.startsWith("#/findings?"));
  await settled(page);
  const chosen = await page.evaluate(() => new URLSearchParams(location.hash.split("?")[1]).get("family"));
  assert.ok((await chips(page)).some((chip) => chip.startsWith(`family ${chosen.replaceAll("_", " ")} `)));
}

async function drawsEveryPlot(page) {
  for (const [id, plots] of [
    ["speed", 1],
    ["maps", 1],
    ["calibration", 1],
    ["stability", 2],
  ]) {
    await page.locator(`section#${id}`).scrollIntoViewIfNeeded();
    for (const plot of await page.locator(`section#${id} .plot`).all()) await plot.scrollIntoViewIfNeeded();
    await page.waitForFunction(
      ([id, plots]) => document.querySelectorAll(`#${id} .plot svg`).length === plots,
      [id, plots],
    );
  }
  const ticks = await page.evaluate(() =>
    [...document.querySelectorAll("#charts .plot [aria-label$='tick label']")].map(
      (axis) => [...axis.querySelectorAll("text")].filter((t) => t.textContent !== "").length,
    ),
  );
  assert.ok(ticks.length >= 11 && ticks.every((told) => told > 1), `words on each axis: ${ticks}`);
  assert.equal(await page.locator(".missing").count(), 0, "the made-up run has everything");
}

/** A point leads to its method's findings, a cell of a map to a case; the pointer shows the numbers. */
async function followsThePlots(page) {
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
  assert.match((await chips(page)).join(), /^library ode \S$/);
  assert.ok((await column(page, "method")).every((m) => m === "ode"));
}

async function fitsALaptop(page) {
  await page.evaluate(() => {
    location.hash = "#/new";
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

/** No two words of a plot overlap, and no name of a library covers a mark, on three widths of screen. */
async function overprintsNothing() {
  for (const width of [400, 900, 1366]) {
    const page = await openPage({ width });
    await page.locator("#speed .plot").first().waitFor({ state: "attached" });
    for (const plot of await page.locator("#charts .plot").all()) await plot.scrollIntoViewIfNeeded();
    await settled(page);
    const overlaps = await page.evaluate(() => {
      const slack = 1; // boxes are a little larger than letters
      const meet = (a, b) =>
        a.left + slack < b.right && b.left + slack < a.right && a.top + slack < b.bottom && b.top + slack < a.bottom;
      return [...document.querySelectorAll("#charts .plot svg")].flatMap((svg) => {
        const texts = [...svg.querySelectorAll("text")].filter((t) => t.textContent.trim().length > 1),
          marks = svg.closest("#speed") ? [...svg.querySelectorAll("[aria-label=dot] :is(circle, path)")] : [];
        return texts.flatMap((text, i) =>
          [...texts.slice(i + 1), ...marks]
            .filter((other) => meet(text.getBoundingClientRect(), other.getBoundingClientRect()))
            .map((other) => `${text.textContent} / ${other.textContent || other.tagName}`),
        );
      });
    });
    assert.deepEqual(overlaps, [], `at ${width}`);
    assert.ok((await page.locator("#speed .plot text").count()) > 15, "there are words to overlap");
    await page.context().close();
  }
}

/** All words stand out from what is behind them by 4.5 at least and all marks by 3, light and dark. */
async function canBeRead(report) {
  for (const scheme of ["light", "dark"]) {
    const page = await openPage({ scheme });
    await page.getByRole("button", { name: "Unfold all methods" }).click();
    await search(page).focus();
    await page.keyboard.press("ArrowDown");
    for (const plot of await page.locator("#charts .plot").all()) await plot.scrollIntoViewIfNeeded();
    for (const hash of ["", "#/finding/15", `#/bucket/${report.buckets[2].key}`]) {
      if (hash !== "") {
        await go(page, hash);
        await page.waitForSelector(".detail .case");
      }
      await settled(page);
      const least = await assertContrast(page, `${scheme} ${hash}`);
      console.log(`contrast, ${scheme} ${hash}: ${JSON.stringify(least)}`);
      assert.ok(least.word[1] > 50 && least.mark[1] > (hash === "" ? 2000 : 4), JSON.stringify(least));
    }
    await page.context().close();
  }
}

const copied = (page, label) =>
  page
    .locator(".copy", { has: page.locator(".copy-head", { hasText: label }) })
    .locator("code")
    .innerText();

/** The commands and lines of a cause, its nights and its claim. */
async function handlesACause(page, report) {
  const shown = report.buckets[2],
    found = report.buckets.find((b) => b.simplified === false);
  await go(page, `#/bucket/${shown.key}`);
  await page.waitForSelector(".handling");
  assert.equal(await copied(page, "For the maintainers"), `./daylight export runs/sample ${shown.key} --out upstream`);
  assert.deepEqual(JSON.parse(await copied(page, "suppressions.jsonl")), {
    bucket: shown.key,
    reason: "",
    link: "",
    owner: "",
    expires: "2027-02-20",
  });
  assert.deepEqual(JSON.parse(await copied(page, "a line for daylight check")), shown.simplest.pair);
  assert.match(await page.locator(".detail .right .facts").first().innerText(), /margins\s+\S+ up to 0.01 or more/i);
  assert.equal(await page.getByRole("tab", { name: "Simplest" }).count(), 1);

  assert.equal(await page.locator(".nights .night").count(), shown.nights.length);
  assert.match(
    await page.locator(".nights .night title").last().textContent(),
    /20261122-220000-4[^]*of 280,000 pairs/,
  );
  const [before, p] = [page.locator(".against tbody tr").first(), page.locator(".same-rate")];
  assert.match(await before.innerText(), /20261121/);
  const first = await p.innerText();
  await page.getByLabel("Compared with").selectOption("0");
  await settled(page);
  assert.match(await before.innerText(), /20261119[^]*250,000/);
  assert.notEqual(await p.innerText(), first);
  assert.match(await page.locator(".detail").innerText(), /of 280,000 pairs[^]*versions\s+1\.1\s[^]*(stated|assumed)/);

  await go(page, `#/bucket/${found.key}`);
  await page.waitForFunction((key) => document.querySelector(".detail h2")?.textContent === key, found.key);
  assert.equal(await page.getByRole("tab", { name: "As found" }).count(), 1);
  assert.equal(await page.getByRole("tab", { name: "Simplest" }).count(), 0);
}

async function downloadOf(page, name) {
  const [file] = await Promise.all([
    page.waitForEvent("download"),
    page.locator(".saving").getByRole("button", { name }).click(),
  ]);
  return { name: file.suggestedFilename(), text: readFileSync(await file.path(), "utf8") };
}

/** What is filtered, and nothing else, is saved. */
async function savesWhatIsShown(page, report) {
  await go(page, "#/findings?kind=crash");
  const shown = report.findings.filter((f) => f.kind === "crash");
  assert.equal(await rowsTold(page), shown.length);
  const csv = await downloadOf(page, "CSV");
  assert.equal(csv.name, "sample-findings.csv");
  const lines = csv.text.trimEnd().split("\r\n");
  assert.equal(lines.length, shown.length + 1);
  assert.ok(lines.every((line) => line.split(",").length === 32));
  const some = lines.find((line) => line.startsWith(`${shown[0].id},`)).split(",");
  const { a, b } = report.cases[shown[0].case].pair;
  assert.deepEqual(
    some.slice(16).map(Number),
    [a, b].flatMap((c) => [...c.center, ...c.axis, c.radius, c.height]),
  );
  const json = JSON.parse((await downloadOf(page, "JSON")).text);
  assert.deepEqual(json.map((f) => f.id).sort(), shown.map((f) => f.id).sort());
  assert.ok(json.every((f) => f.pair.a.radius > 0 && f.kind === "crash"));
  await page.getByRole("button", { name: "Clear" }).click();
}

/** A wrong distance is shown with all its digits, and who else is outside. */
async function measuresAWrongDistance(page, report) {
  const f = report.findings.find((f) => f.kind === "distance_outside" && f.method !== "mujoco-tol1e-10"),
    { truth, pair } = report.cases[f.case];
  await go(page, `#/finding/${f.id}`);
  await page.waitForSelector(".wrong-distance");
  const told = await page.locator(".wrong-distance").innerText();
  for (const end of truth.distance) assert.ok(told.includes(end.toExponential(16).replace("e+0", "")), told);
  const error = 1e-5 * f.id,
    size = pair.a.radius + pair.a.height + pair.b.radius + pair.b.height;
  const facts = await page.locator(".wrong-distance dd").allInnerTexts();
  const value = (text) => parseFloat(text.replace(",", ""));
  assert.ok(Math.abs(value(facts[2]) / error - 1) < 1e-3);
  assert.ok(Math.abs(value(facts[3]) / (error / size) - 1) < 1e-3);
  assert.ok(Math.abs(value(facts[4]) / (error / 1e-6) - 1) < 1e-3);
  assert.equal(facts[5], "1e-6 its claim");
  const red = await page.locator(".answers td:last-child span.bad").allInnerTexts();
  assert.ok(red.includes(f.method) && red.includes("bullet-cylinder"), red.join());
  assert.ok(!red.includes("fcl-indep"), "within its claim");
  const numbers = (await page.locator(".detail :is(.answers, .solids)").allInnerTexts()).join(" ");
  assert.doesNotMatch(numbers, /\b(0\.000\d{10,}|\d{6,}\.\d{8,})/, "long numbers have exponents");
  assert.match(numbers, /\d\.\d{13,}e/);
  await go(page, "#/findings");
  await page.waitForSelector("main.overview:not([hidden])");
  assert.match(await page.locator("#findings .lead").innerText(), /error over the size[^]*signed distance/);
  await page.getByLabel("Search causes and findings").fill(`#${f.id}`);
  await settled(page);
  const shown = await page.locator(".findings tbody tr[tabindex]").allInnerTexts();
  const own = shown.find((text) => text.startsWith(`${f.id}\t`));
  assert.ok(Math.abs(Number(own.split("\t")[5]) / f.margin[0] - 1) < 1e-2, own);
  await page.getByRole("button", { name: "Clear" }).click();
}

/** Every head and fact says what it means, and the page ends with all words, folded. */
async function explainsItsWords(page) {
  const silent = () =>
    page.evaluate(() =>
      [...document.querySelectorAll("main:not([hidden]) :is(thead th, dl.facts dt, .prover h3 span)")]
        .filter((e) => e.textContent.trim() !== "" && !e.title)
        .map((e) => e.textContent),
    );
  assert.deepEqual(await silent(), []);
  const text = await page.locator("main.overview").textContent();
  assert.ok((await page.locator("#words dt").count()) > 60);
  for (const title of await page.locator(".causes th").evaluateAll((all) => all.map((e) => e.title)))
    assert.ok((await page.locator("#words").textContent()).includes(title));
  for (const old of [
    /\bcontract\b/,
    /\bresolution\b/,
    /\bstratum\b/i,
    /misstated/,
    /kept with their pair/,
  ])
    assert.doesNotMatch(text, old);
  assert.match(await page.locator("#methods").textContent(), /stated[^]*assumed by us/);
  for (const hash of ["#/finding/15", "#/finding/1"]) {
    await go(page, hash);
    await page.waitForSelector(".detail .case");
    await settled(page);
    assert.deepEqual(await silent(), []);
    assert.match(await page.locator(".detail > .soft").first().innerText(), /\((stated|assumed by us): /);
  }
  await page.locator(".crumbs a").nth(1).click();
  await page.waitForSelector(".handling");
  assert.deepEqual(await silent(), []);
  await go(page, "#/new");
}

/** On a telephone nothing but tables in boxes of their own is wider than the screen. */
async function fitsATelephone(report) {
  const page = await openPage({ width: 400 });
  const wide = () => page.evaluate(() => document.documentElement.scrollWidth);
  await settled(page);
  for (const id of ["new", "findings", "speed", "maps", "calibration", "stability", "methods", "words"])
    await page.locator(`#${id}`).scrollIntoViewIfNeeded();
  await page.evaluate(() => {
    for (const details of document.querySelectorAll("details")) details.open = true;
  });
  await settled(page);
  assert.ok((await wide()) <= 400, `${await wide()} wide`);
  const card = page.locator(".causes tbody tr").first();
  assert.ok((await card.boundingBox()).height > 100, "a cause is a card");
  assert.match(
    await card
      .locator("td")
      .nth(2)
      .evaluate((e) => getComputedStyle(e, "::before").content),
    /findings/,
  );
  for (const hash of ["#/finding/15", `#/bucket/${report.buckets[2].key}`]) {
    await go(page, hash);
    await page.waitForSelector(".detail .case");
    await settled(page);
    assert.ok((await wide()) <= 400, `${hash} is ${await wide()} wide`);
  }
  await page.context().close();
}

/** Paper has every plot and nothing folded. */
/** Many methods with the same right answer are a line that unfolds; those that are wrong have their names. */
async function foldsTheNamesOfManyMethods() {
  const report = sample(8),
    [one] = report.cases,
    { verdict } = one.truth;
  const from = (first, last) => Array.from({ length: last - first }, (_, i) => first + i);
  one.said = [
    [{ verdict }, from(0, 10)],
    [{ verdict: verdict === "disjoint" ? "intersecting" : "disjoint" }, from(10, report.names.length)],
  ];
  const rightOnes = report.names.slice(0, 10).filter((name) => name !== report.findings[0].method);
  write(report);
  const page = await openPage();
  await go(page, "#/finding/1");
  const folded = page.locator(".answers details");
  await page.waitForSelector(".answers tr");
  assert.equal(await folded.count(), 1);
  assert.match(await folded.innerText(), /^9 methods of \d libraries$/);
  assert.equal(await page.locator(".answers span.bad:visible").count(), report.names.length - 10);
  await folded.locator("summary").click();
  assert.ok((await folded.innerText()).endsWith(rightOnes.join(", ")));
  await page.context().close();
}

/** As many rows and families as a real run has. */
function longReport() {
  const report = sample(400);
  const often = (of, times) =>
    Array.from({ length: times }, (_, i) => of.map((x) => ({ ...x, method: `${x.method}-${i}` }))).flat();
  const more = Array.from({ length: 10 }, (_, i) => ({ name: `more_${i}`, summary: "more pairs" }));
  return {
    ...report,
    paths: often(report.paths, 60),
    families: [...report.families, ...more],
    tallies: [...report.tallies, ...more.flatMap(({ name }) =>
      report.methods.map((m) => ({ ...report.tallies[0], method: m.name, family: name })))],
  };
}

async function printsAll() {
  write(longReport());
  const page = await openPage();
  await settled(page);
  assert.ok((await page.locator(".plot:not(:has(svg))").count()) > 0, "far plots are not drawn on the screen");
  const [empty, folded] = await page.evaluate(() => {
    dispatchEvent(new Event("beforeprint"));
    return [".plot:not(:has(svg))", "details.print:not([open])"].map((s) => document.querySelectorAll(s).length);
  });
  assert.deepEqual([empty, folded], [0, 0]);
  await page.emulateMedia({ media: "print" });
  await page.setViewportSize({ width: 717, height: 1000 });
  await settled(page);
  const wide = await page.evaluate(() => document.documentElement.scrollWidth);
  assert.ok(wide <= 717, `${wide} wide on paper`);
  const table = await page.locator(".heat-table").boundingBox();
  assert.ok(table.x + table.width <= 717, `methods against families end at ${table.x + table.width}`);
  await page.evaluate(() => dispatchEvent(new Event("afterprint")));
  assert.ok((await page.locator("details.print:not([open])").count()) > 0);
  const pdf = (await page.pdf({ format: "A4" })).toString("latin1");
  const pages = pdf.match(/\/Type\s*\/Page\b/g).length; // a /Count may be of a part of them
  assert.ok(pages <= 8, `${pages} pages`);
  await page.context().close();
}

const focused = (page) =>
  page.evaluate(() => {
    const e = document.activeElement;
    return {
      tag: e.tagName,
      text: e.textContent,
      leads: e.dataset.leads ?? e.getAttribute("href"),
      class: e.className,
    };
  });

/** By keyboard alone from the top to a proved finding, and back to where one was. */
async function goesByKeyboard() {
  const page = await openPage();
  await page.waitForSelector(".findings tbody tr[tabindex='0']");
  await settled(page);
  let presses = 0;
  const press = async (key) => (++presses, await page.keyboard.press(key), settled(page));
  await press("Tab");
  assert.match((await focused(page)).text, /^Skip to the findings/);
  await press("Enter");
  await press("ArrowDown");
  const { leads } = await focused(page);
  assert.match(leads, /^#\/finding\/\d+$/);
  await press("Enter");
  await page.waitForSelector(".detail h2");
  await settled(page);
  assert.equal((await focused(page)).tag, "H2");
  while ((await focused(page)).class !== "prove" && presses < 15) await press("Tab");
  await press("Enter");
  assert.equal(await page.locator(".proof").getAttribute("data-holds"), "true");
  assert.ok(presses <= 15, `${presses} keys`);
  const picture = page.locator(".stage .projection");
  assert.equal(await picture.getAttribute("role"), "img");
  assert.match(await picture.getAttribute("aria-label"), /^Cylinder a and cylinder b, (disjoint|intersecting), /);
  await page.goBack();
  await settled(page);
  assert.equal((await focused(page)).leads, leads, "back on its row");

  for (const table of [".heat-table", ".causes", ".findings"])
    assert.equal(await page.locator(`${table} [tabindex='0']`).count(), 1, `${table} is one stop`);
  await page.locator(".causes [tabindex='0']").focus();
  const first = await focused(page);
  await page.keyboard.press("ArrowDown");
  const second = await focused(page);
  assert.notEqual(second.leads, first.leads);
  assert.equal(await page.locator(".causes [tabindex='0']").getAttribute("href"), second.leads);
  await page.keyboard.press("Enter");
  await page.waitForSelector(".detail h2");
  await settled(page);
  assert.equal((await focused(page)).tag, "H2");
  await page.goBack();
  await settled(page);
  assert.equal((await focused(page)).leads, second.leads);
  await page.keyboard.press("Home");
  await page.keyboard.press("ArrowRight");
  assert.equal((await focused(page)).text, "largest margin", "the heads are in it");

  await page.locator(".heat-table [tabindex='0']").focus();
  for (let i = 0; i < 4 && (await focused(page)).leads === null; ++i) {
    await page.keyboard.press("ArrowDown");
    await page.keyboard.press("ArrowRight");
  }
  assert.match((await focused(page)).leads, /^#\/findings\?/);
  await page.keyboard.press("Enter");
  await settled(page);
  assert.ok((await chips(page)).some((chip) => chip.startsWith("family ")));
  await page.context().close();
}

/** What a run without triage and bench has: each gap names the command that fills it. */
async function saysWhatIsMissing() {
  write({
    ...sample(40),
    buckets: [],
    maps: [],
    honesty: [],
    speed: [],
    cost: [],
    paths: [],
    history: null,
  });
  const page = await openPage();
  assert.match(await page.locator("#new .missing code").innerText(), /^\.\/daylight triage /);
  const folded = page.locator("#charts .missing");
  assert.match(await folded.locator("summary").innerText(), /^This run has no failure maps, calibration curves, times, costs [^,]*, answers/);
  const commands = await folded.locator("code").allTextContents();
  assert.equal(commands.length, 3);
  assert.ok(
    commands.every((c) => c.startsWith("./daylight ")),
    commands.join(),
  );
  for (const id of ["speed", "maps", "calibration", "stability"])
    assert.equal(await page.locator(`section#${id}`).count(), 0, `${id} without data takes no room`);
  await page.context().close();
}

/** Without causes of earlier runs there are no standings, no chances and no nights. */
async function opensAFirstRun() {
  const first = { ...sample(40), changes: null };
  first.buckets = first.buckets.filter((b) => b.standing !== "gone");
  for (const b of first.buckets) {
    Object.assign(b, { chance: null, nights: [], standing: null, simplified: true });
    b.first_version = b.last_version = "";
  }
  write(first);
  const page = await openPage();
  assert.equal(await rowsTold(page), 40);
  const told = await page.locator("#new").innerText();
  assert.match(told, /Compared with 3 earlier runs/);
  assert.match(told, /There are no causes of earlier runs to compare with/);
  assert.doesNotMatch(told, /There is no earlier run/);
  await page.locator(".causes a").first().click();
  await page.waitForSelector(".handling");
  assert.equal(await page.getByRole("tab", { name: "Simplest" }).count(), 1);
  assert.equal(await page.locator(".nights").count(), 0);
  assert.doesNotMatch(await page.locator("body").innerText(), /undefined|NaN|\[object/);
  await go(page, "#/finding/1");
  await page.waitForFunction(() => /^#1 /.test(document.querySelector(".detail h2")?.textContent));
  assert.doesNotMatch(await page.locator("body").innerText(), /undefined|NaN|\[object/);
  await page.context().close();
}

/** Text of a store may be anything. */
async function showsHostileTextAsText() {
  const hostile = "</script><img src=x onerror=alert(1)>\u202e\u0001",
    report = sample(8);
  Object.assign(report.run, { id: hostile, seed: hostile, status: hostile, build: hostile, command: hostile });
  report.findings.forEach((f) => Object.assign(f, { method: hostile, family: hostile, reason: hostile }));
  report.methods[0].name = report.methods[0].claim.source = hostile;
  report.cases[0].note = hostile;
  report.changes.against = [hostile];
  for (const b of report.buckets) {
    Object.assign(b, { key: `${b.key}${hostile}`, method: hostile, cause: hostile, labels: [hostile], file: hostile });
    Object.assign(b, { methods: [hostile], first_version: hostile, last_version: "", feature: hostile });
    for (const night of b.nights) night.run = night.started = hostile;
  }
  report.findings.forEach((f) => Object.assign(f, { bucket: f.bucket && `${f.bucket}${hostile}` }));
  write(report);
  const page = await openPage();
  await page.evaluate(() => {
    location.hash = "#/finding/1";
  });
  await page.waitForSelector(".case");
  const harmless = async () => {
    assert.equal(await page.locator("img").count(), 0);
    assert.ok(!(await page.locator("body").innerText()).includes("\u202e"));
  };
  await harmless();
  await page.locator(".crumbs a").nth(1).click();
  await page.waitForSelector(".handling");
  await harmless();
  await page.goBack();
  await go(page, "#/findings");
  await page.waitForSelector("main.overview:not([hidden])");
  await harmless();
  await page.context().close();
}

/** The drawing of two points next to each other, and of a certificate beyond doubles, is no error. */
async function drawsTheExtreme() {
  const report = sample(8),
    far = `1${"0".repeat(400)}`;
  const dot = (z) => ({ center: [0, 0, z], axis: [0, 0, 1], radius: 0, height: 0 });
  const nearest = { a: [0, 0, 0], b: [0, 0, 5e-324] };
  const truth = { verdict: "disjoint", direction: [0, 0, 1], distance: [0, 1e-323] };
  Object.assign(report.cases[0], { pair: { a: dot(0), b: dot(5e-324) }, truth, nearest, direction: [0, 0, 1] });
  Object.assign(report.cases[1], { truth: { ...truth, direction: [far, far, "0"] }, direction: undefined });
  write(report);
  const page = await openPage();
  for (const id of [1, 5]) {
    await go(page, `#/finding/${id}`);
    await page.waitForFunction((id) => document.querySelector(".detail h2")?.textContent.startsWith(`#${id} `), id);
    await settled(page);
  }
  await page.context().close();
}

async function test() {
  const report = sample(400);
  write(report);
  const page = await openPage();
  for (const step of [
    (p) => leadsToWhatIsNew(p, report),
    (p) => suggestsFilters(p, report),
    (p) => keepsWhatIsShown(p, report),
    readsTheFindings,
    readsACause,
    (p) => readsANarrowGap(p, report),
    followsAHeatCell,
    drawsEveryPlot,
    followsThePlots,
    fitsALaptop,
    (p) => handlesACause(p, report),
    (p) => savesWhatIsShown(p, report),
    (p) => measuresAWrongDistance(p, report),
    explainsItsWords,
  ])
    await step(page);
  await page.context().close();
  await overprintsNothing();
  await canBeRead(report);
  await fitsATelephone(report);
  await printsAll();
  await foldsTheNamesOfManyMethods();
  write(report);
  await goesByKeyboard();
  assert.deepEqual(errors, []);
  await opensAFirstRun();
  await saysWhatIsMissing();
  await showsHostileTextAsText();
  await drawsTheExtreme();
  assert.deepEqual(errors, []);
  assert.deepEqual(asked, [], "nothing is asked from the network");
}

await test();
console.log("page_test: all well");
await browser.close();
