// SPDX-License-Identifier: MIT
// A browser without network, for the tests of the page.
import { spawnSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { deflateSync } from "node:zlib";

function skip(why) {
  process.exit(
    spawnSync(fileURLToPath(new URL("../../.ci/skip", import.meta.url)), [why], { stdio: "inherit" }).status ?? 1,
  );
}

const browserFile =
  ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"].find(existsSync) ??
  skip("no chromium here: apt-get install chromium");
const { chromium } = await import("playwright-core").catch(() =>
  skip("no playwright-core here: npm ci --prefix reports/web"),
);

/** Removed at the end. */
export const folder = mkdtempSync(join(tmpdir(), "daylight-page-"));
process.on("exit", () => rmSync(folder, { recursive: true }));
/** The longest wait, in ms, for what never comes. A slow machine is not that. */
const patience = 300_000;
export const browser = await chromium.launch({ executablePath: browserFile, timeout: patience });
/** What any page wrote on its console as an error, and what it asked of the network. */
export const errors = [],
  asked = [];

export async function open(address, { scheme = "light", width = 1366 } = {}) {
  const context = await browser.newContext({ colorScheme: scheme, viewport: { width, height: 850 }, offline: true });
  context.setDefaultTimeout(patience);
  const page = await context.newPage();
  page.on("console", (m) => {
    if (m.type() === "error") errors.push(m.text());
  });
  page.on("pageerror", (e) => errors.push(String(e)));
  page.on("request", (r) => {
    if (!/^(file|data|blob):/.test(r.url())) asked.push(r.url());
  });
  await page.goto(address);
  await page.waitForFunction(() => {
    const at = document.getElementById("page");
    return at.hasChildNodes() && at.dataset.whole !== "false"; // drawn
  });
  return page;
}

/** Until what was done is drawn. */
export const settled = (page) =>
  page.evaluate(
    () =>
      new Promise((done) => {
        requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 60)));
      }),
  );

/** The page with data in it, as reports/run/page_template.cpp fills it. */
export function filled(report) {
  const template = readFileSync(new URL("./page_template.html", import.meta.url), "utf8");
  return template.replace("@@DAYLIGHT_REPORT_DATA@@", () => deflateSync(JSON.stringify(report)).toString("base64"));
}
