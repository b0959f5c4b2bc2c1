// SPDX-License-Identifier: MIT
// One cause with its simplest and its worst case, and one finding.
import { useState } from "preact/hooks";
import { Copy } from "../parts/elements.tsx";
import { capital, grouped, jsonLine, plural, range, safe, shellQuoted, short } from "../parts/words.ts";
import { CaseView } from "./case_view.tsx";
import type { Cause, Report } from "./data.ts";
import { ClaimWords, Fact, Severity, Table } from "./elements.tsx";
import { addressOf } from "./findings.tsx";
import { about } from "./glossary.ts";
import { kindLabel, sentenceOf } from "./words.ts";

const claimOf = (report: Report, method: string) => report.methods.find((m) => m.name === method)?.claim;

/** The runs, the last one first. */
const Nights = ({ b }: { b: Cause }) => (
  <Table kind="nights" of={["run", "begun", "n:wrong pairs", "n:asked", "n:per million"]}>
    {[...b.nights].reverse().map((n) => (
      <tr key={n.run}>
        <td>{safe(n.run)}</td>
        <td>{safe(n.started.slice(0, 16).replace("T", " "))}</td>
        <td class="n">{grouped(n.count)}</td>
        <td class="n">{grouped(n.asked)}</td>
        <td class="n">
          {short(n.per_million[0])} ({short(n.per_million[1])} to {short(n.per_million[2])})
        </td>
      </tr>
    ))}
  </Table>
);

const day = 86_400_000,
  suppressedDays = 90;

/** One line for suppressions.jsonl; a person fills in the empty fields. */
function suppressionLine(key: string, started: string): string {
  const begun = Date.parse(started);
  const end = new Date((Number.isNaN(begun) ? Date.now() : begun) + suppressedDays * day);
  const expires = end.toISOString().slice(0, 10);
  return jsonLine({ bucket: key, reason: "", link: "", owner: "", expires });
}

function NextSteps({ report, b }: { report: Report; b: Cause }) {
  const run = shellQuoted(report.run.folder),
    key = shellQuoted(b.key);
  return (
    <section class="handling">
      <h3>Next steps</h3>
      <Copy label="Explain it" text={`./daylight explain ${run} ${key}`} />
      <Copy
        label="For the maintainers: a proof, the text of an issue, and a program or case"
        text={`./daylight export ${run} ${key} --out upstream`}
      />
      <Copy label="A line for suppressions.jsonl" text={suppressionLine(b.key, report.run.started)} />
    </section>
  );
}

const fromTo = (first: string, last: string) => safe(first === last || last === "" ? first : `${first} to ${last}`);

/** What it is, since when, who shares it, and what to do. */
function Story({ report, b }: { report: Report; b: Cause }) {
  const claim = claimOf(report, b.method);
  return (
    <>
      <dl class="facts">
        <Fact label="severity">
          <Severity of={b.severity} />
        </Fact>
        <Fact label="findings">
          {grouped(b.count)} <span class="soft">on {plural(b.pairs, "pair")}</span>
        </Fact>
        <Fact label="margins">{range(b.margin)}</Fact>
        <Fact label="since earlier runs">
          <span title={about(b.standing ?? "")}>{b.standing ?? "\u2013"}</span>
        </Fact>
        <Fact label="seen">{fromTo(b.first_seen, b.last_seen)}</Fact>
        {b.first_version && <Fact label="versions">{fromTo(b.first_version, b.last_version)}</Fact>}
      </dl>
      <p>
        {capital(safe([b.cause, ...b.labels.filter((l) => l !== b.cause)].join("; ")))}.{" "}
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
      {b.suppressed && (
        <p class="warn">
          Suppressed until {safe(b.suppressed.expires)} by {safe(b.suppressed.owner)}: {safe(b.suppressed.reason)} (
          {safe(b.suppressed.link)})
        </p>
      )}
      {b.nights.length > 0 && <Nights b={b} />}
      <NextSteps report={report} b={b} />
    </>
  );
}

const shownExamples = 300;

function Examples({ report, b }: { report: Report; b: Cause }) {
  const kept = report.findings.filter((f) => f.bucket === b.key);
  if (kept.length === 0) return null;
  return (
    <details open={kept.length <= 30}>
      <summary>{plural(kept.length, "finding")} kept as examples</summary>
      <Table kind="examples" of={["n:#", "method", "family", "n:margin"]}>
        {kept.slice(0, shownExamples).map((f) => (
          <tr key={f.id}>
            <td class="n">
              <a href={`#/finding/${f.id}`}>{f.id}</a>
            </td>
            <td>{safe(f.method)}</td>
            <td>{safe(kindLabel(f.family))}</td>
            <td class="n">{short(f.margin?.[0])}</td>
          </tr>
        ))}
      </Table>
    </details>
  );
}

export function CauseView({ report, named }: { report: Report; named: string }) {
  const [worst, choose] = useState(false);
  const b = report.buckets.find(({ key }) => key === named);
  if (!b) return <p class="missing">This page has no cause {safe(named)}.</p>;
  return (
    <>
      <p class="crumbs">
        <a href="#/findings">Causes and findings</a>
      </p>
      <h2 tabIndex={-1}>{safe(b.key)}</h2>
      <p class="story">{safe(sentenceOf(b))}.</p>
      <div class="tabs" role="tablist">
        {[b.simplified ? "Simplest" : "As found", "Worst"].map((name, i) => (
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
      <Examples report={report} b={b} />
    </>
  );
}

export function FindingView({ report, named }: { report: Report; named: string }) {
  const at = report.findings.findIndex(({ id }) => String(id) === named),
    f = report.findings[at];
  if (!f) return <p class="missing">This page has no finding {safe(named)}.</p>;
  const claim = claimOf(report, f.method),
    beside = [report.findings[at - 1], report.findings[at + 1]] as const;
  return (
    <>
      <p class="crumbs">
        <a href="#/findings">Causes and findings</a>
        {f.bucket && <a href={addressOf({ key: f.bucket })}>{safe(f.bucket)}</a>}
        <span class="beside">
          {beside[0] && <a href={`#/finding/${beside[0].id}`}>previous</a>}{" "}
          {beside[1] && <a href={`#/finding/${beside[1].id}`}>next</a>}
        </span>
      </p>
      <h2 tabIndex={-1}>
        #{f.id} <b>{safe(f.method)}</b> {safe(kindLabel(f.kind))} <Severity of={f.severity} />
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
