// SPDX-License-Identifier: MIT
// One finding, or one cause with its simplest and its worst case.
import { useMemo, useState } from "preact/hooks";
import type { Answer, Bucket, Case, Finding, Truth } from "./data.ts";
import { bucket_address } from "./causes.tsx";
import { PairView } from "./pair_view.tsx";
import { Copy } from "./parts.tsx";
import { prove, type Proof } from "./prove.ts";
import type { FullReport } from "./report.ts";
import {
  claim_words,
  coordinate_words,
  group_by,
  grouped,
  kind_words,
  percent,
  plural,
  range,
  safe,
  severity_words,
  shell_quoted,
  short,
} from "./words.ts";

/** The part of a truth that is a certificate, as one may edit it. */
function certificate_of({ verdict, direction, point, near }: Truth) {
  return JSON.stringify({ verdict, ...(direction && { direction }), ...(point && { point }), ...(near && { near }) });
}

const certificate_words = (t: Truth) =>
  t.direction
    ? "A plane square to this direction has one solid on each side."
    : t.point
      ? "This point lies in both solids."
      : t.near
        ? "No rational common point is known: this one is within 2^-200 of the size of both, and along the direction " +
          "neither a gap nor an overlap is wider."
        : "";

function Prover({ shown }: { shown: Case }) {
  const given = useMemo(() => certificate_of(shown.truth), [shown]);
  const [text, edit] = useState(given);
  const [proof, tell] = useState<Proof | null>(null);
  const check = () => {
    try {
      tell(prove(shown.pair, JSON.parse(text) as Truth));
    } catch {
      tell({ holds: false, text: "Refuted: this is not JSON.", steps: [] });
    }
  };
  return (
    <section class="prover">
      <h3>Certificate</h3>
      <p>{certificate_words(shown.truth)}</p>
      <textarea
        spellcheck={false}
        rows={Math.min(6, Math.ceil(text.length / 62))}
        value={text}
        aria-label="The certificate; change it to see the proof fail"
        onInput={(event) => {
          edit(event.currentTarget.value);
          tell(null);
        }}
      />
      <p class="tools">
        <button type="button" class="prove" onClick={check}>
          Prove again
        </button>
        {text !== given && (
          <button
            type="button"
            onClick={() => {
              edit(given);
              tell(null);
            }}>
            As it was
          </button>
        )}
        <span class="soft">checked here, in exact whole numbers; change a digit to see it fail</span>
      </p>
      {proof && (
        <div
          class={`proof ${proof.holds === true ? "ok" : proof.holds === false ? "bad" : "warn"}`}
          role="status"
          data-holds={String(proof.holds)}>
          <b>{proof.text}</b>
          {proof.steps.length > 0 && (
            <ul>
              {proof.steps.map((s, i) => (
                <li key={i}>{s}</li>
              ))}
            </ul>
          )}
        </div>
      )}
    </section>
  );
}

function answer_words(a: Answer): string {
  if (a.failed) return `failed: ${a.failed}${a.reason ? `, \u201c${a.reason}\u201d` : ""}`;
  if (a.declined !== undefined) return `declined${a.declined ? `: ${a.declined}` : ""}`;
  return [
    a.verdict ?? "no verdict",
    ...(a.distance === undefined ? [] : [`distance ${a.distance}`]),
    ...(a.direction ? [`direction (${a.direction.join(", ")})`] : []),
    ...(a.point ? [`point (${a.point.map(coordinate_words).join(", ")})`] : []),
  ].join(", ");
}

function wrong_verdict(a: Answer, truth: Truth) {
  if (a.failed) return true;
  const meets = truth.verdict === "intersecting" || truth.verdict === "touching";
  return (
    (a.verdict === "disjoint" && meets) ||
    ((a.verdict === "intersecting" || a.verdict === "touching") && truth.verdict === "disjoint")
  );
}

