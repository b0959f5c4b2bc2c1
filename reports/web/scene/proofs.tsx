// SPDX-License-Identifier: MIT
// What --prove says of pairs over all motions, and of the pairs that the SRDF exempts.
import { Section } from "../parts/elements.tsx";
import { percent } from "../parts/words.ts";
import { aboutScene } from "./glossary.ts";
import { formatLength, asSentence, unitOf, type Proof, type ProvedExemption, type Study } from "./study.ts";

export function formatProof(study: Study, proof: Proof): string {
  const unit = unitOf(study);
  switch (proof.verdict) {
    case "never":
      return `proved: always more than ${formatLength(proof.bound, unit)} apart`;
    case "refuted":
      return proof.least_seen < 0
        ? `refuted, overlap by ${formatLength(-proof.least_seen, unit)}`
        : `refuted, ${formatLength(proof.least_seen, unit)} apart`;
    case "within":
      return (
        `within the clearance: ${formatLength(proof.least_seen, unit)} apart` +
        (proof.bound > 0 ? `, and proved: always more than ${formatLength(proof.bound, unit)}` : "")
      );
    case "open":
      return `open: not proved for ${percent(proof.open_share, 1)} of the joints\u2019 space`;
  }
}

export const verdictClass = { refuted: "bad", within: "warn", open: "warn", never: "ok" } as const;

/** The same for a narrow column. */
export function formatProofShort(study: Study, proof: Proof): string {
  if (proof.verdict === "never") return `proved: more than ${formatLength(proof.bound, unitOf(study))}`;
  return proof.verdict === "open" ? `${percent(proof.open_share, 1)} of all motions open` : formatProof(study, proof);
}

/** Puts the sliders where a proof saw the two bodies nearest. */
export function ShowProof({ proof, show }: { proof: Proof; show: (proof: Proof) => void }) {
  if (Object.keys(proof.joints).length === 0) return null;
  return (
    <button type="button" onClick={() => show(proof)}>
      {["refuted", "within"].includes(proof.verdict) ? "Show where" : "Show the nearest"}
      <span class="sr"> {`${proof.a} \u2013 ${proof.b}`}</span>
    </button>
  );
}

const worst = (exemption: ProvedExemption) =>
  exemption.pairs.reduce<Proof | undefined>((p, q) => (p && p.least_seen <= q.least_seen ? p : q), undefined);

/** The worst first. */
const rank = { refuted: 0, open: 1, within: 2, never: 3 } as const;

export function Proofs({ study, show }: { study: Study; show: (proof: Proof) => void }) {
  if (!study.motions) return null;
  const exemptions = [...(study.exemptions ?? [])].sort((p, q) => rank[p.verdict] - rank[q.verdict]);
  return (
    <Section id="proofs" title="Over all motions" lead={asSentence(study.words.motions)}>
      {exemptions.length === 0 ? (
        <p class="soft">
          {study.srdf ? "The SRDF exempts no pair as never in contact." : "No SRDF was read, so no pair is exempted."}
        </p>
      ) : (
        <div class="scroll">
          <table class="plain exemptions">
            <caption>Pairs of links that the SRDF exempts with the reason {"\u201cNever\u201d"}</caption>
            <thead>
              <tr>
                {["link", "other link", "verdict", "what is known", "show"].map((head) => (
                  <th scope="col" title={aboutScene(head)} key={head}>
                    {head}
                  </th>
                ))}
              </tr>
            </thead>
            <tbody>
              {exemptions.map((exemption, i) => {
                const proof = worst(exemption);
                return (
                  <tr key={i}>
                    <td>{exemption.link1}</td>
                    <td>{exemption.link2}</td>
                    <td class={verdictClass[exemption.verdict]}>{exemption.verdict}</td>
                    <td class="wrap">
                      {[
                        ...(proof ? [formatProof(study, proof)] : []),
                        ...(exemption.not_looked_at ? ["a link has shapes that were not tested"] : []),
                      ].join("; ")}
                    </td>
                    <td>{proof && <ShowProof proof={proof} show={show} />}</td>
                  </tr>
                );
              })}
            </tbody>
          </table>
        </div>
      )}
    </Section>
  );
}
