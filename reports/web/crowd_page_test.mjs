// SPDX-License-Identifier: MIT
// A reader of the page of many cylinders: opens it from disk in a browser without network, reads the counts, picks
// pairs in the table and cylinders in the picture, saves the table, reads the charts.
//     node crowd_page_test.mjs PAGE.html LARGE.html     of --generate rods --count 5000 --verify, and of 100,000
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { asked, browser, colours, errors, folder, open, settled, without_webgl } from "./browser.mjs";
import { csv_of_pairs, first_hit, frame_around, power_law } from "./chart.mjs";
import { filled } from "./sample.mjs";

const [given, large] = process.argv.slice(2, 4).map((file) => resolve(file)),
  address = pathToFileURL(given).href;
const data_of = (file) => JSON.parse(/id="report-data">([^<]*)</.exec(readFileSync(file, "utf8"))[1]);
const crowd = data_of(given);
const grouped = (n) => n.toLocaleString("en-US");
const hash = async (page) => (await settled(page), page.evaluate(() => location.hash));
const cells = async (page, name) => (await settled(page), page.locator(`.findings tbody td.c-${name}`).allInnerTexts());
const status = async (page) => (await settled(page), page.locator(".pairs [role=status]").innerText());
const in_picture = async (page, x, y) => {
  const box = await page.locator(".stage canvas").boundingBox();
  return [box.x + x * box.width, box.y + y * box.height];
};
const cylinder = ([x, y, z, u, v, w, radius, height, rounding = 0]) => ({
  center: [x, y, z],
  axis: [u, v, w],
  radius,
  height,
  rounding,
});

/** Rays from beside a solid through a point of it meet it first, and none that passes by. */
function rays_hit_what_they_meet() {
  const up = { axis: [0, 0, 1], radius: 0.1, half: 1, rounding: 0 };
  const solids = [
    { ...up, center: [0, 0, 0] },
    { ...up, center: [3, 0, 0], rounding: 0.4 },
    { ...up, center: [6, 0, 0], radius: 0, half: 0, rounding: 1 },
  ];
  const hit = (from, along, of = solids) => first_hit(from, along, of);
  assert.equal(hit([-5, 0, 0], [1, 0, 0]), 0, "the first of three");
  assert.equal(hit([-5, 0, 0], [1, 0, 0], solids.slice(1)), 0);
  assert.equal(hit([9, 0, 0], [-1, 0, 0]), 2, "from the other side");
  assert.equal(hit([0, -5, 1.01], [0, 1, 0]), -1, "above the end");
  assert.equal(hit([0, -5, 0.99], [0, 1, 0]), 0);
  assert.equal(hit([3, -5, 1.39], [0, 1, 0]), 1, "the rounding of the end");
  assert.equal(hit([3.3, -5, 1.39], [0, 1, 0]), -1, "the edge is round");
  assert.equal(first_hit([0.105, -5, 0], [0, 1, 0], solids, 0.01), 0, "thicker than it is");
  // A pair that meets: along the way between its deepest points one comes on each of both.
  const frame = frame_around(crowd.solids.map(cylinder));
  for (const near of crowd.nearest.slice(0, 20)) {
    const two = [near.a, near.b].map((i) => frame.solid(cylinder(crowd.solids[i])));
    const middle = frame.to(near.on_a.map((x, i) => (x + near.on_b[i]) / 2));
    assert.notEqual(first_hit([middle[0], middle[1], -9], [0, 0, 1], two), -1);
  }
}

function fits_powers() {
  const law = power_law([1, 10, 100].map((n) => [n, 3 * n ** 1.5]));
  assert.ok(Math.abs(law.exponent - 1.5) < 1e-12 && Math.abs(law.factor - 3) < 1e-12);
  assert.equal(power_law([[10, 1]]), null);
}

