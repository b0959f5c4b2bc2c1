// SPDX-License-Identifier: MIT
// Which findings and causes are shown: a text, and one value or all of each facet. The address keeps them.
import type { Pair } from "../parts/data.ts";
import { inOrder } from "../parts/words.ts";
import type { Cause, Finding } from "./data.ts";
import { standingOf, type FullReport } from "./report.ts";
import { sentenceOf } from "./sentence.ts";
import { kindLabel, library, severityLabels } from "./words.ts";

export const facets = ["severity", "library", "family", "standing"] as const;
export type Facet = (typeof facets)[number];
/** "" is all. */
export type Filter = Record<Facet | "text", string>;

/** What a filter looks at. */
interface Subject {
  facet: Record<Facet, readonly string[]>;
  text: string; // as it is displayed, in small letters
}
export interface Row extends Subject {
  f: Finding;
}
export interface CauseRow extends Subject {
  b: Cause;
}

/** Of a size that scenes have, and near: shown before what is at the ends of the doubles. */
export function isOrdinary({ a, b }: Pair) {
  const size = a.radius + a.height + (a.rounding ?? 0) + b.radius + b.height + (b.rounding ?? 0);
  return size >= 1e-3 && size <= 1e3 && Math.max(Math.hypot(...a.center), Math.hypot(...b.center)) <= 100 * size;
}

const searchText = (parts: (string | null | undefined)[]) =>
  parts
    .filter((part) => part !== null && part !== undefined)
    .join(" ")
    .toLowerCase()
    .replaceAll("_", " ");

const severityRank: Record<string, number> = { contract: 0, resolution: 1, unresolved: 2 };
const rankOf = (severity: string) => severityRank[severity] ?? 3;
const standingRank: Record<string, number> = { new: 0, back: 1, rare: 2, known: 3, gone: 4 };
const standingRankOf = (b: Cause) => standingRank[b.standing ?? "known"] ?? 3;

/** The new first, then beyond a claim, then of ordinary size, then the frequent. */
export function causesOf({ buckets }: FullReport): CauseRow[] {
  const rows = buckets.map((b): CauseRow => {
    const words = [b.key, b.cause, sentenceOf(b), ...b.labels, ...b.methods, ...b.families, b.suppressed?.reason];
    return {
      b,
      facet: {
        severity: [b.severity],
        library: b.methods.map(library),
        family: b.families,
        standing: b.standing ? [b.standing] : [],
      },
      text: searchText([...words, kindLabel(b.kind), severityLabels[b.severity], b.standing]),
    };
  });
  return inOrder(
    rows,
    ({ b: x }, { b: y }) =>
      standingRankOf(x) - standingRankOf(y) ||
      rankOf(x.severity) - rankOf(y.severity) ||
      Number(isOrdinary(y.simplest.pair)) - Number(isOrdinary(x.simplest.pair)) ||
      y.count - x.count,
  );
}

/** Beyond a claim first, then of ordinary size, then those wrong by more. */
export function rowsOf(report: FullReport): Row[] {
  const standing = standingOf(report);
  const rows = report.findings.map((f): Row => {
    const since = standing(f);
    const words = [`#${f.id}`, severityLabels[f.severity], f.kind, f.method, f.family, f.bucket, f.reason, f.note];
    return {
      f,
      facet: {
        severity: [f.severity],
        library: [library(f.method)],
        family: [f.family],
        standing: since ? [since] : [],
      },
      text: searchText([...words, since]),
    };
  });
  const margin = ({ f }: Row) => f.margin?.[0] ?? -1;
  return inOrder(
    rows,
    (x, y) =>
      rankOf(x.f.severity) - rankOf(y.f.severity) ||
      Number(isOrdinary(y.f.pair)) - Number(isOrdinary(x.f.pair)) ||
      margin(y) - margin(x),
  );
}

/** Each word of the text must occur; "wrong_disjoint" is one. */
export function filtered<S extends Subject>(all: S[], filter: Filter): S[] {
  const terms = searchText([filter.text]).split(/\s+/);
  return all.filter(
    ({ facet, text }) =>
      facets.every((f) => filter[f] === "" || facet[f].includes(filter[f])) && terms.every((t) => text.includes(t)),
  );
}

/** The values of a facet that occur. */
export const valuesOf = (all: Subject[], facet: Facet): string[] =>
  [...new Set(all.flatMap((subject) => subject.facet[facet]))].sort();

const keys = [...facets, "text"] as const;
export const filterOf = (query: URLSearchParams) =>
  Object.fromEntries(keys.map((key) => [key, query.get(key) ?? ""])) as Filter;
export const queryOf = (filter: Filter) =>
  new URLSearchParams(keys.filter((key) => filter[key] !== "").map((key) => [key, filter[key]])).toString();
