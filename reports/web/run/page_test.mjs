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
/** The longest wait, in ms. A slow machine needs less. */
const patience = 300_000;
const browser = await chromium.launch({ executablePath, timeout: patience });
/** The errors that any page wrote on its console, and its requests to the network. */
const errors = [],
  asked = [];

/** Opens the page with data in it, as reports/run/page_template.cpp fills it, and closes it after the visit. */
async function read(report, visit, { scheme = "light", width = 1366 } = {}) {
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
  await page.goto(pathToFileURL(file).href);
  await page.waitForSelector("main");
  await visit(page);
  await context.close();
}

/** Until the page is drawn again. */
const settled = (page) =>
  page.evaluate(
    () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 60)))),
  );
async function go(page, hash) {
  await page.evaluate((to) => void (location.hash = to), hash);
  await settled(page);
}
async function click(page, what) {
  await what.click();
  await settled(page);
}
const button = (page, name) => page.getByRole("button", { name });
const hashOf = (page) => page.evaluate(() => location.hash);
const focusedOn = (page, key) => page.evaluate((name) => document.activeElement[name], key);
const textOf = async (page, selector) => (await page.locator(selector).first().innerText()).replace(/\s+/g, " ");
/** How many findings are shown, and which causes. */
async function shown(page) {
  await settled(page);
  const causes = await page.locator(".causes tbody a").allInnerTexts();
  return [Number((await textOf(page, ".filters [role=status]")).split(" ")[0]), causes.sort()];
}
const copied = (page, label) => page.locator(".copy", { hasText: label }).locator("code").innerText();

/** The page begins with its answer: red if something is new, else green. The table of causes begins with these. */
async function beginsWithTheAnswer() {
  for (const [status, kind, head, change = {}] of [
    ["new", "bad", /^6 new faults: \S+.* Compared with earlier runs\./],
    ["new", "bad", / For 6 new faults, no earlier run tested the method/, { asked_before: false }],
    ["known", "ok", /^Nothing is new and wrong\. Compared with earlier runs/],
  ]) {
    const report = sample();
    for (const b of report.causes)
      Object.assign(b, { status: b.severity === "contract" ? status : "known" }, change);
    await read(report, async (page) => {
      assert.match(await textOf(page, ".band"), head);
      assert.equal(await page.locator(`#new .band.${kind}`).count(), 1, kind);
      const row = page.locator(".causes tbody tr").first(),
        address = (of) => of.locator("a").first().getAttribute("href");
      assert.equal(await row.locator("td").first().innerText(), status);
      if (kind !== "ok") assert.equal(await address(page.locator(".band")), await address(row));
    });
  }
}

