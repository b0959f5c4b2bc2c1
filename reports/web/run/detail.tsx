// SPDX-License-Identifier: MIT
// One finding, or one cause with its simplest and its worst case.
import type { ComponentChildren } from "preact";
import { useMemo, useState } from "preact/hooks";
import type { Answer, Truth } from "../parts/data.ts";
import { Copy } from "../parts/elements.tsx";
import { prove, type Proof } from "../parts/prove.ts";
import { digits17, full, groupBy, grouped, leastRange, percent, plural, range, safe, short } from "../parts/words.ts";
import { bucketAddress, formatRun } from "./causes.tsx";
import type { Bucket, Case, Claim, Finding } from "./data.ts";
import { wrongDistance, type Allowed, type WrongDistance } from "./distance.ts";
import { Fact, Heads } from "./elements.tsx";
import { about } from "./glossary.ts";
import { Handling } from "./handling.tsx";
import { Nights } from "./nights.tsx";
import { PairView } from "./pair_view.tsx";
import type { FullReport } from "./report.ts";
import { sentenceOf } from "./sentence.ts";
import { formatClaim, formatCoordinate, kindLabel, claimOrigin, severityLabels, standingLabel } from "./words.ts";

/** The part of a truth that is a certificate, as one may edit it. */
function certificateOf({ verdict, direction, point, points, near }: Truth) {
  return JSON.stringify({
    verdict,
    ...(direction && { direction }),
    ...(point && { point }),
    ...(points && { points }),
    ...(near && { near }),
  });
}

/** What proves a truth, and why it does. */
const describeCertificate = (t: Truth): [string, string] =>
  t.direction
    ? ["separating direction", "A plane perpendicular to this direction has one solid on each side."]
    : t.point
      ? ["common point", "This point lies in both solids."]
      : t.points
        ? [
            "near points",
            "One is in the core of a, one in the core of b, and their distance is at most the sum of both roundings.",
          ]
      : [
          "point near both",
          "No rational common point is known. This point is within 2^-200 of the size of both, and along the " +
            "direction no gap or overlap is wider than that.",
        ];

function Prover({ shown }: { shown: Case }) {
  const [kind, why] = describeCertificate(shown.truth);
  const given = useMemo(() => certificateOf(shown.truth), [shown]);
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
      <h3>
        Certificate: <span title={about(kind)}>{kind}</span>
      </h3>
      <p>{why}</p>
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
            Reset
          </button>
        )}
        <span class="soft">This page checks it in exact integers. Change a digit to see it fail.</span>
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

function formatAnswer(a: Answer): string {
  if (a.failed) return `failed: ${a.failed}${a.reason ? `, \u201c${a.reason}\u201d` : ""}`;
  if (a.declined !== undefined) return `declined${a.declined ? `: ${a.declined}` : ""}`;
  return [
    a.verdict ?? "no verdict",
    ...(a.distance === undefined ? [] : [`distance ${full(a.distance)}`]),
    ...(a.direction ? [`direction (${a.direction.map(full).join(", ")})`] : []),
    ...(a.point ? [`point (${a.point.map(formatCoordinate).join(", ")})`] : []),
  ].join(", ");
}

function wrongVerdict(a: Answer, truth: Truth) {
  if (a.failed) return true;
  const meets = truth.verdict === "intersecting" || truth.verdict === "touching";
  return (
    (a.verdict === "disjoint" && meets) ||
    ((a.verdict === "intersecting" || a.verdict === "touching") && truth.verdict === "disjoint")
  );
}

interface AnswerGroup {
  answer: Answer;
  who: { name: string; off: WrongDistance | null; wrong: boolean }[];
  isSelected: boolean; // of the method that is looked at
  wrong: boolean;
}

/** The answers, each once: that of `method` first, then the wrong ones, then what most say. `distances`: those outside
 *  their claim are wrong too. */
function groupAnswers(shown: Case, method: string, claims: Map<string, Claim>, distances: boolean): AnswerGroup[] {
  const same = groupBy(Object.entries(shown.answers), ([name, a]) => `${name === method} ${formatAnswer(a)}`);
  const all = [...same.values()].map((given): AnswerGroup => {
    const answer = given[0]![1];
    const who = given.map(([name]) => {
      const off = distances ? wrongDistance(shown, answer, claims.get(name)) : null;
      const outside = off !== null && (off.claims === null ? off.error > 0 : off.claims > 1);
      return { name, off, wrong: outside || wrongVerdict(answer, shown.truth) };
    });
    return { answer, who, isSelected: given.some(([name]) => name === method), wrong: who.some((w) => w.wrong) };
  });
  return all.sort(
    (x, y) =>
      Number(y.isSelected) - Number(x.isSelected) ||
      Number(y.wrong) - Number(x.wrong) ||
      y.who.length - x.who.length,
  );
}

