// SPDX-License-Identifier: MIT
// The page to play with: what it says of others is what the repository holds, what it proves is proved, and a reader
// uses it from disk without network, with the pointer and with the keyboard alone.
//     node page_test.mjs PAGE.html          as daylight play wrote it
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";
import {
  asked,
  browser,
  colours,
  dataOf,
  errors,
  open,
  settled,
  solverModule,
  solverOf,
  withoutWebgl,
} from "../browser.mjs";
import { daylight } from "../chart.mjs";
import { assertContrast } from "../contrast.mjs";

const { addressOf, bringSolver, pairOf, prove, solve } = daylight;
const file = resolve(process.argv[2]),
  address = pathToFileURL(file).href,
  play = dataOf(file);
const inTree = (name) => new URL(`../../../${name}`, import.meta.url);
const linesOf = (name) =>
  readFileSync(inTree(name), "utf8")
    .split("\n")
    .filter((line) => line !== "")
    .map((line) => JSON.parse(line));
const cases = readdirSync(inTree("corpus/cases"))
  .filter((name) => name.endsWith(".jsonl"))
  .flatMap((name) => linesOf(`corpus/cases/${name}`));
const examplesOf = (group) => play.examples.filter((e) => e.group === group);

/** Nothing is said of anybody that the files of the repository do not say, or that is not so. */
function saysWhatIsKnown() {
  for (const [group, name] of [
    ["reported", "reported"],
    ["rounded", "rounded"],
  ])
    assert.deepEqual(
      examplesOf(group).map(({ id, source, note, pair, truth }) => ({ id, source, note, pair, truth: truth.verdict })),
      linesOf(`corpus/cases/${name}.jsonl`).map(({ id, source, note = "", a, b, truth }) => ({
        id,
        source,
        note,
        pair: { a, b },
        truth,
      })),
    );
  const engines = linesOf("docs/results/engines.jsonl").filter(({ worst }) => worst);
  assert.deepEqual(
    examplesOf("engines").map(({ pair, truth, answers: [said] }) => [
      pair,
      truth.verdict,
      said.method,
      said.version,
      said.verdict,
      said.recorded,
      said.wrong,
    ]),
    engines.map(({ name, package: version, date, worst }) => [
      worst.pair,
      worst.truth,
      name,
      version,
      worst.said,
      date,
      { kind: `wrong_${worst.said}`, severity: "contract" },
    ]),
  );
  const errata = readFileSync(inTree("solver/literature/errata.md"), "utf8").replace(/\s+/g, " ");
  for (const { id, truth, pair, answers } of examplesOf("errata")) {
    const { a, b, truth: known } = cases.find((c) => c.id === id);
    assert.deepEqual([pair, truth.verdict], [{ a, b }, known], id);
    const says = (m) => `\`${m.method}\` answers ${m.verdict}`,
      [wrong, right] = answers.filter(({ method }) => method.startsWith("seed"));
    const sentence = ([p, q]) => `${known}, by proof. ${says(p)}, ${says(q)}.`;
    assert.ok(
      [
        [wrong, right],
        [right, wrong],
      ].some((both) => errata.includes(sentence(both))),
      sentence([wrong, right]),
    );
  }
  const counts = ["engines", "reported", "rounded", "errata"].map((group) => examplesOf(group).length);
  assert.ok(counts.every((n) => n >= 4) && counts.reduce((sum, n) => sum + n) === play.examples.length, `${counts}`);
  const faults = play.examples.flatMap(({ answers }) => answers.filter(({ wrong }) => wrong?.severity === "contract"));
  assert.ok(faults.length > 30, `${faults.length} wrong answers`);
}

/** The solver of the page and its prover, on every case: each certificate holds, no verdict is refuted. */
async function provesEveryCase() {
  const module = solverOf(file);
  assert.ok(module.equals(solverModule), "the page holds the solver");
  await bringSolver(module);
  const seen = { proved: 0, open: 0, hulls: 0, points: 0 };
  for (const { id, a, b, truth } of cases) {
    const pair = { a, b },
      solved = solve(pair).truth;
    assert.deepEqual(pairOf(addressOf(pair)), pair, `the address of ${id}`);
    if (solved.verdict === "undecided") {
      seen.open += 1;
      continue;
    }
    assert.equal(solved.verdict === "disjoint", truth === "disjoint", id);
    assert.equal(prove(pair, solved).holds, true, id);
    seen.proved += 1;
    seen.hulls += solved.hulls ? 1 : 0;
    seen.points += solved.points ? 1 : 0;
    if (solved.direction || solved.hulls) continue; // these may hold for another vector
    const tampered = JSON.parse(JSON.stringify(solved).replace(/-?\d[-+.\de]*/g, "1.7e308"));
    assert.equal(prove(pair, tampered).holds, false, `${id}, tampered`);
  }
  console.log(JSON.stringify(seen));
  assert.ok(seen.proved > 200 && seen.hulls > 10 && seen.points > 5 && seen.open < seen.proved, JSON.stringify(seen));
}

