// SPDX-License-Identifier: MIT
// A reader of the page: opens it from disk in a browser without network, filters, opens findings and causes, looks at
// the drawing, proves again and tampers.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { deflateSync } from "node:zlib";
import { sample, untriaged } from "./sample.mjs";

function skip(why) {
  const file = fileURLToPath(new URL("../../../.ci/skip", import.meta.url));
  process.exit(spawnSync(file, [why], { stdio: "inherit" }).status ?? 1);
}
const executablePath =
  ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"].find(existsSync) ??
  skip("no chromium here: apt-get install chromium");
const { chromium } = await import("playwright-core").catch(() =>
  skip("no playwright-core here: npm ci --prefix reports/web"),
);

const folder = mkdtempSync(join(tmpdir(), "daylight-page-"));
process.on("exit", () => rmSync(folder, { recursive: true }));
/** The longest wait, in ms, for what never comes. A slow machine is not that. */
const patience = 300_000;
const browser = await chromium.launch({ executablePath, timeout: patience });
/** What any page wrote on its console as an error, and what it asked of the network. */
const errors = [],
  asked = [];

/** The page with data in it, as reports/run/page_template.cpp fills it, opened. */
async function open(report, { scheme = "light", width = 1366, hash = "" } = {}) {
  const template = readFileSync(new URL("../page_template.html", import.meta.url), "utf8"),
    data = deflateSync(JSON.stringify(report)).toString("base64"),
    file = join(folder, "report.html");
  writeFileSync(file, template.replace("@@DAYLIGHT_REPORT_DATA@@", () => data));
  const context = await browser.newContext({ colorScheme: scheme, viewport: { width, height: 850 }, offline: true });
  context.setDefaultTimeout(patience);
  const page = await context.newPage();
  page.on("console", (m) => m.type() === "error" && errors.push(m.text()));
  page.on("pageerror", (e) => errors.push(String(e)));
  page.on("request", (r) => /^(file|data|blob):/.test(r.url()) || asked.push(r.url()));
  await page.goto(pathToFileURL(file).href + hash);
  await page.waitForSelector("main");
  return page;
}
const closed = (page) => page.context().close();

/** Until what was done is drawn. */
const settled = (page) =>
  page.evaluate(
    () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 60)))),
  );
const go = async (page, hash) => {
  await page.evaluate((to) => {
    location.hash = to;
  }, hash);
  await settled(page);
};
const hashOf = (page) => page.evaluate(() => location.hash);
const textOf = async (page, selector) => (await page.locator(selector).first().innerText()).replace(/\s+/g, " ");
const rowsTold = async (page) => (
  await settled(page),
  Number((await textOf(page, ".filters [role=status]")).split(" ")[0].replaceAll(",", ""))
);
const causesShown = async (page) => (await page.locator(".causes tbody a").allInnerTexts()).sort();
const field = (page) => page.getByLabel("Text of causes and findings");
const copied = (page, label) =>
  page
    .locator(".copy", { has: page.locator(".copy-head", { hasText: label }) })
    .locator("code")
    .innerText();
const causesOf = (report, passes) => report.buckets.filter(passes).map((b) => b.key).sort();

/** A run with the standing of each cause that is beyond its claim. */
const standing = (word) => {
  const report = sample();
  for (const b of report.buckets) b.standing = b.severity === "contract" ? word : "known";
  return report;
};

/** The page begins with its answer: red if something is new, amber if chance cannot be excluded, else green. The table
 *  of causes begins with these. */
async function beginsWithTheAnswer() {
  const suppressed = standing("new");
  for (const b of suppressed.buckets) b.suppressed = { reason: "r", link: "l", owner: "o", expires: "2027-01-01" };
  for (const [word, kind, head, report = standing(word)] of [
    ["new", "bad", /^6 new faults: \S+/],
    ["back", "bad", /^6 new faults: /],
    ["rare", "warn", /^6 causes were not seen before; chance cannot be excluded/],
    ["known", "ok", /^Nothing is new and wrong\. Compared with 1 earlier run/],
    ["new", "ok", /^Nothing is new and wrong\./, suppressed],
  ]) {
    const page = await open(report),
      band = page.locator("main.overview > section").first().locator(".band");
    assert.match((await band.innerText()).replace(/\s+/g, " "), head);
    assert.match(await band.getAttribute("class"), new RegExp(`\\b${kind}\\b`));
    const first = page.locator(".causes tbody tr").first();
    assert.equal(await first.locator("td").first().innerText(), word);
    if (kind !== "ok")
      assert.equal(
        await band.locator("a").first().getAttribute("href"),
        await first.locator("a").first().getAttribute("href"),
      );
    await closed(page);
  }
}

