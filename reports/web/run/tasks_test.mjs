// SPDX-License-Identifier: MIT
// Five tasks of a first-time reader, each from the top of the page of a made-up run. Counts the clicks that each takes
// until its answer is on the screen, and prints the seconds.
import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { browser, errors, filled, folder, open, settled } from "../browser.mjs";
import { sample } from "./sample.mjs";

const report = sample(400),
  file = join(folder, "tasks.html");
writeFileSync(file, filled(report));

/** The text of what answers, which must be in the window. */
async function read(page, answer) {
  await settled(page);
  const box = await answer.boundingBox();
  assert.ok(box && box.y >= 0 && box.y + box.height <= 850, `the answer is not on the screen: ${JSON.stringify(box)}`);
  return (await answer.innerText()).replace(/\s+/g, " ");
}

async function whatIsNew(page) {
  assert.match(await read(page, page.locator(".answer")), /^1 new fault: fcl-libccd offers a witness that does not prove the answer/);
}

async function whoFailsMostOnThinDisks(page, click) {
  await click(page.getByRole("button", { name: "flat disks", exact: true }));
  const share = ({ contract, failed, asked }) => (contract + failed) / asked,
    library = (name) => (name.includes("-") ? name.split("-")[0] : name);
  const byLibrary = new Map();
  for (const t of report.tallies.filter((t) => t.family === "flat_disks" && report.methods.some((m) => m.name === t.method))) {
    const of = byLibrary.get(library(t.method)) ?? { contract: 0, failed: 0, asked: 0 };
    for (const key of Object.keys(of)) of[key] += t[key];
    byLibrary.set(library(t.method), of);
  }
  const [worst] = [...byLibrary].sort(([, x], [, y]) => share(y) - share(x))[0];
  const told = await read(page, page.locator("#new p[role=status]"));
  assert.ok(told.startsWith(`On flat disks, ${worst} fails most: `), told);
  assert.ok((await page.locator(".heat-table tbody th").first().innerText()).startsWith(worst));
}

async function isItProved(page, click) {
  await click(page.locator(".answer a"));
  await click(page.getByRole("button", { name: "Prove again" }));
  assert.match(await read(page, page.locator(".proof > b")), /^Proved: /);
}

async function sinceWhen(page, click) {
  await click(page.locator(".changes a", { hasText: "known" }));
  assert.match(await read(page, page.locator(".causes tbody td").nth(4)), /^2026-11-19 /);
}

async function sendIt(page, click) {
  await click(page.locator(".answer a"));
  const box = page.locator(".copy", { hasText: "For the maintainers" });
  await click(box.getByRole("button", { name: "Copy" }));
  assert.match(await read(page, box), /copied|by hand/);
  assert.match(await box.locator("code").innerText(), /daylight export runs\/sample \S+ --out upstream$/);
}

for (const [task, clicks] of [
  [whatIsNew, 0],
  [whoFailsMostOnThinDisks, 1],
  [isItProved, 2],
  [sinceWhen, 1],
  [sendIt, 2],
]) {
  const page = await open(pathToFileURL(file).href);
  let count = 0;
  const start = performance.now();
  await task(page, async (target) => (++count, await target.click()));
  assert.equal(count, clicks, `clicks of ${task.name}`);
  console.log(`${task.name}: ${count} clicks, ${((performance.now() - start) / 1000).toFixed(1)} s`);
  await page.context().close();
}
assert.deepEqual(errors, []);
console.log("tasks_test: all well");
await browser.close();
