// SPDX-License-Identifier: MIT
// Elements that several sections of the page of a run use.
import type { ComponentChildren } from "preact";
import { groupBy, safe, shellQuoted } from "../parts/words.ts";
import type { Claim } from "./data.ts";
import type { FullReport } from "./report.ts";
import { about } from "./glossary.ts";
import { claimOrigin, formatClaim } from "./words.ts";

/** A number of the run or of a case under its name. */
export function Fact({ label, kind = "", children }: { label: string; kind?: string; children: ComponentChildren }) {
  return (
    <div>
      <dt title={about(label)}>{label}</dt>
      <dd class={kind}>{children}</dd>
    </div>
  );
}

/** The heads of a table; "n:count" of a column of numbers. `told`: the meaning of other heads. */
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

/** From where on a method claims to be right, and whether it states so. */
export const ClaimWords = ({ of }: { of: Claim }) => (
  <>
    {formatClaim(of)}
    {" "}
    <span title={about(claimOrigin(of))}>({claimOrigin(of)})</span>
  </>
);

/** Instead of a finding or cause that the page does not have. */
export function Gone({ what, named }: { what: string; named: string }) {
  return (
    <>
      <p>
        <a href="#/findings">Back to the findings</a>
      </p>
      <p class="missing">
        This page has no {what} {safe(named)}.
      </p>
    </>
  );
}

/** Which command gives a run the data of a section. */
const makes = {
  buckets: ["causes yet", (run: string) => `./daylight triage ${run}`],
  maps: ["failure maps", (run: string) => `./daylight chart ${run}`],
  honesty: ["calibration curves", (run: string) => `./daylight chart ${run}`],
  speed: [
    "times",
    (run: string) => `./daylight bench --curves --json bench.json && ./daylight chart ${run} --bench bench.json`,
  ],
  cost: [
    "costs against margin",
    (run: string) => `./daylight bench --curves --json bench.json && ./daylight chart ${run} --bench bench.json`,
  ],
  paths: ["answers along paths", (run: string) => `./daylight chart ${run} --stability`],
} as const;

/** What the run has no data for. */
const isMissing = {
  maps: (r) => r.maps.length === 0,
  honesty: (r) => r.honesty.length === 0,
  speed: (r) => r.speed.length === 0,
  cost: (r) => r.cost.length === 0,
  paths: (r) => r.paths.length === 0,
} satisfies Partial<Record<keyof typeof makes, (report: FullReport) => boolean>>;

/** One line for all sections without data; unfolded, the command that adds each. */
export function NotInThisRun({ report }: { report: FullReport }) {
  const missing = (Object.keys(isMissing) as (keyof typeof isMissing)[]).filter((key) => isMissing[key](report));
  if (missing.length === 0) return null;
  const byCommand = groupBy(missing, (key) => makes[key][1](shellQuoted(report.run.folder)));
  const names = (keys: (keyof typeof isMissing)[]) => keys.map((key) => makes[key][0]).join(", ");
  return (
    <details class="missing print">
      <summary>This run has no {names(missing)}</summary>
      <ul>
        {[...byCommand].map(([command, keys]) => (
          <li key={command}>
            {names(keys)}: <code>{command}</code>
          </li>
        ))}
      </ul>
    </details>
  );
}

/** The text of a run whose findings have no causes yet. */
export function Missing({ of, report }: { of: keyof typeof makes; report: FullReport }) {
  const [what, command] = makes[of];
  return (
    <p class="missing">
      This run has no {what}. Run <code>{command(shellQuoted(report.run.folder))}</code> to add this.
    </p>
  );
}