function Answers({
  shown,
  method,
  report,
  distances,
}: {
  shown: Case;
  method: string;
  report: FullReport;
  distances: boolean;
}) {
  const claims = new Map(report.methods.map((m) => [m.name, m.claim]));
  const said = groupAnswers(shown, method, claims, distances);
  if (said.length === 0) return null;
  return (
    <section>
      <h3>The answer of each method</h3>
      <div class="scroll">
        <table class="plain answers">
          <Heads of={distances ? ["answer", "n:wrong by", "from"] : ["answer", "from"]} />
          <tbody>
            {said.map(({ answer, who, isSelected, wrong }, row) => (
              <tr key={row} class={isSelected ? "its" : ""}>
                <td class={`wrap ${wrong ? "bad" : ""}`}>{safe(formatAnswer(answer))}</td>
                {distances && <td class="n">{who[0]!.off ? short(who[0]!.off.error) : "\u2013"}</td>}
                <td class="wrap">
                  {who.map(({ name, off, wrong }, i) => (
                    <>
                      {i > 0 && ", "}
                      <span
                        class={`${wrong ? "bad" : ""} ${name === method ? "strong" : ""}`}
                        title={off?.claims ? `${short(off.claims)} times its claim` : undefined}>
                        {safe(name)}
                      </span>
                    </>
                  ))}
                </td>
              </tr>
            ))}
          </tbody>
        </table>
      </div>
    </section>
  );
}

const allowedLabels: Record<Allowed["by"], string> = {
  claim: "its claim",
  size: "1e\u221213 of the size, which is more than its claim: the coordinates of such solids are not finer",
  distance: "2^\u221250 of the distance or the size, which is more than its claim: doubles of that size are not finer",
};

/** A wrong distance beside the proved one. */
function Wrong({
  of: { said, proved, error, relative, allowed, claims, size },
  claim,
}: {
  of: WrongDistance;
  claim?: Claim;
}) {
  return (
    <section class="wrong-distance">
      <h3>The distance</h3>
      <dl class="facts long">
        <Fact label="proved distance">
          {digits17(proved[0])} to {digits17(proved[1])}
        </Fact>
        <Fact label="answer" kind="bad">
          {digits17(said)}
        </Fact>
      </dl>
      <dl class="facts">
        <Fact label="error">{Number.isFinite(error) ? short(error, 4) : "above 1.8e308"}</Fact>
        <Fact label="error over size">
          {short(relative, 4)} <span class="soft">of {short(size, 4)}</span>
        </Fact>
        <Fact label="error over claim" kind={claims !== null && claims > 1 ? "bad" : ""}>
          {claims === null ? "\u2013" : `${short(claims, 4)} times`}
        </Fact>
        {allowed && (
          <Fact label="allowed">
            {short(allowed.length, 4)} <span class="soft">{allowedLabels[allowed.by]}</span>
          </Fact>
        )}
      </dl>
      {claim && (
        <p class="soft">
          Its claim: {formatClaim(claim)}
          <span title={about(claimOrigin(claim))}>, {claimOrigin(claim)}</span>.
        </p>
      )}
    </section>
  );
}

/** Breaks between its numbers, not in them. */
const Vector = ({ of }: { of: readonly number[] }) => (
  <>
    {of.map((x, i) => (
      <>
        {i > 0 && " "}
        <span class="whole">
          {i === 0 && "("}
          {full(x)}
          {i < of.length - 1 ? "," : ")"}
        </span>
      </>
    ))}
  </>
);

