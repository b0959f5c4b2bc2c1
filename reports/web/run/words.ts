// SPDX-License-Identifier: MIT
// Names of a run as people read them.
import type { Coordinate } from "../parts/data.ts";
import { full, short } from "../parts/words.ts";
import type { Claim } from "./data.ts";

const ownNames = new Set(["intersect", "decide", "distance", "exact"]);
/** Ours are one library; any other is what stands before the first '-'. */
export const library = (method: string) => (ownNames.has(method) ? "ours" : method.split("-", 1)[0]!);

export const kindLabel = (kind: string) => kind.replaceAll("_", " ");
export const severityLabels: Record<string, string> = {
  contract: "beyond its claim",
  resolution: "within its claim",
  unresolved: "truth undecided",
};

export const standingLabel = (standing: string | null) => standing ?? "\u2013";

export const claimOrigin = ({ stated }: Claim) => (stated ? "stated" : "assumed by us");

export function formatClaim(claim: Claim): string {
  const parts = [];
  if (claim.relative !== 0) parts.push(`${short(claim.relative)} of the size`);
  if (claim.absolute !== 0) parts.push(`a length of ${short(claim.absolute)}`);
  return parts.length === 0 ? "always right" : `right above a margin of ${parts.join(" plus ")}`;
}

export function formatCoordinate(x: Coordinate): string {
  if (typeof x === "number") return full(x);
  if (typeof x === "string") return x;
  return x.map((term, i) => (i === 0 ? full(term) : term < 0 ? `\u2212 ${full(-term)}` : `+ ${full(term)}`)).join(" ");
}
