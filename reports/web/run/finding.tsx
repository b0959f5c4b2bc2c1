// SPDX-License-Identifier: MIT
// One finding.
import { safe } from "../parts/words.ts";
import { CaseView } from "./case_view.tsx";
import { causeAddress } from "./causes.tsx";
import type { Finding } from "./data.ts";
import { ClaimWords } from "./elements.tsx";
import { about } from "./glossary.ts";
import type { FullReport } from "./report.ts";
import { kindLabel, severityLabels } from "./words.ts";

export function FindingView({
  report,
  finding: f,
  named,
}: {
  report: FullReport;
  finding: Finding | undefined;
  named: string;
}) {
  if (!f) return <p class="missing">This page has no finding {safe(named)}.</p>;
  const at = report.findings.indexOf(f),
    claim = report.methods.find((m) => m.name === f.method)?.claim;
  const beside = (step: number) => report.findings[at + step];
  return (
    <>
      <p class="crumbs">
        <a href="#/findings">Findings</a>
        {f.bucket && (
          <>
            {" "}
            / <a href={causeAddress(f.bucket)}>{safe(f.bucket)}</a>
          </>
        )}
        <span class="beside">
          {beside(-1) && <a href={`#/finding/${beside(-1)!.id}`}>previous</a>}{" "}
          {beside(1) && <a href={`#/finding/${beside(1)!.id}`}>next</a>}
        </span>
      </p>
      <h2 tabIndex={-1}>
        #{f.id} <b>{safe(f.method)}</b> {safe(kindLabel(f.kind))}{" "}
        <span class={f.severity === "contract" ? "bad" : "soft"} title={about(severityLabels[f.severity] ?? "")}>
          {severityLabels[f.severity] ?? safe(f.severity)}
        </span>
      </h2>
      <p class="soft">
        Family {safe(kindLabel(f.family))}.
        {claim && (
          <>
            {" "}
            It claims to be <ClaimWords of={claim} />: {safe(claim.source)}.
          </>
        )}
        {f.reason && ` The method reports: ${safe(f.reason)}`}
      </p>
      <CaseView shown={f} method={f.method} />
    </>
  );
}
