// SPDX-License-Identifier: MIT
// One cause with its simplest and its worst case.
import { useState } from "preact/hooks";
import { Copy } from "../parts/elements.tsx";
import { capital, grouped, jsonLine, leastRange, percent, plural, safe, shellQuoted, short } from "../parts/words.ts";
import { CaseView } from "./case_view.tsx";
import { formatRun } from "./causes.tsx";
import type { Cause, Finding, Night } from "./data.ts";
import { ClaimWords, Fact, Heads } from "./elements.tsx";
import { about } from "./glossary.ts";
import type { FullReport } from "./report.ts";
import { sentenceOf } from "./sentence.ts";
import { kindLabel, severityLabels, standingLabel } from "./words.ts";

/** The runs, the last one first. */
const Nights = ({ nights }: { nights: Night[] }) => (
  <div class="scroll">
    <table class="plain nights">
      <Heads of={["run", "begun", "n:wrong pairs", "n:asked", "n:per million"]} />
      <tbody>
        {[...nights].reverse().map((n) => (
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
      </tbody>
    </table>
  </div>
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

function NextSteps({ report, b }: { report: FullReport; b: Cause }) {
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
      <p class="soft">
        Its pair is in <code>{safe(b.file)}</code>.
      </p>
    </section>
  );
}

/** What it is, since when, who shares it, and what to do. */
function Story({ report, b }: { report: FullReport; b: Cause }) {
  const claim = report.methods.find((m) => m.name === b.method)?.claim;
  const asked = b.nights.at(-1)?.asked;
  const severity = severityLabels[b.severity] ?? safe(b.severity);
  return (
    <>
      <dl class="facts">
        <Fact label="severity" kind={b.severity === "contract" ? "bad" : ""}>
          <span title={about(severity)}>{severity}</span>
        </Fact>
        <Fact label="findings">
          {grouped(b.count)}
          {asked !== undefined && (
            <span class="soft">
              {" "}
              on {grouped(b.pairs)} of {plural(asked, "pair")}
            </span>
          )}
        </Fact>
        <Fact label="margins">{leastRange(b.margin)}</Fact>
        {b.share && (
          <Fact label="failures on similar pairs">
            {percent(b.share.wrong, b.share.asked)} <span class="soft">of {grouped(b.share.asked)}</span>
          </Fact>
        )}
        <Fact label="feature">{safe(b.feature)}</Fact>
        <Fact label="depends on">{safe(b.coordinate)}</Fact>
        <Fact label="since earlier runs">
          <span title={about(b.standing ?? "")}>{standingLabel(b.standing)}</span>
        </Fact>
        <Fact label="seen">
          {formatRun(b, b.first_seen)}
          {b.last_seen !== b.first_seen && ` to ${formatRun(b, b.last_seen)}`}
        </Fact>
        {b.first_version && (
          <Fact label="versions">
            {safe(b.first_version)}
            {b.last_version !== b.first_version && ` to ${safe(b.last_version)}`}
          </Fact>
        )}
      </dl>
      {claim && (
        <p class="soft">
          {safe(b.method)} claims to be <ClaimWords of={claim} />.
        </p>
      )}
      <p>
        {capital(safe(b.cause))}. <span class="soft">Methods: {safe(b.methods.join(", "))}.</span>
      </p>
      {b.labels.length > 0 && (
        <p>
          {b.labels.filter((l) => l !== b.cause).map((l) => (
            <span class="tag" key={l}>
              {safe(l)}
            </span>
          ))}
        </p>
      )}
      {b.suppressed && (
        <p class="warn">
          Suppressed until {safe(b.suppressed.expires)} by {safe(b.suppressed.owner)}: {safe(b.suppressed.reason)} (
          {safe(b.suppressed.link)})
        </p>
      )}
      {b.nights.length > 0 && <Nights nights={b.nights} />}
      <NextSteps report={report} b={b} />
    </>
  );
}

function Examples({ kept, b }: { kept: Finding[]; b: Cause }) {
  return (
    <details open={kept.length <= 30}>
      <summary>
        {plural(kept.length, "finding")} kept as examples, of {plural(b.families.length, "family", "families")}
      </summary>
      <table class="plain">
        <Heads of={["n:#", "method", "family", "n:margin"]} />
        <tbody>
          {kept.slice(0, 300).map((f) => (
            <tr key={f.id}>
              <td class="n">
                <a href={`#/finding/${f.id}`}>{f.id}</a>
              </td>
              <td>{safe(f.method)}</td>
              <td>{safe(kindLabel(f.family))}</td>
              <td class="n">{short(f.margin?.[0])}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </details>
  );
}

export function CauseView({
  report,
  cause: b,
  finding,
  named,
}: {
  report: FullReport;
  cause: Cause | undefined;
  finding: Map<number, Finding>;
  named: string;
}) {
  const [worst, choose] = useState(false);
  if (!b) return <p class="missing">This page has no cause {safe(named)}.</p>;
  const shown = worst ? b.worst : b.simplest;
  const kept = b.findings.map((id) => finding.get(id)).filter((f) => f !== undefined);
  return (
    <>
      <p class="crumbs">
        <a href="#/findings">Findings</a>
      </p>
      <h2 tabIndex={-1}>{safe(b.key)}</h2>
      <p class="story">{safe(sentenceOf(b))}.</p>
      <div class="tabs" role="tablist">
        <button type="button" role="tab" aria-selected={!worst} onClick={() => choose(false)}>
          {b.simplified ? "Simplest" : "As found"}
        </button>
        <button type="button" role="tab" aria-selected={worst} onClick={() => choose(true)}>
          Worst
        </button>
      </div>
      <CaseView
        shown={shown}
        method={b.method}
        story={<Story report={report} b={b} />}
        key={worst ? "worst" : "simplest"}
      />
      {b.merged.length > 0 && (
        <details>
          <summary>{plural(b.merged.length, "finer key")} that this cause merges</summary>
          <ul>
            {b.merged.map((k) => (
              <li key={k}>{safe(k)}</li>
            ))}
          </ul>
        </details>
      )}
      {kept.length > 0 && <Examples kept={kept} b={b} />}
    </>
  );
}