async function reads_the_answer(page) {
  const text = await page.locator("#answer").innerText();
  assert.ok(text.startsWith(`${grouped(crowd.within.length)} pairs intersect, found in `), text);
  const { verification: v, certificates: c } = crowd;
  assert.equal(v.asked, crowd.candidates);
  assert.ok(text.includes(`Referee: ${grouped(v.asked)} answers asked, 0 wrong, 0 not proved`), text);
  assert.ok(text.includes(`Certificates: ${grouped(c.checked)} checked, 0 failed, 0 pairs without one`), text);
  assert.ok(text.includes(grouped((crowd.cylinders * (crowd.cylinders - 1)) / 2)), "all pairs");
  assert.equal(await page.locator("#answer .ok").count(), 2);
  const asked_for = await page.locator("header .run").innerText();
  assert.match(asked_for, /generated rods .* 5,000 cylinders .* seed 1 .* clearance 0/);
}

async function sorts_and_searches(page) {
  assert.equal(await status(page), `the nearest ${grouped(crowd.nearest.length)} pairs`);
  const names = ({ a, b }) => `cylinder ${a}\ncylinder ${b}`;
  assert.equal((await cells(page, "pair"))[0], names(crowd.nearest[0]));
  const head = page.locator(".findings th", { hasText: "distance" });
  await head.getByRole("button").click();
  assert.equal((await settled(page), await head.getAttribute("aria-sort")), "ascending");
  await head.getByRole("button").click();
  assert.equal((await cells(page, "pair"))[0], names(crowd.nearest.at(-1)));
  assert.equal((await cells(page, "answer"))[0], crowd.nearest.at(-1).within ? "intersecting" : "apart");
  await page.locator(".findings th", { hasText: "rank" }).getByRole("button").click();
  const search = page.getByLabel("Search the nearest pairs by name"),
    { a, b } = crowd.nearest[7];
  await search.fill(`cylinder ${a} ${b}`);
  const found = await cells(page, "pair");
  assert.ok(found.includes(names(crowd.nearest[7])));
  assert.ok(found.every((both) => both.includes(a) && both.includes(b)), found.join(" "));
  await search.fill("nobody");
  assert.equal(await status(page), `0 of the nearest ${grouped(crowd.nearest.length)} pairs`);
  await search.fill("");
}

/** Every double comes back. */
async function saves_the_table(page) {
  const button = page.getByRole("button", { name: "CSV" });
  const [download] = await Promise.all([page.waitForEvent("download"), button.click()]);
  const text = readFileSync(await download.path(), "utf8"),
    lines = text.trimEnd().split("\r\n");
  assert.equal(lines.length, crowd.nearest.length + 1);
  assert.equal(text, csv_of_pairs(crowd, [...crowd.nearest.keys()]));
  const head = lines[0].split(","),
    third = lines[3].split(",");
  const of = (name) => third[head.indexOf(name)];
  const near = crowd.nearest[2];
  assert.deepEqual([of("a"), of("b"), of("distance")].map(Number), [near.a, near.b, near.distance]);
  assert.deepEqual(["x", "y", "z"].map((c) => Number(of(`on_b_${c}`))), near.on_b);
  assert.equal(of("answer"), near.within ? "within" : "apart");
  assert.equal(of("certificate"), near.certificate);
}

