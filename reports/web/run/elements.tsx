// SPDX-License-Identifier: MIT
// Elements that several sections of the page of a run use.
import type { ComponentChildren } from "preact";
import { screen } from "../parts/plot.ts";
import { shellQuoted } from "../parts/words.ts";
import type { Claim } from "./data.ts";
import { about } from "./glossary.ts";
import type { FullReport } from "./report.ts";
import { claimOrigin, formatClaim } from "./words.ts";

/** A number of the run or of a case under its name. */
export const Fact = ({ label, kind = "", children }: { label: string; kind?: string; children: ComponentChildren }) => (
  <div>
    <dt title={about(label)}>{label}</dt>
    <dd class={kind}>{children}</dd>
  </div>
);

/** The heads of a table; "n:count" of a column of numbers. */
export const Heads = ({ of }: { of: readonly string[] }) => (
  <thead>
    <tr>
      {of.map((head) => {
        const label = head.replace(/^n:/, "");
        return (
          <th scope="col" class={label === head ? "" : "n"} title={about(label)} key={label}>
            {label}
          </th>
        );
      })}
    </tr>
  </thead>
);

/** Which shade of a colour stands for which share. In a dark page the larger share is the brighter one. */
export const ShareLegend = () => (
  <span class="legend" aria-hidden="true">
    Share:
    {["below 1e\u22124", "1e\u22124", "1e\u22123", "0.01", "0.1 and more"].map((words, i) => (
      <span key={words}>
        <i style={{ background: screen.heat[i]! }} /> {words}
      </span>
    ))}
  </span>
);

/** From where on a method claims to be right, and whether it states so. */
export const ClaimWords = ({ of }: { of: Claim }) => (
  <>
    {formatClaim(of)} <span title={about(claimOrigin(of))}>({claimOrigin(of)})</span>
  </>
);

/** The commands that add what a run has no data for, in one folded line. */
export function NotInThisRun({ report }: { report: FullReport }) {
  const run = shellQuoted(report.run.folder),
    bench = `./daylight bench --curves --json bench.json && ./daylight chart ${run} --bench bench.json`;
  const missing = (
    [
      [report.maps, "failure maps", `./daylight chart ${run}`],
      [report.honesty, "calibration curves", `./daylight chart ${run}`],
      [report.speed, "times", bench],
      [report.paths, "answers along paths", `./daylight chart ${run} --stability`],
    ] as const
  ).filter(([data]) => data.length === 0);
  if (missing.length === 0) return null;
  return (
    <details class="missing">
      <summary>This run has no {missing.map(([, what]) => what).join(", ")}</summary>
      <ul>
        {missing.map(([, what, command]) => (
          <li key={what}>
            {what}: <code>{command}</code>
          </li>
        ))}
      </ul>
    </details>
  );
}
