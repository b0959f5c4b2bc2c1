// SPDX-License-Identifier: MIT
// How much there is to fear of a pair: what is proved of it, else what the draws showed.
import type { Proof, Study } from "./study.ts";

/** Worst first. */
export const risks = ["comes within", "open", "not known", "not seen within", "never within"] as const;
export type Risk = (typeof risks)[number];

const proofs = new WeakMap<Study, Map<string, Proof>>();

/** What --prove says of a pair; undefined where it was not asked. */
export function proofOf(study: Study, pair: number): Proof | undefined {
  let known = proofs.get(study);
  if (!known) {
    known = new Map((study.motions ?? []).map((proof) => [proof.bodies.join(), proof]));
    proofs.set(study, known);
  }
  return known.get(study.pairs[pair]!.bodies.join());
}

export function riskOf(study: Study, pair: number): Risk {
  const { known, within } = study.pairs[pair]!,
    verdict = proofOf(study, pair)?.verdict;
  if (verdict === "refuted" || verdict === "within" || (known && within > 0)) return "comes within";
  if (verdict === "open") return "open";
  if (verdict === "never") return "never within";
  return known ? "not seen within" : "not known";
}

/** The least gap seen, in the draws or by the proof. */
export const leastOf = (study: Study, pair: number) =>
  Math.min(study.pairs[pair]!.least_distance, proofOf(study, pair)?.least_seen ?? Infinity);
