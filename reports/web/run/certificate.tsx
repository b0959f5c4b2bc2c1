// SPDX-License-Identifier: MIT
// The certificate of a truth, which the reader may edit and have proved again.
import { useMemo, useState } from "preact/hooks";
import type { Truth } from "../parts/data.ts";
import { prove, type Proof } from "../parts/prove.ts";
import type { Case } from "./data.ts";
import { about } from "./glossary.ts";

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

export function Prover({ shown }: { shown: Case }) {
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
