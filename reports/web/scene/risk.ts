// SPDX-License-Identifier: MIT
// How much there is to fear of a pair: what is proved of it, else what the draws showed.
import type { Proof, Study } from "./study.ts";

/** Worst first. */
export const risks = ["comes within", "open", "not known", "not seen within", "never within"] as const;
export type Risk = (typeof risks)[number];

const proofs = new WeakMap<Study, Map<string, Proof>>();

/** What --prove says of a pair; undefined where it was not asked. */
export function proof_of(study: Study, pair: number): Proof | undefined {
  let known = proofs.get(study);
  if (!known) {
    known = new Map((study.motions ?? []).map((proof) => [proof.bodies.join(), proof]));
    proofs.set(study, known);
  }
  return known.get(study.pairs[pair]!.bodies.join());
}

export function risk_of(study: Study, pair: number): Risk {
  const { known, within } = study.pairs[pair]!,
    verdict = proof_of(study, pair)?.verdict;
  if (verdict === "refuted" || verdict === "within" || (known && within > 0)) return "comes within";
  if (verdict === "open") return "open";
  if (verdict === "never") return "never within";
  return known ? "not seen within" : "not known";
}

/** The least gap seen, in the draws or by the proof. */
export const least_of = (study: Study, pair: number) =>
  Math.min(study.pairs[pair]!.least_distance, proof_of(study, pair)?.least_seen ?? Infinity);