async function picks_a_pair(page) {
  const whole = await colours(page);
  assert.ok(whole.count > 500, `the drawing has ${whole.count} colours`);
  await page.locator(".findings tbody tr:not(.spacer)").nth(2).click();
  const near = crowd.nearest[2];
  assert.equal(await hash(page), `#pair=${near.a},${near.b}`);
  const close = await colours(page);
  assert.notEqual(close.hash, whole.hash);
  assert.ok((await page.locator(".picked").innerText()).includes(`overlap by ${-near.distance}`));
  await page.locator(".crowd-pairs .virtual").focus();
  await page.keyboard.press("ArrowDown");
  assert.equal(await hash(page), `#pair=${crowd.nearest[3].a},${crowd.nearest[3].b}`);
  await page.locator(".picked button.link").nth(1).click();
  const solid = crowd.nearest[3].b;
  assert.equal(await hash(page), `#solid=${solid}`);
  const partners = crowd.within.filter((pair) => pair.includes(solid));
  const told = await page.locator(".picked p").innerText();
  assert.ok(told.startsWith(`${partners.length} pair`), told);
  assert.equal(await page.locator(".picked p button.link").count(), partners.length);
  await page.locator(".picked p button.link").first().click();
  assert.match(await hash(page), /^#pair=/);
  await page.getByRole("button", { name: "Show all" }).click();
  assert.equal(await hash(page), "");
  assert.equal((await colours(page)).hash, whole.hash);
}

/** How many pixels are orange, and how many are not. */
const orange = async (page) => (
  await settled(page),
  page.evaluate(() => {
    const canvas = document.querySelector(".stage canvas"),
      { width, height } = canvas,
      flat = Object.assign(document.createElement("canvas"), { width, height }).getContext("2d");
    flat.drawImage(canvas, 0, 0);
    const { data } = flat.getImageData(0, 0, width, height);
    const counts = { orange: 0, grey: 0 };
    for (let i = 0; i < data.length; i += 4)
      if (data[i + 3] > 200) ++counts[data[i] > data[i + 2] + 30 ? "orange" : "grey"];
    return counts;
  })
);

/** Those in no close pair are left out, and then those far from the nearest pairs. */
async function shows_less(page) {
  const whole = await colours(page);
  const opaque = [whole.opaque],
    all = await orange(page),
    share = crowd.within.length / crowd.cylinders; // of solids in a close pair about twice that
  assert.ok(all.orange > share * all.grey && all.grey > all.orange, JSON.stringify(all));
  for (const showing of ["close", "nearest"]) {
    await page.locator(".stage-tools select").selectOption(showing);
    assert.equal(await hash(page), `#show=${showing}`);
    opaque.push((await colours(page)).opaque);
    const some = await orange(page);
    assert.equal(some.orange > 500 * some.grey, showing === "close", JSON.stringify(some));
  }
  assert.ok(opaque[0] > 1.2 * opaque[1] && opaque[2] > 1000, opaque.join());
  await page.locator(".stage-tools select").selectOption("all");
  assert.equal((await colours(page)).hash, whole.hash);
}

/** The first cylinder under the middle of the picture of all, by where one looks from. */
function in_the_middle() {
  const cylinders = crowd.solids.map(cylinder),
    frame = frame_around(cylinders),
    solids = cylinders.map(frame.solid);
  const dot = (u, v) => u[0] * v[0] + u[1] * v[1] + u[2] * v[2],
    unit = (u) => u.map((x) => x / Math.hypot(...u));
  const eye = unit([1, -1.3, 0.75]),
    right = unit([-eye[1], eye[0], 0]),
    above = unit([-eye[0] * eye[2], -eye[1] * eye[2], eye[0] ** 2 + eye[1] ** 2]);
  let from = eye.map((x) => 4 * x);
  for (const axis of [right, above]) {
    const ends = solids.flatMap((s) => {
      const reach = Math.hypot(s.radius, s.half) + s.rounding;
      return [dot(s.center, axis) - reach, dot(s.center, axis) + reach];
    });
    from = from.map((x, i) => x + (axis[i] * (Math.min(...ends) + Math.max(...ends))) / 2);
  }
  return first_hit(from, eye.map((x) => -x), solids, 1e-3);
}

async function picks_in_the_picture(page) {
  await page.locator(".stage canvas").scrollIntoViewIfNeeded();
  const whole = await colours(page);
  await page.mouse.move(...(await in_picture(page, 0.5, 0.5)));
  await settled(page);
  const name = await page.locator(".under").innerText();
  assert.equal(name, `cylinder ${in_the_middle()}`);
  await page.mouse.click(...(await in_picture(page, 0.5, 0.5)));
  assert.equal(await hash(page), `#solid=${name.split(" ")[1]}`, "the one under the pointer");
  assert.ok((await page.locator(".picked h3").innerText()).includes(name));
  const near = await colours(page);
  await page.mouse.move(...(await in_picture(page, 0.4, 0.6)));
  await page.mouse.down();
  await page.mouse.move(...(await in_picture(page, 0.7, 0.7)), { steps: 3 });
  await page.mouse.up();
  assert.notEqual((await colours(page)).hash, near.hash, "turned, it looks another way");
  assert.equal(await hash(page), `#solid=${name.split(" ")[1]}`, "to turn is not to click");
  await page.getByRole("button", { name: "Fit" }).click();
  assert.equal((await colours(page)).hash, near.hash, "as before");
  await page.getByRole("button", { name: "Show all" }).click();
  await page.mouse.click(...(await in_picture(page, 0.01, 0.99)));
  assert.equal((await settled(page), await page.locator(".picked").count()), 0, "a click beside all picks none");
  await page.mouse.move(0, 0);
  assert.equal((await colours(page)).hash, whole.hash);
}

async function reads_the_charts(page) {
  await page.locator("#growth").scrollIntoViewIfNeeded();
  await page.waitForSelector("#growth figure:nth-child(2) svg");
  const labels = await page.locator("#growth .plot [aria-label=dot] [aria-label]").evaluateAll((dots) =>
    dots.map((dot) => dot.getAttribute("aria-label")),
  );
  assert.equal(labels.length, 6 * crowd.growth.length, "four lines of times, two of pairs");
  const last = crowd.growth.at(-1);
  const boxes_meet = `boxes meet, ${grouped(last.cylinders)} cylinders: ${grouped(last.candidates)}`;
  assert.ok(labels.includes(boxes_meet), labels.join("\n"));
  const law = power_law(crowd.growth.map((row) => [row.cylinders, Object.values(row.cpu_ms).reduce((x, y) => x + y)]));
  assert.ok((await page.locator("#growth .lead").innerText()).includes(`to the power ${law.exponent.toFixed(2)},`));
  const rows = await page.locator("#growth tbody tr").allInnerTexts();
  assert.deepEqual(
    rows.map((row) => row.split("\t")[0]),
    crowd.growth.map((row) => grouped(row.cylinders)),
  );
}

async function fits(page) {
  const [inner, outer] = await page.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
  assert.ok(inner <= outer, `the page is ${inner} wide in a window of ${outer}`);
}

async function opens_a_view_by_its_address() {
  const { a, b } = crowd.nearest[5];
  const page = await open(`${address}#pair=${a},${b}`, { scheme: "dark", width: 500 });
  assert.ok((await page.locator(".picked h3").innerText()).includes(`cylinder ${b}`));
  const [inner, outer] = await page
    .locator(".crowd-pairs .virtual")
    .evaluate((table) => [table.scrollWidth, table.clientWidth]);
  assert.ok(inner <= outer, `the table is ${inner} wide in a place of ${outer}`);
  await reads_the_charts(page);
  await fits(page);
  await page.context().close();
  const close = new Set(crowd.within.map((pair) => pair.join())),
    known = new Set(crowd.nearest.map((pair) => `${pair.a},${pair.b}`));
  const others = [crowd.within.find((pair) => !known.has(pair.join())), [0, 1]].filter(Boolean);
  for (const pair of others) {
    const far = await open(`${address}#pair=${pair}`);
    const told = (await settled(far), await far.locator(".picked p").innerText());
    assert.ok(told.startsWith(`They are ${close.has(pair.join()) ? "" : "not "}intersecting; the distance`), told);
    await far.context().close();
  }
  for (const lost of ["#pair=3,3", "#pair=0,99999999", "#solid=-1", "#solid=x&show=none"]) {
    const none = await open(`${address}${lost}`);
    assert.equal((await settled(none), await none.locator(".picked").count()), 0, lost);
    await none.context().close();
  }
}

/** A file with names of any kind, of solids of every kind, with answers that are wrong and none that was checked. */
async function shows_a_file() {
  const hostile = "</script><img src=x onerror=alert(1)>\u202e";
  const some = crowd.solids.slice(0, 300),
    within = crowd.within.filter((pair) => pair.every((i) => i < some.length));
  const file = {
    ...crowd,
    cylinders: some.length,
    file: hostile,
    clearance: 0.5,
    names: some.map((_, i) => `${hostile}${i}`),
    solids: some.map((numbers, i) => (i % 3 === 0 ? [...numbers.slice(0, 6), 0, i % 2, 0.2] : numbers)),
    nearest: crowd.nearest.filter(({ a, b }) => a < some.length && b < some.length),
    within,
    undecided: 2,
    verification: { ...crowd.verification, wrong: 3 },
    certificates: { ...crowd.certificates, failed: 4 },
  };
  for (const key of ["generated", "seed", "growth"]) delete file[key];
  const written = async (name, data) => {
    writeFileSync(join(folder, name), filled(data));
    return open(pathToFileURL(join(folder, name)).href);
  };
  const page = await written("file.html", file);
  const text = await page.locator("body").innerText();
  assert.ok(text.includes("<img src=x") && !text.includes("\u202e"));
  assert.equal(await page.locator("img").count(), 0);
  assert.equal(await page.locator("#answer .bad").count(), 2, "a wrong answer and a failed certificate");
  assert.ok(text.includes(", 3 wrong,") && text.includes("4 failed,") && text.includes("2 pairs left undecided"));
  assert.equal(await page.locator("#growth").count(), 0);
  assert.ok((await colours(page)).count > 300);
  await page.context().close();
  for (const key of ["verification", "certificates"]) delete file[key];
  const unchecked = await written("unchecked.html", file);
  assert.match(await unchecked.locator("#answer .warn").first().innerText(), /--clearance 0\.5 --verify/);
  await unchecked.context().close();
}

async function says_that_there_is_no_webgl() {
  const page = await open(address, { first: without_webgl });
  assert.match(await page.locator(".stage.flat").innerText(), /no WebGL.*5,000 cylinders/s);
  await page.locator(".findings tbody tr:not(.spacer)").first().click();
  await page.waitForSelector(".stage.flat svg.projection");
  assert.equal(await page.locator(".projection .body").count(), 2);
  errors.length = 0; // three.js says itself that it got no context
  await page.context().close();
}

/** All are there, and the page can be used; without a graphics processor a frame takes some seconds. */
async function shows_a_hundred_thousand() {
  const page = await open(`${pathToFileURL(large).href}`);
  assert.match(await page.locator("#answer").innerText(), /100,000/);
  const drawn = await colours(page);
  assert.ok(drawn.count > 500 && drawn.opaque > 10_000, JSON.stringify(drawn));
  await page.locator(".stage canvas").scrollIntoViewIfNeeded();
  await page.mouse.click(...(await in_picture(page, 0.5, 0.5)));
  assert.match(await hash(page), /^#solid=\d+$/);
  const data = data_of(large);
  assert.equal(data.solids.length, 100_000);
  assert.deepEqual(
    data.growth.map((row) => row.cylinders),
    [1000, 2000, 5000, 10_000, 20_000, 50_000, 100_000],
  );
  await page.context().close();
}

rays_hit_what_they_meet();
fits_powers();
const page = await open(address);
for (const step of [
  reads_the_answer,
  sorts_and_searches,
  saves_the_table,
  picks_a_pair,
  shows_less,
  picks_in_the_picture,
  reads_the_charts,
  fits,
])
  await step(page);
await page.context().close();
await opens_a_view_by_its_address();
await shows_a_file();
await shows_a_hundred_thousand();
assert.deepEqual(errors, []);
await says_that_there_is_no_webgl();
assert.deepEqual(asked, [], "nothing is asked from the network");
console.log("crowd_page_test: all well");
await browser.close();