/** Before triage too; each gap has the command that fills it. */
async function answersBeforeTriage() {
  const page = await open(untriaged());
  assert.match(await textOf(page, ".band"), /^\d libraries are wrong beyond the claim: [a-z0-9, ]+/);
  assert.match(await textOf(page, "#new .missing code"), /^\.\/daylight triage runs\/sample$/);
  assert.match(await textOf(page, "#charts .missing"), /^This run has no failure maps, calibration curves, times, paths\./);
  for (const chart of ["speed", "maps", "calibration", "stability"])
    assert.equal(await page.locator(`section#${chart}`).count(), 0, `${chart} without data takes no room`);
  assert.doesNotMatch(await page.locator("body").innerText(), /undefined|NaN|\[object/);
  await closed(page);
}

/** Text and selections reach both tables, and what they show stands in the address. */
async function filters(page, report) {
  assert.equal(await rowsTold(page), report.findings.length);
  assert.deepEqual(await causesShown(page), causesOf(report, () => true));
  const steps = await page.evaluate(() => history.length);
  const ode = report.findings.filter((f) => f.method.startsWith("ode"));
  await page.locator(".filters").getByLabel("Library").selectOption("ode");
  assert.equal(await rowsTold(page), ode.length);
  assert.deepEqual(await causesShown(page), causesOf(report, (b) => b.methods.some((m) => /^ode/.test(m))));
  await field(page).pressSequentially("wrong_disjoint");
  const found = ode.filter((f) => f.kind === "wrong_disjoint").length;
  assert.equal(await rowsTold(page), found);
  assert.equal(await hashOf(page), "#/findings?library=ode&text=wrong_disjoint");
  assert.equal(await page.evaluate(() => history.length), steps, "nothing for the Back button");
  await page.reload();
  assert.equal(await rowsTold(page), found);
  assert.equal(await field(page).inputValue(), "wrong_disjoint");
  const link = page.locator(".findings tbody a").nth(2),
    address = await link.getAttribute("href");
  await link.click();
  await page.waitForSelector(".detail h2");
  await page.goBack();
  assert.equal(await rowsTold(page), found, "Back finds it as it was");
  assert.equal(await page.evaluate(() => document.activeElement.getAttribute("href")), address, "and where");
  await page.getByRole("button", { name: "Clear" }).click();
  assert.equal(await rowsTold(page), report.findings.length);
  await page.getByRole("button", { name: /^Show all/ }).click();
  assert.equal(await page.locator(".findings tbody tr").count(), report.findings.length);
  await page.locator(".heat-table td a").first().click();
  await settled(page);
  const family = new URLSearchParams((await hashOf(page)).split("?")[1]).get("family");
  assert.equal(await page.locator(".filters").getByLabel("Family").inputValue(), family);
  await page.getByRole("button", { name: "Clear" }).click();
}

/** The drawing as it is in the page. */
const drawing = async (page) => (await settled(page), page.locator(".stage .projection").innerHTML());
const holds = async (page) => {
  await page.locator(".prove").click();
  await settled(page);
  return page.locator(".proof").getAttribute("data-holds");
};

async function looksAndProves(page) {
  const whole = await drawing(page),
    box = await page.locator(".stage .projection").boundingBox();
  assert.ok(box.width > 300 && box.height > 300, JSON.stringify(box));
  assert.ok((await page.locator(".stage .projection path").count()) >= 6);
  await page.getByRole("button", { name: "Contact" }).click();
  assert.notEqual(await drawing(page), whole, "close up, it looks another way");
  await page.getByRole("button", { name: "Whole pair" }).click();
  assert.equal(await drawing(page), whole);

  assert.equal(await holds(page), "true");
  const certificate = page.locator(".prover textarea"),
    { verdict } = JSON.parse(await certificate.inputValue());
  const forged = verdict === "disjoint" ? { direction: [0, 0, 0] } : { point: [1e300, 5, 0] };
  await certificate.fill(JSON.stringify({ verdict, ...forged }));
  await settled(page);
  assert.equal(await page.locator(".proof").count(), 0, "an old proof does not stand beside a new certificate");
  assert.equal(await holds(page), "false");
  await page.getByRole("button", { name: "Reset" }).click();
  assert.equal(await holds(page), "true");
}

async function readsACause(page, report) {
  const b = report.buckets.find((b) => b.severity === "contract" && b.simplified);
  await go(page, `#/bucket/${b.key}`);
  await page.waitForSelector(".tabs");
  await looksAndProves(page);
  await page.getByRole("tab", { name: "Worst" }).click();
  await settled(page);
  assert.equal(await page.getByRole("tab", { name: "Worst" }).getAttribute("aria-selected"), "true");
  assert.equal(await copied(page, "For the maintainers"), `./daylight export runs/sample ${b.key} --out upstream`);
  assert.equal(JSON.parse(await copied(page, "suppressions.jsonl")).bucket, b.key);
  assert.equal(await page.locator(".nights tbody tr").count(), b.nights.length);
  assert.match(await textOf(page, ".nights"), /per million/);

  const narrow = report.findings.find((f) => report.cases[f.case].margin?.[0] > 0 && report.cases[f.case].margin[1] < 1e-9);
  await go(page, `#/finding/${narrow.id}`);
  const caption = () => textOf(page, ".pair-view figcaption");
  assert.match(await caption(), /^Not to scale: the (gap|overlap) of \S+ is drawn \S+ times as wide/);
  await page.getByRole("button", { name: /^Widen/ }).click();
  await settled(page);
  assert.match(await caption(), /^To scale/);
  assert.ok((await page.locator(".answers tbody tr").count()) > 1);
}

async function drawsEveryPlot(page) {
  for (const id of ["speed", "maps", "calibration", "stability"]) {
    await page.locator(`#${id} .plot svg`).first().waitFor();
    const ticks = await page.locator(`#${id} .plot`).evaluate((plot) =>
      [...plot.querySelectorAll("[aria-label$='tick label']")].map((axis) => axis.querySelectorAll("text").length),
    );
    assert.ok(ticks.length >= 2 && ticks.every((n) => n > 1), `words on each axis of ${id}: ${ticks}`);
  }
  assert.match(await page.locator("#speed .plot").textContent(), /right down to a margin of/);
  assert.match(await page.locator("#stability .plot").textContent(), /(part of the size|radians), logarithmic/);
  await page.locator("#maps").getByLabel("Method").selectOption("ode");
  const cell = page.locator("#maps .plot a").first();
  await cell.hover();
  await settled(page);
  assert.match(await page.locator("#maps .plot [aria-label=tip]", { hasText: "asked" }).first().textContent(), /asked/);
  await cell.click();
  await page.waitForSelector(".detail .case");
  await page.goBack();
  const point = page.locator("#speed .plot a", { has: page.locator("[aria-label^=ode]") }).first();
  await point.click();
  await settled(page);
  assert.equal(await hashOf(page), "#/findings?library=ode");
  await page.getByRole("button", { name: "Clear" }).click();
}

/** Every head and fact says what it means, and the page ends with all words, folded. */
async function explainsItsWords(page, report) {
  for (const hash of ["#/new", `#/finding/${report.findings[0].id}`, `#/bucket/${report.buckets[0].key}`]) {
    await go(page, hash);
    const silent = await page.evaluate(() =>
      [...document.querySelectorAll("main:not([hidden]) :is(thead th, dl.facts dt, .prover h3 span)")]
        .filter((e) => e.textContent.trim() !== "" && !e.title)
        .map((e) => e.textContent),
    );
    assert.deepEqual(silent, [], hash);
  }
  const text = (await page.locator("#new, #findings, #speed").allTextContents()).join(" ");
  assert.ok((await page.locator("#words dt").count()) > 50);
  for (const old of [/\bcontract\b/, /\bresolution\b/, /\bstratum\b/i, /ns\/pair/, /correct digits/])
    assert.doesNotMatch(text, old);
  assert.match(await page.locator("#methods").textContent(), /stated[^]*assumed by us/);
}

/** No name of a library meets another one or a mark, and nothing but tables in boxes is wider than the screen. */
async function fitsEveryScreen(report) {
  for (const [width, scheme] of [
    [400, "dark"],
    [900, "light"],
    [1366, "light"],
  ]) {
    const page = await open(report, { width, scheme });
    await page.locator("#speed .plot svg").first().waitFor();
    const overlaps = await page.evaluate(() => {
      const meet = (a, b) => a.left + 1 < b.right && b.left + 1 < a.right && a.top + 1 < b.bottom && b.top + 1 < a.bottom;
      return [...document.querySelectorAll("#charts .plot svg")].flatMap((svg) => {
        const texts = [...svg.querySelectorAll("text")].filter((t) => t.textContent.trim().length > 1);
        return texts.flatMap((text, i) =>
          texts
            .slice(i + 1)
            .filter((other) => meet(text.getBoundingClientRect(), other.getBoundingClientRect()))
            .map((other) => `${text.textContent} / ${other.textContent}`),
        );
      });
    });
    assert.deepEqual(overlaps, [], `at ${width}`);
    await page.evaluate(() => document.querySelectorAll("details").forEach((details) => (details.open = true)));
    for (const hash of ["#/new", `#/finding/${report.findings[0].id}`, `#/bucket/${report.buckets[0].key}`]) {
      await go(page, hash);
      const wide = await page.evaluate(() => document.documentElement.scrollWidth);
      assert.ok(wide <= width, `${hash} is ${wide} wide at ${width}`);
    }
    await go(page, "#/findings");
    const hint = (selector) =>
      page.locator(selector).evaluate((e) => getComputedStyle(e.closest(".scroll"), "::before").content);
    for (const table of [".causes", ".findings", ".heat-table"]) {
      assert.equal(await page.locator(`${table} th:visible`).count(), await page.locator(`${table} th`).count(), table);
      assert.equal((await hint(table)).includes("scroll sideways"), width === 400, table);
    }
    await closed(page);
  }
}

/** By keyboard alone from the top to a proved finding, and back to where one was. */
async function goesByKeyboard(report) {
  const page = await open(report);
  const focused = () => page.evaluate(() => document.activeElement.outerHTML);
  const tabTo = async (what, most) => {
    for (let i = 0; !what.test(await focused()); ++i) {
      assert.ok(i < most, `${what} after ${most} keys`);
      await page.keyboard.press("Tab");
    }
  };
  await tabTo(/^<a [^>]*#\/bucket\//, 8);
  const address = /href="([^"]*)"/.exec(await focused())[1];
  await page.keyboard.press("Enter");
  await page.waitForSelector(".detail h2");
  await settled(page);
  assert.match(await focused(), /^<h2/);
  await tabTo(/class="prove"/, 15);
  await page.keyboard.press("Enter");
  assert.equal(await page.locator(".proof").getAttribute("data-holds"), "true");
  const picture = page.locator(".stage .projection");
  assert.equal(await picture.getAttribute("role"), "img");
  assert.match(await picture.getAttribute("aria-label"), /^Cylinder a and cylinder b, (disjoint|intersecting|touching)/);
  await page.goBack();
  await settled(page);
  assert.ok((await focused()).includes(`href="${address}"`), "back where it was");
  await closed(page);
}