/** Before triage too. Missing parts have the command that adds them. */
const answersBeforeTriage = () =>
  read(untriaged(), async (page) => {
    assert.match(await textOf(page, ".band"), /^\d libraries are wrong beyond the claim: [a-z0-9, ]+.*The worst finding: \w/s);
    assert.match(await textOf(page, "#new .missing code"), /^\.\/daylight triage runs\/sample$/);
    assert.match(await textOf(page, "#charts .missing"), /daylight chart runs\/sample --bench bench.json --stability$/);
    for (const chart of ["speed", "maps", "calibration", "stability"])
      assert.equal(await page.locator(`section#${chart}`).count(), 0, `${chart} without data takes no room`);
    assert.doesNotMatch(await page.locator("body").innerText(), /undefined|NaN|\[object/);
  });

/** Text and selections reach both tables, and what they show stands in the address. */
async function filters(page, report) {
  const libraries = await page.locator(".heat-table tbody th").allInnerTexts();
  assert.deepEqual(new Set(libraries), new Set(report.methods.map((m) => m.library)));
  const all = [report.findings.length, report.causes.map((b) => b.key).sort()];
  const steps = await page.evaluate(() => history.length);
  assert.deepEqual(await shown(page), all);
  const ode = report.findings.filter((f) => f.method.startsWith("ode")),
    causes = report.causes.filter((b) => b.methods.some((m) => m.startsWith("ode")));
  await page.locator(".filters").getByLabel("Library").selectOption("ode");
  assert.deepEqual(await shown(page), [ode.length, causes.map((b) => b.key).sort()]);
  await page.getByLabel("Text of causes and findings").pressSequentially("wrong_disjoint");
  const found = ode.filter((f) => f.kind === "wrong_disjoint").length;
  assert.equal((await shown(page))[0], found);
  assert.equal(await hashOf(page), "#/findings?library=ode&text=wrong_disjoint");
  assert.equal(await page.evaluate(() => history.length), steps, "nothing for the Back button");
  await page.reload();
  assert.equal((await shown(page))[0], found);
  const link = page.locator(".findings tbody a").nth(2),
    address = await link.evaluate((a) => a.href);
  await click(page, link);
  assert.match(await focusedOn(page, "outerHTML"), /^<h2/);
  await page.goBack();
  assert.equal((await shown(page))[0], found, "Back finds it as it was");
  assert.equal(await focusedOn(page, "href"), address, "and the link has the focus");
  await click(page, button(page, "Clear"));
  assert.deepEqual(await shown(page), all);
  await click(page, button(page, /^Show all/));
  assert.equal(await page.locator(".findings tbody tr").count(), report.findings.length);
  await click(page, page.locator(".heat-table td a").first());
  const family = new URLSearchParams((await hashOf(page)).split("?")[1]).get("family");
  assert.equal(await page.locator(".filters").getByLabel("Family").inputValue(), family);
  await click(page, button(page, "Clear"));
}

async function holds(page) {
  await click(page, page.locator(".prove"));
  return page.locator(".proof").getAttribute("data-holds");
}

async function looksAndProves(page) {
  const picture = page.locator(".stage .projection"),
    box = await picture.boundingBox();
  assert.ok(box.width > 300 && box.height > 300, JSON.stringify(box));
  assert.match(await picture.getAttribute("aria-label"), /^Solid a and solid b, (disjoint|intersecting)/);

  assert.equal(await holds(page), "true");
  const certificate = page.locator(".prover textarea"),
    { verdict } = JSON.parse(await certificate.inputValue());
  const forged = verdict === "disjoint" ? { direction: [0, 0, 0] } : { point: [1e300, 5, 0] };
  await certificate.fill(JSON.stringify({ verdict, ...forged }));
  await settled(page);
  assert.equal(await page.locator(".proof").count(), 0, "an old proof does not stand beside a new certificate");
  assert.equal(await holds(page), "false");
  await click(page, button(page, "Reset"));
  assert.equal(await holds(page), "true");
}

async function readsACause(page, report) {
  const b = report.causes.find((b) => b.severity === "contract" && b.simplified);
  await go(page, `#/cause/${b.key}`);
  await looksAndProves(page);
  const worst = page.getByRole("tab", { name: "Worst" });
  await click(page, worst);
  assert.equal(await worst.getAttribute("aria-selected"), "true");
  assert.equal(await copied(page, "For the maintainers"), `./daylight export runs/sample ${b.key} --out upstream`);
  const facts = await page.locator(".detail dl.facts").allInnerTexts();
  assert.doesNotMatch(facts.join(), /\bpairs?\b/, "only the table of runs counts the pairs");

  const found = report.causes.find((b) => !b.simplified);
  await go(page, `#/cause/${found.key}`);
  assert.deepEqual(await page.getByRole("tab").allInnerTexts(), ["A pair (not simplified)", "Worst"]);

  const [low, high] = [0, 1].map((end) => (f) => report.cases[f.case].margin?.[end]),
    narrow = report.findings.find((f) => low(f) > 0 && high(f) < 1e-9);
  await go(page, `#/finding/${narrow.id}`);
  const caption = await textOf(page, ".pair-view figcaption");
  assert.match(caption, /^Not to scale: the (gap|overlap) of \S+ is drawn \S+ times as wide/);
  assert.ok((await page.locator(".answers tbody tr").count()) > 1);
}

async function drawsEveryPlot(page) {
  await go(page, "#/charts");
  assert.ok((await page.locator("#stability tbody tr").count()) > 24, "24 paths of each method");
  for (const id of ["speed", "maps", "calibration"]) {
    await page.locator(`#${id} .plot svg`).first().waitFor();
    const ticks = await page.locator(`#${id} .plot`).evaluate((plot) =>
      [...plot.querySelectorAll("[aria-label$='tick label']")].map((axis) => axis.querySelectorAll("text").length),
    );
    assert.ok(ticks.length >= 2 && ticks.every((n) => n > 1), `words on each axis of ${id}: ${ticks}`);
  }
  await page.locator("#maps").getByLabel("Method").selectOption("ode");
  const cell = page.locator("#maps .plot a").first();
  await cell.hover();
  await settled(page);
  assert.match(await page.locator("#maps .plot [aria-label=tip]", { hasText: "asked" }).first().textContent(), /asked/);
  await click(page, cell);
  assert.match(await hashOf(page), /^#\/finding\/\d+$/);
  await page.goBack();
  await click(page, page.locator("#speed .plot a", { has: page.locator("[aria-label^=ode]") }).first());
  assert.equal(await hashOf(page), "#/findings?library=ode");
}

const hashes = (report) => ["#/new", `#/finding/${report.findings[0].id}`, `#/cause/${report.causes[0].key}`];

/** Every head and fact has its meaning, and the page ends with all words, folded. */
async function explainsItsWords(page, report) {
  for (const hash of hashes(report)) {
    await go(page, hash);
    const silent = await page.evaluate(() =>
      [...document.querySelectorAll("main:not([hidden]) :is(thead th, dl.facts dt, .prover h3 span)")]
        .filter((e) => e.textContent.trim() !== "" && !e.title)
        .map((e) => e.textContent),
    );
    assert.deepEqual(silent, [], hash);
  }
  assert.ok((await page.locator("#words dt").count()) > 40);
  assert.match(await page.locator("#calibration").textContent(), /\(stated\)[^]*\(assumed by us\)/);
}

/** No name of a library meets another one or a mark, and nothing but tables in boxes is wider than the screen. */
async function fits(page, report, width) {
  await page.locator("#speed .plot svg").first().waitFor();
  const overlaps = await page.evaluate(() => {
    const meet = (a, b) => a.left + 1 < b.right && b.left + 1 < a.right && a.top + 1 < b.bottom && b.top + 1 < a.bottom;
    return [...document.querySelectorAll("#charts .plot svg")].flatMap((svg) => {
      const texts = [...svg.querySelectorAll("text")].filter((t) => t.textContent.trim().length > 1);
      const at = texts.map((text) => text.getBoundingClientRect());
      return texts.filter((_, i) => at.some((other, k) => k > i && meet(at[i], other))).map((t) => t.textContent);
    });
  });
  assert.deepEqual(overlaps, [], `at ${width}`);
  await page.evaluate(() => document.querySelectorAll("details").forEach((details) => (details.open = true)));
  for (const hash of hashes(report)) {
    await go(page, hash);
    const wide = await page.evaluate(() => document.documentElement.scrollWidth);
    assert.ok(wide <= width, `${hash} is ${wide} wide at ${width}`);
  }
}

/** By keyboard alone from the top to a proved finding, and back to the link. */
async function goesByKeyboard(page) {
  const tabTo = async (what, most) => {
    for (let i = 0; !what.test(await focusedOn(page, "outerHTML")); ++i) {
      assert.ok(i < most, `${what} after ${most} keys`);
      await page.keyboard.press("Tab");
    }
    const address = await focusedOn(page, "href");
    await page.keyboard.press("Enter");
    await settled(page);
    return address;
  };
  const address = await tabTo(/^<a [^>]*#\/cause\//, 8);
  assert.match(await focusedOn(page, "outerHTML"), /^<h2/);
  await tabTo(/class="prove"/, 15);
  assert.equal(await page.locator(".proof").getAttribute("data-holds"), "true");
  await page.goBack();
  await settled(page);
  assert.equal(await focusedOn(page, "href"), address, "back at the link");
}

/** Text of a store may be anything. */
async function showsHostileTextAsText() {
  const hostile = "</script><img src=x onerror=alert(1)>\u202e\u0001",
    report = sample(),
    spoil = (of, ...names) => Object.assign(of, Object.fromEntries(names.map((name) => [name, hostile])));
  spoil(report.run, "id", "seed", "status", "build");
  for (const f of report.findings) spoil(f, "method", "family", "reason");
  spoil(report.methods[0], "name");
  spoil(report.methods[0].claim, "source");
  for (const c of report.cases) spoil(c, "note");
  for (const b of report.causes) {
    spoil(b, "method", "cause", "first_version");
    Object.assign(b, { key: `${b.key}${hostile}`, methods: [hostile], labels: [hostile] });
  }
  report.findings[0].cause = report.causes[0].key;
  await read(report, async (page) => {
    const key = report.causes[0].key.split("/").map(encodeURIComponent).join("/");
    for (const hash of ["#/new", `#/finding/${report.findings[0].id}`, `#/cause/${key}`]) {
      await go(page, hash);
      assert.equal(await page.locator("img").count(), 0);
      assert.ok(!(await page.locator("body").innerText()).includes("\u202e"));
    }
    assert.equal(await page.locator(".story").count(), 1, "the cause is shown");
  });
}

/** The drawings of a segment, two points next to each other, and a certificate beyond doubles are right. */
async function drawsTheExtreme() {
  const report = sample(),
    far = `1${"0".repeat(400)}`;
  const point = (z) => ({ center: [0, 0, z], axis: [0, 0, 1], radius: 0, height: 0 });
  const nearest = { a: [0, 0, 0], b: [0, 0, 5e-324] },
    truth = { verdict: "disjoint", direction: [0, 0, 1], distance: [0, 1e-323] };
  const [first] = report.findings,
    second = report.findings.find((f) => f.case !== first.case);
  const dots = { pair: { a: point(0), b: point(5e-324) }, truth, nearest, direction: [0, 0, 1] };
  Object.assign(report.cases[first.case], dots);
  const third = report.findings.find((f) => ![first.case, second.case].includes(f.case)),
    segments = { a: { ...point(0), height: 1 }, b: { ...point(1), axis: [1, 0, 0], height: 1 } };
  Object.assign(report.cases[third.case], { pair: segments, nearest: undefined, direction: [0, 0, 1] });
  Object.assign(report.cases[second.case], { truth: { ...truth, direction: [far, far, "0"] }, direction: undefined });
  await read(report, async (page) => {
    for (const { id } of [first, second, third]) {
      await go(page, `#/finding/${id}`);
      assert.match(await textOf(page, ".detail h2"), new RegExp(`^#${id} `));
    }
    for (const solid of ["a", "b"]) {
      const { width, height } = await page.locator(`.stage .solid-${solid} .rim`).first().boundingBox();
      assert.ok(Math.hypot(width, height) > 30, `segment ${solid} is seen`);
    }
  });
}

const report = sample();
report.causes.at(-1).simplified = false;
await beginsWithTheAnswer();
await answersBeforeTriage();
await read(report, async (page) => {
  await filters(page, report);
  await readsACause(page, report);
  await drawsEveryPlot(page);
  await explainsItsWords(page, report);
});
for (const [width, scheme] of [
  [400, "dark"],
  [900, "light"],
  [1366, "light"],
])
  await read(report, (page) => fits(page, report, width), { width, scheme });
await read(report, goesByKeyboard);
await showsHostileTextAsText();
await drawsTheExtreme();
assert.deepEqual(errors, []);
assert.deepEqual(asked, [], "nothing is asked from the network");
console.log("page_test: all well");
await browser.close();