function Answers({ shown, method }: { shown: Case; method: string }) {
  const said = group_by(Object.entries(shown.answers), ([name, a]) => (name === method ? "\0" : "") + answer_words(a));
  const order = [...said].sort(
    (x, y) =>
      Number(y[0].startsWith("\0")) - Number(x[0].startsWith("\0")) ||
      Number(wrong_verdict(y[1][0]![1], shown.truth)) - Number(wrong_verdict(x[1][0]![1], shown.truth)) ||
      y[1].length - x[1].length,
  );
  if (order.length === 0) return null;
  return (
    <section>
      <h3>What each method said</h3>
      <table class="plain answers">
        <thead>
          <tr>
            <th>answer</th>
            <th>from</th>
          </tr>
        </thead>
        <tbody>
          {order.map(([key, who]) => (
            <tr key={key} class={key.startsWith("\0") ? "its" : ""}>
              <td class={`wrap ${wrong_verdict(who[0]![1], shown.truth) ? "bad" : ""}`}>
                {safe(answer_words(who[0]![1]))}
              </td>
              <td class="wrap">
                {who.map(([name], i) => (
                  <>
                    {i > 0 && ", "}
                    {name === method ? <b>{safe(name)}</b> : safe(name)}
                  </>
                ))}
              </td>
            </tr>
          ))}
        </tbody>
      </table>
    </section>
  );
}

const vector = (v: readonly number[]) => `(${v.join(", ")})`;