function Solids({ shown }: { shown: Case }) {
  const { a, b } = shown.pair,
    rounded = a.rounding || b.rounding;
  return (
    <div class="scroll">
      <table class="plain solids">
        <Heads of={["", "centre", "axis", "n:radius", "n:height", ...(rounded ? ["n:rounding"] : [])]} />
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
              <td class="wrap num">
                <Vector of={c.center} />
              </td>
              <td class="wrap num">
                <Vector of={c.axis} />
              </td>
              <td class="n">{full(c.radius)}</td>
              <td class="n">{full(c.height)}</td>
              {rounded && <td class="n">{full(c.rounding ?? 0)}</td>}
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}

const stageLabels: Record<string, string> = {
  filter: "double intervals",
  wide: "multiple precision",
  exact: "rationals",
};

/** `method`: the one that is wrong; `kind`: how; `story`: what is known of its cause, beside the picture. */
function CaseView({
  shown,
  method,
  kind,
  report,
  story,
}: {
  shown: Case;
  method: string;
  kind: string;
  report: FullReport;
  story?: ComponentChildren;
}) {
  const { truth } = shown,
    distances = kind === "distance_outside",
    claim = report.methods.find((m) => m.name === method)?.claim,
    off = distances ? wrongDistance(shown, shown.answers[method], claim) : null,
    stage = truth.stage && (stageLabels[truth.stage] ?? safe(truth.stage));
  const isProved = Boolean(truth.direction || truth.point || truth.points || truth.near);
  const proof = isProved ? <Prover shown={shown} /> : <p class="warn">No truth is proved for this pair.</p>;
  const facts = (
    <dl class="facts">
      <Fact label="truth">
        <span title={about(truth.verdict)}>{truth.verdict}</span>
        {isProved && <span class="soft"> proved</span>}
      </Fact>
      <Fact label="signed distance">{range(truth.distance)}</Fact>
      <Fact label="margin">{range(shown.margin)}</Fact>
      {stage && (
        <Fact label="settled in">
          <span title={about(stage)}>{stage}</span>
        </Fact>
      )}
    </dl>
  );
  const wrong = off && <Wrong of={off} {...(claim ? { claim } : {})} />,
    answers = <Answers shown={shown} method={method} report={report} distances={distances} />;
  return (
    <>
      <div class="case">
        <div class="left">
          <PairView shown={shown} />
          {story && facts}
          <Solids shown={shown} />
          {story && proof}
          <Copy label="Ask again" text={shown.replay} />
          <Copy label="The pair, a line for daylight check" text={JSON.stringify(shown.pair)} />
          {shown.note && <p class="soft">From: {safe(shown.note)}</p>}
        </div>
        <div class="right">
          {story ?? facts}
          {wrong}
          {!story && proof}
          {!story && answers}
        </div>
      </div>
      {story && answers}
    </>
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
            / <a href={bucketAddress(f.bucket)}>{safe(f.bucket)}</a>
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
            It claims to be {formatClaim(claim)} (
            <b title={about(claimOrigin(claim))}>{claimOrigin(claim)}: </b>
            {safe(claim.source)}).
          </>
        )}
        {f.reason && ` The method reports: ${safe(f.reason)}`}
      </p>
      <CaseView shown={f} method={f.method} kind={f.kind} report={report} />
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
  const shown = worst ? b.worst : b.simplest;
  const kept = b.findings.map((id) => finding.get(id)).filter((f) => f !== undefined);
  const claim = report.methods.find((m) => m.name === b.method)?.claim;
  const asked = b.nights.at(-1)?.asked;
  const severity = severityLabels[b.severity] ?? safe(b.severity);
  const story = (
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
          <Fact label="share of pairs like it">
            {percent(b.share.wrong, b.share.asked)} <span class="soft">of {grouped(b.share.asked)}</span>
          </Fact>
        )}
        <Fact label="feature">{safe(b.feature)}</Fact>
        <Fact label="what still matters">{safe(b.coordinate)}</Fact>
        <Fact label="since earlier runs">
          <span title={about(b.standing ?? "")}>{standingLabel(b.standing)}</span>
        </Fact>
        {b.chance !== null && <Fact label="chance">{short(b.chance)}</Fact>}
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
          {safe(b.method)} claims to be {formatClaim(claim)}
          <span title={about(claimOrigin(claim))}>, {claimOrigin(claim)}</span>.
        </p>
      )}
      <p>
        {safe(b.cause)}. <span class="soft">Wrong for this reason: {safe(b.methods.join(", "))}.</span>
      </p>
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
      {b.nights.length > 0 && <Nights nights={b.nights} />}
      <Handling report={report} b={b} />
    </>
  );
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
        kind={b.kind}
        report={report}
        story={story}
        key={worst ? "worst" : "simplest"}
      />
      {b.merged.length > 0 && (
        <details class="print">
          <summary>{plural(b.merged.length, "key")} of the same cause</summary>
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
      )}
    </>
  );
}