const verdict = async (page) => (await settled(page), page.locator(".verdict .answer").innerText());
const holds = (page) => page.locator(".verdict").getAttribute("data-holds");
const field = (page, solid, group, name) =>
  page.getByRole("group", { name: `${group} of ${solid}` }).getByLabel(name, { exact: true });
const hash = (page) => page.evaluate(() => location.hash);

async function changesAndRemembers() {
  const page = await open(address);
  assert.equal(await verdict(page), "disjoint");
  assert.equal(await holds(page), "true");
  await field(page, "b", "centre", "x").fill("0.5");
  assert.equal(await verdict(page), "intersecting");
  assert.equal(await holds(page), "true");
  await field(page, "b", "centre", "x").fill("");
  assert.equal(await verdict(page), "intersecting", "what is no number changes nothing");
  await field(page, "b", "centre", "x").fill("2.5");
  await page.getByLabel("Kind of a").selectOption("sphere");
  assert.equal(await page.getByRole("group", { name: "axis of a" }).count(), 0, "a sphere has no axis");
  await field(page, "a", "Lengths", "radius").fill("1.75");
  await field(page, "a", "centre", "z").fill("1e-3");
  const kept = pairOf(await hash(page)),
    said = [await verdict(page), await page.locator(".distance").innerText()];
  assert.deepEqual(kept.a, { center: [0, 0, 0.001], axis: [0, 0, 1], radius: 0, height: 0, rounding: 1.75 });
  const again = await open(page.url());
  assert.deepEqual([await verdict(again), await again.locator(".distance").innerText()], said);
  assert.equal(await again.getByLabel("Kind of a").inputValue(), "sphere");
  await again.evaluate((to) => (location.hash = to), "#a=0,0,0,0,0,1,1,2&b=0,0,2,0,0,1,1,2");
  assert.equal(await verdict(again), "undecided", "they touch");
  await again.evaluate((to) => (location.hash = to), "#a=0,0,0,0,0,0,1,2&b=0,0,2,0,0,1,1,2");
  assert.equal(await verdict(again), "invalid");
  await again.context().close();
  await page.context().close();
}

/** With WebGL and without: a handle goes where it is dragged, and only its own solid changes. */
async function dragsHandles() {
  for (const first of [undefined, withoutWebgl]) {
    const page = await open(address, { first, width: 1400 }),
      before = pairOf(await hash(page)) ?? null;
    assert.equal(before, null, "the address is empty at first");
    if (!first) assert.ok((await colours(page)).count > 20, "the solids are drawn");
    const pull = async (name, right, down) => {
      const { x, y, width, height } = await page.getByRole("button", { name, exact: true }).boundingBox();
      await page.mouse.move(x + width / 2, y + height / 2);
      await page.mouse.down();
      await page.mouse.move(x + width / 2 + right, y + height / 2 + down, { steps: 4 });
      await page.mouse.up();
      await settled(page);
      const at = await page.getByRole("button", { name, exact: true }).boundingBox();
      return [at.x - x, at.y - y, pairOf(await hash(page))];
    };
    const [right, down, moved] = await pull("Move b", -60, 25);
    assert.ok(Math.abs(right + 60) < 3 && Math.abs(down - 25) < 3, `moved by ${right}, ${down}`);
    const [, , turned] = await pull("Turn a", 40, 30);
    assert.deepEqual([turned.b, turned.a.center, turned.a.height], [moved.b, moved.a.center, moved.a.height]);
    assert.notDeepEqual(turned.a.axis, moved.a.axis);
    const { x, width } = await page.getByRole("button", { name: "Move b", exact: true }).boundingBox(),
      edge = await page.getByRole("button", { name: "Resize b", exact: true }).boundingBox(),
      outward = Math.sign(edge.x - x) || 1;
    const [, , resized] = await pull("Resize b", outward * width, 0);
    assert.ok(resized.b.radius > turned.b.radius, "pulled out it is larger");
    assert.deepEqual({ ...resized.b, radius: 0 }, { ...turned.b, radius: 0 });
    await page.context().close();
  }
}

