// SPDX-License-Identifier: MIT
// The plots as files for a paper or a README, in Node: daylight chart runs it, with a page's data on standard input.
//     node chart.mjs FOLDER < report.json        writes FOLDER/*.svg and names each on standard output
// The script of the page draws them (chart.ts), as it is built into page_template.html beside this file.
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { argv, exit, stdin } from "node:process";
import { pathToFileURL } from "node:url";
import { runInThisContext } from "node:vm";

const template = readFileSync(new URL("./page_template.html", import.meta.url), "utf8");
const tag = '<script id="program">',
  begin = template.lastIndexOf(tag) + tag.length;
runInThisContext(template.slice(begin, template.indexOf("</script>", begin)), { filename: "page_template.html" });

export const daylight = globalThis.daylight;

/** The charts of a report with the values of the page's colours, as they are by day. */
export function charts(report) {
  const [, style] = /:root\{([^}]*)/.exec(template),
    values = new Map([...style.matchAll(/(--[^:;]+):\s*([^;]+)/g)].map(([, name, value]) => [name, value]));
  const painted = (svg) => svg.replace(/var\((--[^)]+)\)/g, (_, name) => values.get(name));
  return new Map([...daylight.charts(report)].map(([name, svg]) => [name, painted(svg)]));
}

if (argv[1] !== undefined && import.meta.url === pathToFileURL(argv[1]).href) {
  const folder = argv[2];
  if (folder === undefined) {
    console.error("usage: node chart.mjs FOLDER < report.json");
    exit(64);
  }
  mkdirSync(folder, { recursive: true });
  let text = "";
  for await (const chunk of stdin.setEncoding("utf8")) text += chunk; // readFileSync(0) fails if a pipe is slow
  for (const [name, svg] of charts(daylight.expand(JSON.parse(text)))) {
    writeFileSync(`${folder}/${name}.svg`, svg);
    console.log(`${folder}/${name}.svg`);
  }
}
