// SPDX-License-Identifier: MIT
// How wrong a distance is, as the judge counts it.
import type { Answer, Case, Claim, Pair } from "./data.ts";

/** Of half a unit in the last place. */
const rounding = 2 ** -53;

export const size_of = ({ a, b }: Pair) => a.radius + a.height + b.radius + b.height + ((a.rounding ?? 0) + (b.rounding ?? 0));

/** What a claim allows a distance to be off by; never less than its last place. */
export const allowed_by = ({ relative, absolute }: Claim, size: number, said: number) =>
  Math.max(relative * size + absolute, Math.max(Math.abs(said), size) * rounding);

export interface WrongDistance {
  said: number;
  proved: [number, number];
  size: number;
  error: number; // at least
  relative: number;
  claims: number | null; // as a multiple of the claim, where that is known
}

/** null where there is no distance to be wrong. */
export function wrong_distance(
  { pair, truth }: Pick<Case, "pair" | "truth">,
  answer: Answer | undefined,
  claim: Claim | undefined,
): WrongDistance | null {
  const said = answer?.distance;
  const proved = truth.verdict === "touching" ? ([0, 0] as [number, number]) : truth.distance;
  if (typeof said !== "number" || !proved) return null;
  const size = size_of(pair),
    error = Math.max(0, proved[0] - said, said - proved[1]);
  return {
    said,
    proved,
    size,
    error,
    relative: error / size,
    claims: claim ? error / allowed_by(claim, size, said) : null,
  };
}