function Solids({ shown }: { shown: Case }) {
  const { a, b } = shown.pair;
  return (
    <table class="plain solids">
      <thead>
        <tr>
          <th />
          <th>centre</th>
          <th>axis</th>
          <th class="n">radius</th>
          <th class="n">height</th>
        </tr>
      </thead>
      <tbody>
        {(
          [
            ["a", a],
            ["b", b],
          ] as const
        ).map(([name, c]) => (
          <tr key={name}>
            <th scope="row">
              <i class={`swatch ${name}`} />
              {name}
            </th>
            <td class="wrap num">{vector(c.center)}</td>
            <td class="wrap num">{vector(c.axis)}</td>
            <td class="n">{String(c.radius)}</td>
            <td class="n">{String(c.height)}</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}

function CaseView({ shown, method }: { shown: Case; method: string }) {
  const { truth } = shown;
  return (
    <div class="case">
      <div class="left">
        <PairView shown={shown} />
        <Solids shown={shown} />
        <Copy label="Ask again" text={shown.replay} />
        <Copy label="The pair" text={JSON.stringify(shown.pair)} />
        {shown.note && <p class="soft">From: {safe(shown.note)}</p>}
      </div>
      <div class="right">
        <dl class="facts">
          <div>
            <dt>truth</dt>
            <dd>{truth.verdict}</dd>
          </div>
          <div>
            <dt>signed distance</dt>
            <dd>{range(truth.distance)}</dd>
          </div>
          <div>
            <dt>margin</dt>
            <dd>{range(shown.margin)}</dd>
          </div>
          {truth.stage && (
            <div>
              <dt>settled in</dt>
              <dd>
                {{ filter: "double intervals", wide: "multiple precision", exact: "rationals" }[truth.stage] ??
                  safe(truth.stage)}
              </dd>
            </div>
          )}
        </dl>
        {truth.direction || truth.point || truth.near ? (
          <Prover shown={shown} />
        ) : (
          <p class="warn">Nobody could prove what is true of this pair.</p>
        )}
        <Answers shown={shown} method={method} />
      </div>
    </div>
  );
}

function Gone({ what, named }: { what: string; named: string }) {
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

export function FindingView({
  report,
  finding: f,
  named,
}: {
  report: FullReport;
  finding: Finding | undefined;
  named: string;
}) {
  if (!f) return <Gone what="finding" named={named} />;
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
            / <a href={bucket_address(f.bucket)}>{safe(f.bucket)}</a>
          </>
        )}
        <span class="beside">
          {beside(-1) && <a href={`#/finding/${beside(-1)!.id}`}>previous</a>}{" "}
          {beside(1) && <a href={`#/finding/${beside(1)!.id}`}>next</a>}
        </span>
      </p>
      <h2>
        #{f.id} <b>{safe(f.method)}</b> {safe(kind_words(f.kind))}{" "}
        <span class={f.severity === "contract" ? "bad" : "soft"}>{severity_words[f.severity] ?? safe(f.severity)}</span>
      </h2>
      <p class="soft">
        Family {safe(f.family)}.{claim && ` It claims to be ${claim_words(claim)} (${safe(claim.source)}).`}
        {f.reason && ` In its own words: ${safe(f.reason)}`}
      </p>
      <CaseView shown={f} method={f.method} />
    </>
  );
}

export function BucketView({
  report,
  bucket: b,
  finding,
  named,
}: {
  report: FullReport;
  bucket: Bucket | undefined;
  finding: Map<number, Finding>;
  named: string;
}) {
  const [worst, choose] = useState(false);
  if (!b) return <Gone what="cause" named={named} />;
  const shown = worst && b.worst ? b.worst : b.simplest;
  const kept = b.findings.map((id) => finding.get(id)).filter((f) => f !== undefined);
  const folder = report.run.folder ?? report.run.id;
  return (
    <>
      <p class="crumbs">
        <a href="#/findings">Findings</a>
      </p>
      <h2>{safe(b.key)}</h2>
      <dl class="facts">
        <div>
          <dt>severity</dt>
          <dd class={b.severity === "contract" ? "bad" : ""}>{severity_words[b.severity] ?? safe(b.severity)}</dd>
        </div>
        <div>
          <dt>findings</dt>
          <dd>{grouped(b.count)}</dd>
        </div>
        <div>
          <dt>margins</dt>
          <dd>{range(b.margin)}</dd>
        </div>
        {b.share && (
          <div>
            <dt>of its stratum</dt>
            <dd>
              {percent(b.share.wrong, b.share.asked)} <span class="soft">of {grouped(b.share.asked)}</span>
            </dd>
          </div>
        )}
        <div>
          <dt>feature</dt>
          <dd>{safe(b.feature)}</dd>
        </div>
        <div>
          <dt>what still matters</dt>
          <dd>{safe(b.coordinate)}</dd>
        </div>
        <div>
          <dt>standing</dt>
          <dd>{b.standing ?? "\u2013"}</dd>
        </div>
        <div>
          <dt>seen</dt>
          <dd>
            {safe(b.first_seen)}
            {b.last_seen !== b.first_seen && ` to ${safe(b.last_seen)}`}
          </dd>
        </div>
      </dl>
      {b.cause && (
        <p>
          {safe(b.cause)}.{b.methods && <span class="soft"> Wrong by it: {safe(b.methods.join(", "))}.</span>}
        </p>
      )}
      {b.labels.length > 0 && (
        <p>
          {b.labels.map((l) => (
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
      <div class="tabs" role="tablist">
        <button type="button" role="tab" aria-selected={!worst} onClick={() => choose(false)}>
          Simplest
        </button>
        <button type="button" role="tab" aria-selected={worst} disabled={!b.worst} onClick={() => choose(true)}>
          Worst
        </button>
      </div>
      <CaseView shown={shown} method={b.method} key={worst ? "worst" : "simplest"} />
      <Copy label="Explain it" text={`./daylight triage ${shell_quoted(folder)} --explain ${shell_quoted(b.key)}`} />
      {b.merged.length > 0 && (
        <details class="print">
          <summary>{plural(b.merged.length, "key")} that led to this cause</summary>
          <ul>
            {b.merged.map((k) => (
              <li key={k}>{safe(k)}</li>
            ))}
          </ul>
        </details>
      )}
      {kept.length > 0 && (
        <details class="print" open={kept.length <= 30}>
          <summary>
            {plural(kept.length, "finding")} kept, of {plural(b.families.length, "family", "families")}
          </summary>
          <table class="plain">
            <thead>
              <tr>
                <th class="n">#</th>
                <th>method</th>
                <th>family</th>
                <th class="n">margin</th>
              </tr>
            </thead>
            <tbody>
              {kept.slice(0, 300).map((f) => (
                <tr key={f.id}>
                  <td class="n">
                    <a href={`#/finding/${f.id}`}>{f.id}</a>
                  </td>
                  <td>{safe(f.method)}</td>
                  <td>{safe(f.family)}</td>
                  <td class="n">{short(f.margin?.[0])}</td>
                </tr>
              ))}
            </tbody>
          </table>
        </details>
      )}
    </>
  );
}
