// SPDX-License-Identifier: MIT
// The hash of everything that the page and the charts are built from.
import { createHash } from "node:crypto";
import { readFileSync, readdirSync } from "node:fs";

const here = new URL("./", import.meta.url);
const others = [
  "build.mjs",
  "package-lock.json",
  "package.json",
  "page.html",
  "stamp.mjs",
  "style.css",
  "tsconfig.json",
];

export function sourcesHash() {
  const names = ["", "parts/", "run/"]
    .flatMap((folder) => readdirSync(new URL(`./${folder}`, here)).map((name) => folder + name))
    .filter((name) => /\.tsx?$/.test(name))
    .concat(others)
    .sort();
  const hash = createHash("sha256");
  for (const name of names)
    hash
      .update(`${name}\0`)
      .update(readFileSync(new URL(name, here)))
      .update("\0");
  return hash.digest("hex");
}
