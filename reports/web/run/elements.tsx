// SPDX-License-Identifier: MIT
// Elements that several sections of the page of a run use.
import type { ComponentChildren } from "preact";
import { shellQuoted } from "../parts/words.ts";
import type { FullReport } from "./report.ts";
import { about } from "./glossary.ts";

/** A number of the run or of a case under its name. */
export function Fact({ label, kind = "", children }: { label: string; kind?: string; children: ComponentChildren }) {
  return (
    <div>
      <dt title={about(label)}>{label}</dt>
      <dd class={kind}>{children}</dd>
    </div>
  );
}

/** The heads of a table; "n:count" of a column of numbers. `told`: what heads mean that are no words of ours. */
export function Heads({ of, told = "" }: { of: readonly string[]; told?: string }) {
  return (
    <thead>
      <tr>
        {of.map((head) => {
          const label = head.replace(/^n:/, "");
          return (
            <th scope="col" class={label === head ? "" : "n"} title={about(label) ?? told} key={label}>
              {label}
            </th>
          );
        })}
      </tr>
    </thead>
  );
}

/** Which command gives a run the data of a section. */
const makes = {
  buckets: ["causes: nobody has looked for the reasons of its findings", (run: string) => `./daylight triage ${run}`],
  maps: ["failure maps", (run: string) => `./daylight chart ${run}`],
  honesty: ["curves of wrongness against margin", (run: string) => `./daylight chart ${run}`],
  speed: [
    "times",
    (run: string) => `./daylight bench --curves --json bench.json && ./daylight chart ${run} --bench bench.json`,
  ],
  cost: [
    "times against margin",
    (run: string) => `./daylight bench --curves --json bench.json && ./daylight chart ${run} --bench bench.json`,
  ],
  paths: ["walks along paths", (run: string) => `./daylight chart ${run} --stability`],
  backward: ["backward errors", (run: string) => `./daylight chart ${run} --stability`],
  builds: ["comparison of builds", (run: string) => `./daylight chart ${run} --stability`],
  kill_matrix: ["measure of our own tests", () => "./daylight mutants matrix"],
} as const;

/** What stands where a run has no data of a kind. */
export function Missing({ of, report }: { of: keyof typeof makes; report: FullReport }) {
  const [what, command] = makes[of];
  return (
    <p class="missing">
      This run has no {what}. <code>{command(shellQuoted(report.run.folder))}</code> makes it.
    </p>
  );
}
