// SPDX-License-Identifier: MIT
// Builds what is committed: ../report_template.html, the page without its data, and chart.mjs, the plots for Node.
//     npm ci && node build.mjs            writes both
//     node build.mjs --check              says whether both are what these sources give; exit status 1 where not
// The same sources and package-lock.json give the same bytes. Both carry the hash of what they were built from, which
// stamp_test.mjs holds against the sources without npm.
import { createHash } from "node:crypto";
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { build } from "esbuild";
import { sources_hash } from "./stamp.mjs";

const here = new URL("./", import.meta.url);
const stamp = sources_hash();
const common = { bundle: true, minify: true, write: false, legalComments: "none", charset: "utf8", jsx: "automatic",
  jsxImportSource: "preact", absWorkingDir: here.pathname, logLevel: "warning" };

async function bundle(options) {
  return (await build({ ...common, ...options })).outputFiles[0].text;
}

async function page() {
  const script = (await bundle({ entryPoints: ["main.tsx"], format: "iife", target: "es2022" }))
    .trimEnd().replaceAll("</script", "<\\/script").replaceAll("<!--", "<\\!--");
  const style = (await bundle({ entryPoints: ["style.css"] })).trimEnd();
  const hash = (text) => `'sha256-${createHash("sha256").update(text).digest("base64")}'`;
  const policy = `default-src 'none'; script-src ${hash(script)}; style-src 'unsafe-inline'; img-src data: blob:`;
  // Functions: a string would have its $& replaced.
  return readFileSync(new URL("page.html", here), "utf8")
    .replace("@@STAMP@@", () => stamp).replace("@@POLICY@@", () => policy)
    .replace("@@STYLE@@", () => style).replace("@@SCRIPT@@", () => script);
}

async function chart() {
  const text = await bundle({ entryPoints: ["chart.ts"], format: "esm", platform: "node", target: "node18",
    banner: { js: `// SPDX-License-Identifier: MIT\n// Built by build.mjs, not written by hand. Sources: ${stamp}` } });
  return text;
}

const outputs = [["../report_template.html", await page()], ["chart.mjs", await chart()]];
let stale = false;
for (const [name, text] of outputs) {
  const file = new URL(name, here);
  if (process.argv.includes("--check")) {
    const same = existsSync(file) && readFileSync(file, "utf8") === text;
    console.log(`${name}: ${same ? "is what these sources give" : "is not what these sources give; run node build.mjs"}`);
    stale ||= !same;
  } else {
    writeFileSync(file, text);
    console.log(`${name}: ${text.length} characters`);
  }
}
process.exit(stale ? 1 : 0);
