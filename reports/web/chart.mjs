// SPDX-License-Identifier: MIT
// The plots as files for a paper or a README, in Node: daylight chart runs it, with interface Report on standard input.
//     node chart.mjs FOLDER < report.json        writes FOLDER/*.svg and names each on standard output
// The script of the page draws them (chart.ts), as it is built into page_template.html beside this file.
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { argv, exit, stdin } from "node:process";
import { pathToFileURL } from "node:url";
import { runInThisContext } from "node:vm";

const template = readFileSync(new URL("./page_template.html", import.meta.url), "utf8");
const begin = template.lastIndexOf("<script>") + "<script>".length;
runInThisContext(template.slice(begin, template.indexOf("</script>", begin)), { filename: "page_template.html" });

export const { charts, expand, pareto, plain_document } = globalThis.daylight;
export const { exact, floor_sqrt, prove } = globalThis.daylight;
export const { causes_of, chip_counts, filter_of, filtered, filtered_causes, query_of, rows_of } = globalThis.daylight;
export const { is_ordinary, sorted, sorted_causes, view_of, worst_first } = globalThis.daylight;
export const { csv_cell, csv_of, full, glossary, shell_quoted, wrong_distance } = globalThis.daylight;
export const { log_gamma, same_rate_probability } = globalThis.daylight;
export const { frame_around, frame_of, stand_in, study_rows_of, csv_of_study, risk_of } = globalThis.daylight;
export const { gap, gaps_of, free_joints, joint_values, placed } = globalThis.daylight;

if (argv[1] !== undefined && import.meta.url === pathToFileURL(argv[1]).href) {
  const folder = argv[2];
  if (folder === undefined) {
    console.error("usage: node chart.mjs FOLDER < report.json");
    exit(64);
  }
  mkdirSync(folder, { recursive: true });
  let text = "";
  for await (const chunk of stdin.setEncoding("utf8")) text += chunk; // readFileSync(0) fails where a pipe is slow
  for (const [name, svg] of charts(expand(JSON.parse(text)), plain_document())) {
    writeFileSync(`${folder}/${name}.svg`, svg);
    console.log(`${folder}/${name}.svg`);
  }
}
