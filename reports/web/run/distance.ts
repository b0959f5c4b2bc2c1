// SPDX-License-Identifier: MIT
// How wrong a distance is, as the judge counts it.
import type { Answer, Pair } from "../parts/data.ts";
import type { Case, Claim } from "./data.ts";

/** As the judge has them: what of the size is allowed to every claim of a length, and of the distance to everybody. */
const claimFloor = 1e-13,
  rounding = 2 ** -50;

const sizeOf = ({ a, b }: Pair) =>
  a.radius + a.height + b.radius + b.height + ((a.rounding ?? 0) + (b.rounding ?? 0));

/** What a claim allows a distance to be off by, and what sets that: the claim itself, or what rounding costs. */
export interface Allowed {
  length: number;
  by: "claim" | "size" | "distance";
}
function allowedBy({ relative, absolute }: Claim, size: number, said: number): Allowed {
  const floor = absolute > 0 && relative < claimFloor ? claimFloor * size : 0;
  const claimed = Math.max(relative * size, floor) + absolute,
    rounded = Math.max(Math.abs(said), size) * rounding;
  if (rounded > claimed) return { length: rounded, by: "distance" };
  return { length: claimed, by: floor > absolute ? "size" : "claim" };
}

export interface WrongDistance {
  said: number;
  proved: [number, number];
  size: number;
  error: number; // at least
  relative: number;
  allowed: Allowed | null; // where the claim is known
  claims: number | null; // the error as a multiple of what is allowed
}

/** null where there is no distance to be wrong. */
export function wrongDistance(
  { pair, truth }: Pick<Case, "pair" | "truth">,
  answer: Answer | undefined,
  claim: Claim | undefined,
): WrongDistance | null {
  const said = answer?.distance;
  const proved = truth.verdict === "touching" ? ([0, 0] as [number, number]) : truth.distance;
  if (typeof said !== "number" || !proved) return null;
  const size = sizeOf(pair),
    error = Math.max(0, proved[0] - said, said - proved[1]),
    allowed = claim ? allowedBy(claim, size, said) : null;
  return {
    said,
    proved,
    size,
    error,
    relative: error / size,
    allowed,
    claims: allowed && error / allowed.length,
  };
}
