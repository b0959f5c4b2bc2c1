// SPDX-License-Identifier: MIT
// A small run for the tests of the page. It is real: run.json.gz has the output of these commands.
//     M=intersect,distance,fcl,bullet-cylinder,ode,seedbook
//     F=random,needles,disks,axes_nearly_parallel,touching_side_side,lattice
//     daylight campaign --methods $M --families $F --pairs 400 --cases '' --seed 2 --out runs/earlier
//     daylight triage runs/earlier --for 10s
//     daylight campaign --methods $M --families $F --pairs 600 --cases '' --seed 1 --out runs/sample
//     daylight triage runs/sample --for 20s
//     daylight bench --curves --methods $M --min-time 0.005 --passes 1 --pairs 200 --json bench.json
//     daylight chart runs/sample --bench bench.json --stability --out charts
//     reports/web/page_data.py runs/sample/report.html | gzip -9n >reports/web/run/run.json.gz
import { readFileSync } from "node:fs";
import { gunzipSync } from "node:zlib";

const text = gunzipSync(readFileSync(new URL("run.json.gz", import.meta.url))).toString();
/** A copy that a test may change. */
export const sample = () => JSON.parse(text);
/** The same before triage. */
export const untriaged = () => {
  const report = { ...sample(), causes: [], maps: [], speed: [], paths: [] };
  for (const finding of report.findings) finding.cause = null;
  return report;
};
