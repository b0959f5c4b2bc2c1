// SPDX-License-Identifier: MIT
// One cause with its simplest and its worst case, and one finding.
import { useState } from "preact/hooks";
import { Copy } from "../parts/elements.tsx";
import { grouped, range, safe, shellQuoted } from "../parts/words.ts";
import { CaseView } from "./case_view.tsx";
import type { Cause, Report } from "./data.ts";
import { ClaimWords, Fact, Severity } from "./elements.tsx";
import { addressOf, toFindings } from "./findings.tsx";
import { about } from "./glossary.ts";
import { isOfNewFamilies, kindLabel, sentenceOf } from "./words.ts";

const fromTo = (first: string, last: string) => safe(first === last || last === "" ? first : `${first} to ${last}`);

/** The facts of a cause, its methods, and the command that exports it. */
function Story({ report, b }: { report: Report; b: Cause }) {
  const claim = report.methods.find((m) => m.name === b.method)?.claim;
  return (
    <>
      <dl class="facts">
        <Fact label="severity">
          <Severity of={b.severity} />
        </Fact>
        <Fact label="findings">
          <a href={toFindings({ text: b.key })}>{grouped(b.count)}</a>
        </Fact>
        <Fact label="margins">{range(b.margin)}</Fact>
        <Fact label="since earlier runs">
          <span title={about(b.status ?? "")}>{b.status ?? "\u2013"}</span>
          {isOfNewFamilies(b) && <span class="soft"> (no earlier run tested this method on these families)</span>}
        </Fact>
        <Fact label="seen">{fromTo(b.first_seen, b.last_seen)}</Fact>
        {b.first_version && <Fact label="versions">{fromTo(b.first_version, b.last_version)}</Fact>}
      </dl>
      <p class="reason">
        {safe([b.cause, ...b.labels.filter((l) => l !== b.cause)].join("; "))}.{" "}
        <span class="soft">
          Methods: {safe(b.methods.join(", "))}.
          {claim && (
            <>
              {" "}
              {safe(b.method)} claims to be <ClaimWords of={claim} />.
            </>
          )}
        </span>
      </p>
      <Copy
        label="For the maintainers of a library: a proof, the text of an issue, and a program or case"
        text={`./daylight export ${shellQuoted(report.run.folder)} ${shellQuoted(b.key)} --out upstream`}
      />
    </>
  );
}

export function CauseView({ report, named }: { report: Report; named: string }) {
  const [worst, choose] = useState(false);
  const b = report.causes.find(({ key }) => key === named);
  if (!b) return <p class="missing">This page has no cause {safe(named)}.</p>;
  return (
    <>
      <p class="crumbs">
        <a href="#/findings">Causes and findings</a>
      </p>
      <h2 tabIndex={-1}>{safe(b.key)}</h2>
      <p class="story">{safe(sentenceOf(b))}.</p>
      <div class="tabs" role="tablist">
        {[b.simplified ? "Simplest" : "A pair (not simplified)", "Worst"].map((name, i) => (
          <button type="button" role="tab" aria-selected={worst === (i > 0)} onClick={() => choose(i > 0)} key={name}>
            {name}
          </button>
        ))}
      </div>
      <CaseView
        shown={worst ? b.worst : b.simplest}
        method={b.method}
        story={<Story report={report} b={b} />}
        key={worst ? "worst" : "simplest"}
      />
    </>
  );
}

export function FindingView({ report, named }: { report: Report; named: string }) {
  const f = report.findings.find(({ id }) => String(id) === named);
  if (!f) return <p class="missing">This page has no finding {safe(named)}.</p>;
  const of = report.methods.find((m) => m.name === f.method);
  return (
    <>
      <p class="crumbs">
        <a href="#/findings">Causes and findings</a>
        {f.cause && <a href={addressOf({ key: f.cause })}>{safe(f.cause)}</a>}
      </p>
      <h2 tabIndex={-1}>
        #{f.id} <b>{safe(f.method)}</b> {safe(kindLabel(f.kind))} <Severity of={f.severity} />
      </h2>
      <p class="soft">
        Family {safe(kindLabel(f.family))}.
        {of && (
          <>
            {" "}
            {safe(`${of.library} ${of.version}`)} claims to be <ClaimWords of={of.claim} />: {safe(of.claim.source)}.
          </>
        )}
        {f.reason && ` The method reports: ${safe(f.reason)}`}
      </p>
      <CaseView shown={f} method={f.method} />
    </>
  );
}