/** Text of a store may be anything. */
async function showsHostileTextAsText() {
  const hostile = "</script><img src=x onerror=alert(1)>\u202e\u0001",
    report = sample();
  Object.assign(report.run, { id: hostile, seed: hostile, status: hostile, build: hostile, command: hostile });
  const [finding] = report.findings;
  for (const f of report.findings) Object.assign(f, { method: hostile, family: hostile, reason: hostile });
  report.methods[0].name = report.methods[0].claim.source = hostile;
  report.cases[finding.case].note = hostile;
  report.changes.against = [hostile];
  for (const b of report.buckets) {
    Object.assign(b, { key: `${b.key}${hostile}`, method: hostile, cause: hostile, labels: [hostile] });
    Object.assign(b, { methods: [hostile], first_version: hostile, last_version: "" });
    for (const night of b.nights) night.run = night.started = hostile;
  }
  finding.bucket = report.buckets[0].key;
  const page = await open(report);
  const harmless = async () => {
    await settled(page);
    assert.equal(await page.locator("img").count(), 0);
    assert.ok(!(await page.locator("body").innerText()).includes("\u202e"));
  };
  await harmless();
  await go(page, `#/finding/${finding.id}`);
  await harmless();
  await page.locator(".crumbs a").nth(1).click();
  await page.waitForSelector(".handling");
  await harmless();
  await closed(page);
}

