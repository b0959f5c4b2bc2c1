// SPDX-License-Identifier: MIT
// Names of a run as people read them.
import type { Coordinate } from "../parts/data.ts";
import { full, short } from "../parts/words.ts";
import type { Claim, Method } from "./data.ts";

const ownNames = new Set(["intersect", "decide", "distance", "exact"]);
const libraries = new Map<string, string>();
/** Names the libraries as the run does. A chart alone has no run: there it is the name up to the first '-'. */
export function nameLibraries(methods: Method[]) {
  for (const m of methods) libraries.set(m.name, m.library);
}
export const library = (method: string) =>
  libraries.get(method) ?? (ownNames.has(method) ? "ours" : method.split("-", 1)[0]!);
/** Whether it is one of the texts that the project began with, and nobody's library. */
export const isText = (method: string) => method.startsWith("seed");

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
