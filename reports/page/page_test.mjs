// SPDX-License-Identifier: MIT
// A reader of the page: opens it from disk in a browser without network, filters, sorts, opens findings and causes,
// turns the drawing, proves again and tampers.
//     node page_test.mjs PAGE.html [--shots FOLDER]
// Exit status 77, and why, where there is no browser or no playwright-core.
import assert from "node:assert/strict";
import { existsSync, mkdirSync } from "node:fs";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";

function skip(why) {
  console.log(`skipped: ${why}`);
  process.exit(77);
}

const browser_file = ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"].find(existsSync) ?? skip("no chromium here (apt-get install chromium)");
const { chromium } = await import("playwright-core").catch(() => skip("no playwright-core here (npm ci in reports/page)"));
const [page_file, option, folder] = process.argv.slice(2);
const address = pathToFileURL(resolve(page_file)).href;
const browser = await chromium.launch({ executablePath: browser_file });
const errors = [], asked = [];

async function open(scheme = "light", script = true) {
  const context = await browser.newContext({ colorScheme: scheme, viewport: { width: 1366, height: 850 }, offline: true, javaScriptEnabled: script });
  const page = await context.newPage();
  page.on("console", (m) => { if (m.type() === "error") errors.push(m.text()); });
  page.on("pageerror", (e) => errors.push(String(e)));
  page.on("request", (r) => { if (!/^(file|data|blob):/.test(r.url())) asked.push(r.url()); });
  await page.goto(address);
  return page;
}

const rows_told = async (page) => Number((await page.locator(".filters [role=status]").innerText()).split(" ")[0].replaceAll(",", ""));

async function shots(to) {
  mkdirSync(to, { recursive: true });
  for (const scheme of ["light", "dark"]) {
    const page = await open(scheme);
    for (const id of ["summary", "findings", "speed", "maps", "honesty", "stability", "methods", "faults"]) {
      const section = page.locator(`section#${id}`);
      await section.scrollIntoViewIfNeeded();
      await page.waitForTimeout(250);
      await section.screenshot({ path: `${to}/${id}-${scheme}.png` });
    }
    for (const [name, link] of [["finding", ".findings tbody a"], ["bucket", ".buckets a"]]) {
      await page.evaluate(() => { location.hash = "#/findings"; });
      if ((await page.locator(link).count()) === 0) continue;
      await page.locator(link).first().click();
      await page.waitForSelector(".case");
      if ((await page.locator(".prove").count()) > 0) await page.locator(".prove").click();
      await page.waitForTimeout(300);
      await page.screenshot({ path: `${to}/${name}-${scheme}.png`, fullPage: true });
    }
    await page.context().close();
  }
  const page = await open();
  await page.emulateMedia({ media: "print" });
  await page.pdf({ path: `${to}/print.pdf` }).catch(() => {});
}

if (option === "--shots") {
  await shots(folder);
  console.log(`errors: ${errors.join("; ") || "none"}`);
  await browser.close();
  process.exit(0);
}