/** The drawing of two points next to each other, and of a certificate beyond doubles, is no error. */
async function drawsTheExtreme() {
  const report = sample(),
    far = `1${"0".repeat(400)}`;
  const point = (z) => ({ center: [0, 0, z], axis: [0, 0, 1], radius: 0, height: 0 });
  const nearest = { a: [0, 0, 0], b: [0, 0, 5e-324] };
  const truth = { verdict: "disjoint", direction: [0, 0, 1], distance: [0, 1e-323] };
  const [first] = report.findings,
    second = report.findings.find((f) => f.case !== first.case);
  const dots = { pair: { a: point(0), b: point(5e-324) }, truth, nearest, direction: [0, 0, 1] };
  Object.assign(report.cases[first.case], dots);
  Object.assign(report.cases[second.case], { truth: { ...truth, direction: [far, far, "0"] }, direction: undefined });
  const page = await open(report);
  for (const { id } of [first, second]) {
    await go(page, `#/finding/${id}`);
    assert.match(await textOf(page, ".detail h2"), new RegExp(`^#${id} `));
  }
  await closed(page);
}

const report = sample();
await beginsWithTheAnswer();
await answersBeforeTriage();
const page = await open(report);
await filters(page, report);
await readsACause(page, report);
await go(page, "#/charts");
await drawsEveryPlot(page);
await explainsItsWords(page, report);
await closed(page);
await fitsEveryScreen(report);
await goesByKeyboard(report);
await showsHostileTextAsText();
await drawsTheExtreme();
assert.deepEqual(errors, []);
assert.deepEqual(asked, [], "nothing is asked from the network");
console.log("page_test: all well");
await browser.close();