/** Tab, arrows and letters are enough for an example, a field and every handle. */
async function worksByKeyboard() {
  const page = await open(address);
  const reach = async (name) => {
    for (let i = 0; i < 60; ++i) {
      await page.keyboard.press("Tab");
      const at = await page.evaluate(() => {
        const e = document.activeElement;
        return e.getAttribute("aria-label") ?? e.closest("label")?.innerText.split("\n")[0] ?? e.innerText;
      });
      if (at.startsWith(name)) return;
    }
    assert.fail(`Tab does not come to ${name}`);
  };
  await reach("Example");
  // Arrows, because a browser forgets what was typed into a list after a second.
  const chosen = () => page.getByLabel("Example").inputValue();
  for (let i = play.examples.length; i > 0 && (await chosen()) !== "worst-of-jolt"; --i)
    await page.keyboard.press("ArrowDown");
  assert.equal(await page.locator(".example").getAttribute("data-example"), "worst-of-jolt");
  assert.match(await page.locator(".example .answers-of-engines").first().innerText(), /jolt\s.*\s*disjoint/s);
  await reach("Start again");
  await page.keyboard.press("Enter");
  assert.equal(await verdict(page), "disjoint");
  for (const name of ["Move", "Turn", "Resize"]) {
    const before = await hash(page);
    await reach(`${name} a`);
    await page.keyboard.press("ArrowRight");
    await page.keyboard.press("Shift+ArrowUp");
    await settled(page);
    assert.notEqual(await hash(page), before, name);
  }
  await reach("Kind of b");
  await page.keyboard.press("ArrowDown");
  assert.equal(await page.getByLabel("Kind of b").inputValue(), "capsule");
  await reach("x"); // of the centre of b
  await page.keyboard.press("Control+a");
  await page.keyboard.type("0.25");
  assert.equal(await verdict(page), "intersecting");
  assert.equal(await holds(page), "true");
  await page.context().close();
}

/** Examples can be shown and come back after a change; what is said of their pairs is proved. */
async function showsExamples() {
  const page = await open(address);
  const shown = ["engines", "reported", "rounded", "errata"].flatMap((group) => examplesOf(group).slice(0, 4));
  for (const { id, pair, truth } of shown) {
    await page.getByLabel("Example").selectOption(id);
    const said = await verdict(page);
    assert.deepEqual(pairOf(await hash(page)), pair, id);
    if (said !== "undecided") {
      assert.equal(said === "disjoint", truth.verdict === "disjoint", id);
      assert.equal(await holds(page), "true", id);
    }
  }
  await field(page, "a", "centre", "y").fill("9");
  await page.getByRole("button", { name: "Back to the example" }).click();
  assert.deepEqual(pairOf(await hash(page)), shown.at(-1).pair);
  await page.context().close();
}

/** Words stand out by 4.5; no words, fields or buttons lie on each other, and nothing is wider than the window. */
async function canBeRead() {
  for (const scheme of ["light", "dark"])
    for (const width of [400, 1000, 1600]) {
      const page = await open(`${address}${addressOf(examplesOf("engines")[0].pair)}`, { scheme, width });
      await page.locator(".example details summary").click();
      await settled(page);
      const least = await assertContrast(page, `${scheme}, ${width}`);
      assert.ok(least.word[1] > 60 && least.mark[1] > 3, JSON.stringify(least));
      const [lying, things, inner] = await page.evaluate(() => {
        const slack = 1;
        const all = [...document.querySelectorAll("#page *")].filter(
          (e) =>
            e.checkVisibility({ visibilityProperty: true }) &&
            !e.closest(".handles, .stage, .sr, option, optgroup") &&
            (e.matches("button, input, select") ||
              [...e.childNodes].some((n) => n.nodeType === Node.TEXT_NODE && n.textContent.trim() !== "")),
        );
        const boxes = all.map((e) => e.getBoundingClientRect());
        const meet = (p, q) =>
          p.left + slack < q.right && q.left + slack < p.right && p.top + slack < q.bottom && q.top + slack < p.bottom;
        const found = [];
        for (let i = 0; i < all.length; ++i)
          for (let k = i + 1; k < all.length; ++k)
            if (meet(boxes[i], boxes[k]) && !all[i].contains(all[k]) && !all[k].contains(all[i]))
              found.push(`${all[i].outerHTML.slice(0, 60)} / ${all[k].outerHTML.slice(0, 60)}`);
        return [found, all.length, document.documentElement.scrollWidth];
      });
      assert.deepEqual(lying, [], `${scheme}, ${width}`);
      assert.ok(things > 60 && inner <= width, `${things} things, ${inner} wide`);
      await page.context().close();
    }
}

saysWhatIsKnown();
await provesEveryCase();
for (const step of [changesAndRemembers, dragsHandles, worksByKeyboard, showsExamples, canBeRead]) {
  await step();
  console.log(step.name);
}
const expected = /Error creating WebGL context/; // where there is none
assert.deepEqual(
  errors.filter((text) => !expected.test(text)),
  [],
);
assert.deepEqual(asked, []);
await browser.close();
