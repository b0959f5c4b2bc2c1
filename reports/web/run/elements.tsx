// SPDX-License-Identifier: MIT
// Elements that several sections of the page of a run use.
import type { ComponentChildren } from "preact";
import { shade } from "../parts/plot.ts";
import type { Claim } from "./data.ts";
import { about } from "./glossary.ts";
import { claimOrigin, formatClaim, severityLabels } from "./words.ts";

/** A number of the run or of a case under its name. */
export const Fact = ({ label, kind = "", children }: { label: string; kind?: string; children: ComponentChildren }) => (
  <div>
    <dt title={about(label)}>{label}</dt>
    <dd class={kind}>{children}</dd>
  </div>
);

/** A table with its heads; "n:count" of a column of numbers. */
export const Table = ({ of, kind, children }: { of: string[]; kind: string; children: ComponentChildren }) => (
  <div class="scroll">
    <table class={`plain ${kind}`}>
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
      <tbody>{children}</tbody>
    </table>
  </div>
);

/** The meaning of the colours of cells. A larger share has a stronger colour. */
export const Legend = ({ empty }: { empty: string }) => (
  <p class="legend" aria-hidden="true">
    {[
      [shade("bad", 4), "beyond the claim or failed"],
      [shade("within", 4), "within the claim"],
      [shade("undecided", 4), "undecided or declined"],
      ["var(--clean)", "none of these"],
      ["var(--bg)", empty],
    ].map(([background, words]) => (
      <span class="whole" key={words}>
        <i style={{ background }} /> {words}
      </span>
    ))}
    <span class="whole">&emsp;A cell shows the first that applies.</span>
  </p>
);

export const Severity = ({ of }: { of: string }) => {
  const label = severityLabels[of] ?? of;
  return (
    <span class={of === "contract" ? "bad" : ""} title={about(label)}>
      {label}
    </span>
  );
};

/** The margin from which on a method claims to be right, and whether its library states it. */
export const ClaimWords = ({ of }: { of: Claim }) => (
  <>
    {formatClaim(of)} <span title={about(claimOrigin(of))}>({claimOrigin(of)})</span>
  </>
);
