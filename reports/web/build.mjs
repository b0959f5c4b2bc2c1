// SPDX-License-Identifier: MIT
// Builds what is committed: page_template.html, the page of a run without its data.
//     npm ci && node build.mjs            writes it
//     node build.mjs --check              states whether these sources give it; exit status 1 if not
// The same sources and package-lock.json give the same bytes.
import { createHash } from "node:crypto";
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { build } from "esbuild";

const here = new URL("./", import.meta.url);
const common = {
  bundle: true,
  minify: true,
  write: false,
  metafile: true,
  legalComments: "none",
  charset: "utf8",
  jsx: "automatic",
  jsxImportSource: "preact",
  absWorkingDir: here.pathname,
  logLevel: "warning",
};

/** The packages that are in a bundle, with the licences that ask to go with them: each text once. */
function licences(metafile) {
  const folders = new Set(
    Object.values(metafile.outputs)
      .flatMap((o) => Object.entries(o.inputs))
      .filter(([, { bytesInOutput }]) => bytesInOutput > 0)
      .map(([file]) => /^node_modules\/(?:@[^/]+\/)?[^/]+/.exec(file)?.[0])
      .filter(Boolean),
  );
  const texts = new Map();
  for (const folder of [...folders].sort()) {
    const { name, version, license } = JSON.parse(readFileSync(new URL(`${folder}/package.json`, here), "utf8"));
    const file = ["LICENSE", "LICENSE.md", "LICENSE.txt", "LICENCE"]
      .map((f) => new URL(`${folder}/${f}`, here))
      .find(existsSync);
    const text = file ? readFileSync(file, "utf8").trim() : license;
    texts.set(text, [...(texts.get(text) ?? []), `${name} ${version}`]);
  }
  return [...texts]
    .map(([text, names]) => `${names.join(", ")}:\n\n${text}`)
    .join("\n\n\n")
    .replaceAll("--", "- -")
    .replaceAll("*/", "* /");
}

async function bundle(options) {
  const { outputFiles, metafile } = await build({ ...common, ...options });
  return { text: outputFiles[0].text, licences: licences(metafile) };
}

async function page() {
  const program = await bundle({ entryPoints: ["main.tsx"], format: "iife", target: "es2022" }),
    script = program.text.trimEnd().replaceAll("</script", "<\\/script").replaceAll("<!--", "<\\!--");
  const style = (await bundle({ entryPoints: ["style.css"] })).text.trimEnd();
  const hash = createHash("sha256").update(script).digest("base64");
  const policy = ["default-src 'none'", `script-src 'sha256-${hash}'`, "style-src 'unsafe-inline'"].join("; ");
  // Functions: a string would have its $& replaced.
  return readFileSync(new URL("page.html", here), "utf8")
    .replace("@@POLICY@@", () => policy)
    .replace("@@LICENCES@@", () => program.licences)
    .replace("@@STYLE@@", () => style)
    .replace("@@SCRIPT@@", () => script);
}

const name = "page_template.html",
  file = new URL(name, here),
  text = await page();
if (process.argv.includes("--check")) {
  const same = existsSync(file) && readFileSync(file, "utf8") === text;
  console.log(`${name}: ${same ? "is what these sources give" : "is not what these sources give; run node build.mjs"}`);
  process.exit(same ? 0 : 1);
}
writeFileSync(file, text);
console.log(`${name}: ${text.length} characters`);
