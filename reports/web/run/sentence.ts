// SPDX-License-Identifier: MIT
// A cause in one plain sentence.
import { short } from "../parts/words.ts";
import type { Cause } from "./data.ts";
import { kindLabel, library } from "./words.ts";

/** What a sentence needs of a cause. */
type Told = Pick<Cause, "method" | "methods_of_kind" | "kind" | "margin" | "worst">;

/** Who is wrong: a method, a library with several of its methods, or several libraries. No method stands for those of
 *  other libraries: the amount may be of any. */
function whoOf({ method, methods_of_kind: methods }: Told): [string, boolean] {
  if (methods.length < 2) return [methods[0] ?? method, false];
  const libraries = new Set(methods.map(library)).size;
  if (libraries === 1) return [`${library(methods[0]!)} (${methods.length} methods)`, false];
  return [`${methods.length} methods of ${libraries} libraries`, true];
}

/** The largest margin that is proved of a finding of the cause, and of its kind. */
const largestOf = ({ margin }: Told) => margin?.[1] ?? 0;

export function sentenceOf(b: Told): string {
  const [who, many] = whoOf(b),
    s = many ? "" : "s",
    { a, b: other } = b.worst.pair,
    solids = a.rounding || other.rounding ? "solids" : "cylinders",
    largest = largestOf(b),
    amount = Number.isFinite(largest) ? `up to about ${short(largest, 2)} of ` : "more than 1e308 times ";
  switch (b.kind) {
    case "wrong_intersecting":
      return `${who} report${s} ${solids} as intersecting that are ${amount}their size apart`;
    case "wrong_disjoint":
      return largest === 0
        ? `${who} report${s} ${solids} as disjoint that touch`
        : `${who} report${s} ${solids} as disjoint that overlap by ${amount}their size`;
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
