// SPDX-License-Identifier: MIT
// Names of a run as people read them, and a cause in one plain sentence.
import type { Coordinate, Pair } from "../parts/data.ts";
import { full, short } from "../parts/words.ts";
import type { Cause, Claim, Finding } from "./data.ts";

/** Whether it is a publication that the project began with, and not a library. */
export const isText = (library: string) => library.startsWith("seed");

export const kindLabel = (kind: string) => kind.replaceAll("_", " ");
export const severityLabels: Record<string, string> = {
  contract: "beyond its claim",
  resolution: "within its claim",
  unresolved: "truth undecided",
};

export const claimOrigin = ({ stated }: Claim) => (stated ? "stated" : "assumed by us");

export function formatClaim(claim: Claim): string {
  const parts = [];
  if (claim.relative !== 0) parts.push(`${short(claim.relative)} of the size`);
  if (claim.absolute !== 0) parts.push(`a length of ${short(claim.absolute)}`);
  return parts.length === 0 ? "always right" : `always right if the gap or overlap exceeds ${parts.join(" plus ")}`;
}

export function formatCoordinate(x: Coordinate): string {
  if (typeof x === "number") return full(x);
  if (typeof x === "string") return x;
  return x.map((term, i) => (i === 0 ? full(term) : term < 0 ? `\u2212 ${full(-term)}` : `+ ${full(term)}`)).join(" ");
}

const areCylinders = ({ a, b }: Pair) => ![a, b].some((s) => "shape" in s || s.rounding);

/** Whether it is new, but no earlier run tested its method on its families. It may then be old. */
export const isOfNewFamilies = (b: Cause) => b.status === "new" && b.asked_before === false;

/** The subject of the sentence: a method, a library with several of its methods, or several libraries. The amount may
 *  come from any of them. */
function whoOf({ method, methods_of_kind: methods, libraries_of_kind: libraries }: Told): [string, boolean] {
  if (methods.length < 2) return [methods[0] ?? method, false];
  if (libraries.length === 1) return [`${libraries[0]} (${methods.length} methods)`, false];
  return [`${methods.length} methods of ${libraries.length} libraries`, true];
}

/** A finding as if it were a cause of its own. */
export const sentenceOfFinding = (f: Finding) =>
  sentenceOf(
    { ...f, methods: [f.method], methods_of_kind: [f.method], libraries_of_kind: [f.library], worst: f },
    "about",
  );

type Told = Pick<Cause, "method" | "methods" | "methods_of_kind" | "libraries_of_kind" | "kind" | "margin" | "worst">;

export function sentenceOf(b: Told, hedge = "up to about"): string {
  const [who, many] = whoOf(b),
    s = many ? "" : "s",
    solids = areCylinders(b.worst.pair) ? "cylinders" : "solids",
    largest = b.margin?.[1] ?? 0,
    amount = Number.isFinite(largest) ? `${hedge} ${short(largest, 2)} of` : "more than 1e308 times",
    said = (verdict: string) => `${who} report${s} \u201c${verdict}\u201d, but the ${solids}`;
  switch (b.kind) {
    case "wrong_intersecting":
      return `${said("intersecting")} are ${amount} their size apart`;
    case "wrong_disjoint":
      return `${said("disjoint")} ${largest === 0 ? "touch" : `overlap by ${amount} their size`}`;
    case "distance_outside":
      return `${who} return${s} a distance that is wrong by ${amount} the size`;
    case "bad_witness":
      return `${who} offer${s} a witness that does not prove the answer`;
    case "crash":
      return `${who} crash${many ? "" : "es"}`;
    case "hang":
      return `${who} do${many ? "" : "es"} not return`;
    default:
      return `${who}: ${kindLabel(b.kind)}`;
  }
}
