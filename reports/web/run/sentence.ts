// SPDX-License-Identifier: MIT
// A cause in one plain sentence.
import { plural, short } from "../parts/words.ts";
import type { Bucket } from "./data.ts";
import { kindLabel, library } from "./words.ts";

/** Who is wrong: a method, a library with several of its methods, or a method and others. */
function whoOf({ method, methods }: Bucket): [string, boolean] {
  if (methods.length < 2) return [methods[0] ?? method, false];
  const others = methods.filter((m) => library(m) !== library(method)).length;
  if (others === 0) return [`${library(method)} (${methods.length} methods)`, false];
  return [`${method} and ${plural(methods.length - 1, "other method")}`, true];
}

/** The largest margin that is proved of a finding of the cause. */
function largestOf({ kind, margin, worst }: Bucket) {
  const pair = kind === "distance_outside" ? 0 : (worst.margin?.[0] ?? 0);
  return Math.max(margin?.[1] ?? 0, pair);
}

export function sentenceOf(b: Bucket): string {
  const [who, many] = whoOf(b),
    s = many ? "" : "s",
    { a, b: other } = b.worst.pair,
    solids = a.rounding || other.rounding ? "solids" : "cylinders",
    largest = largestOf(b),
    amount = Number.isFinite(largest) ? `up to about ${short(largest, 2)} of ` : "more than all doubles times ";
  switch (b.kind) {
    case "wrong_intersecting":
      return `${who} report${s} two ${solids} as intersecting although they are ${amount}their size apart`;
    case "wrong_disjoint":
      return largest === 0
        ? `${who} report${s} two ${solids} as disjoint although they touch`
        : `${who} report${s} two ${solids} as disjoint although they overlap by ${amount}their size`;
    case "distance_outside":
      return `${who} return${s} a distance that is wrong by ${amount}the size`;
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
