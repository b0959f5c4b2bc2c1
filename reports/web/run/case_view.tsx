// SPDX-License-Identifier: MIT
// A pair with its picture, its truth, the answers and the certificate, which the reader may edit and have proved again.
import { group, sort } from "d3-array";
import type { ComponentChildren } from "preact";
import { useState } from "preact/hooks";
import type { Answer, Truth } from "../parts/data.ts";
import { Copy } from "../parts/elements.tsx";
import { prove, type Proof } from "../parts/prove.ts";
import { full, range, safe } from "../parts/words.ts";
import type { Case } from "./data.ts";
import { Fact, Table } from "./elements.tsx";
import { about } from "./glossary.ts";
import { PairView } from "./pair_view.tsx";
import { formatCoordinate } from "./words.ts";

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

const isMeeting = (verdict: string | undefined) => verdict === "intersecting" || verdict === "touching";
const isWrong = (a: Answer, truth: Truth) =>
  a.failed !== undefined ||
  (a.verdict === "disjoint" && isMeeting(truth.verdict)) ||
  (isMeeting(a.verdict) && truth.verdict === "disjoint");

/** The answers, each once: that of `method` first, then the wrong ones, then the most frequent. */
function Answers({ shown: { answers, truth }, method }: { shown: Case; method: string }) {
  const same = group(Object.entries(answers), ([name, a]) => `${name === method} ${formatAnswer(a)}`);
  const rows = [...same.values()].map((given) => {
    const who = given.map(([name]) => name);
    return { answer: given[0]![1], who, isIts: who.includes(method), wrong: isWrong(given[0]![1], truth) };
  });
  const ranked = sort(
    rows,
    (x, y) => Number(y.isIts) - Number(x.isIts) || Number(y.wrong) - Number(x.wrong) || y.who.length - x.who.length,
  );
  if (rows.length === 0) return null;
  return (
    <section>
      <h3>The answer of each method</h3>
      <Table kind="answers" of={["answer", "from"]}>
        {ranked.map(({ answer, who, isIts, wrong }, row) => (
          <tr key={row} class={isIts ? "its" : ""}>
            <td class={`wrap ${wrong ? "bad" : ""}`}>{safe(formatAnswer(answer))}</td>
            <td class={`wrap ${wrong ? "bad" : ""}`}>{safe(who.join(", "))}</td>
          </tr>
        ))}
      </Table>
    </section>
  );
}

/** The kind of certificate that proves a truth, and why it does. */
const describeCertificate = (t: Truth): [string, string] =>
  t.direction
    ? ["separating direction", "A plane perpendicular to this direction has one solid on each side."]
    : t.point
      ? ["common point", "This point lies in both solids."]
      : t.points
        ? [
            "near points",
            "One point lies in the core of a, the other in the core of b. Their distance is at most the sum of the " +
              "roundings.",
          ]
        : [
            "point near both",
            "No rational common point is known. This point is at most 2^-200 times the size away from either solid. " +
              "Along the direction, any gap or overlap is at most as wide.",
          ];

function Prover({ shown }: { shown: Case }) {
  const [kind, why] = describeCertificate(shown.truth);
  const { distance: _, stage: __, ...certificate } = shown.truth,
    given = JSON.stringify(certificate);
  const [{ text, proof }, set] = useState<{ text: string; proof: Proof | null }>({ text: given, proof: null });
  const check = () => {
    try {
      set({ text, proof: prove(shown.pair, JSON.parse(text) as Truth) });
    } catch {
      set({ text, proof: { holds: false, text: "Refuted: this is not JSON.", steps: [] } });
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
        onInput={(event) => set({ text: event.currentTarget.value, proof: null })}
      />
      <p class="tools">
        <button type="button" class="prove" onClick={check}>
          Prove again
        </button>
        {text !== given && (
          <button type="button" onClick={() => set({ text: given, proof: null })}>
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
          <ul>
            {proof.steps.map((s) => (
              <li key={s}>{s}</li>
            ))}
          </ul>
        </div>
      )}
    </section>
  );
}

/** `method` is wrong. `story` has the facts of its cause, and stands beside the picture. */
export function CaseView({ shown, method, story }: { shown: Case; method: string; story?: ComponentChildren }) {
  const { truth } = shown;
  const isProved = Boolean(truth.direction || truth.point || truth.points || truth.near);
  const facts = (
    <dl class="facts">
      <Fact label="truth">
        <span title={about(truth.verdict)}>{truth.verdict}</span>
        {isProved && <span class="soft"> proved</span>}
      </Fact>
      <Fact label="signed distance">{range(truth.distance)}</Fact>
      <Fact label="margin">{range(shown.margin)}</Fact>
    </dl>
  );
  return (
    <>
      <div class="case">
        <div>
          <PairView shown={shown} />
          <Copy label="The pair, a line for daylight check" text={JSON.stringify(shown.pair)} />
          <Copy label="Ask again" text={shown.replay} />
          {shown.note && <p class="soft">From: {safe(shown.note)}</p>}
        </div>
        <div>
          {facts}
          {story}
          {isProved ? <Prover shown={shown} /> : <p class="warn">No truth is proved for this pair.</p>}
        </div>
      </div>
      <Answers shown={shown} method={method} />
    </>
  );
}
