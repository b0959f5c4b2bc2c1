// SPDX-License-Identifier: MIT
// Which findings and causes are shown, and in which order: what a link says of it and what the address keeps.
import type { Pair } from "../parts/data.ts";
import { groupBy, inOrder } from "../parts/words.ts";
import type { Cause, Finding, Standing } from "./data.ts";
import { standings, type FullReport } from "./report.ts";
import { sentenceOf } from "./sentence.ts";
import { kindLabel, library, severityLabels } from "./words.ts";

export const facets = ["severity", "kind", "library", "family", "standing"] as const;
export type Facet = (typeof facets)[number];
/** Values chosen, by facet; none of a facet is all of them. `method` comes from links alone. */
export interface Filter {
  chosen: Record<Facet, ReadonlySet<string>>;
  method: string | null;
  text: string;
}
export const noFilter: Filter = {
  chosen: { severity: new Set(), kind: new Set(), library: new Set(), family: new Set(), standing: new Set() },
  method: null,
  text: "",
};

/** What a filter looks at. */
interface Subject {
  method: string;
  facet: Record<Facet, string>;
  text: string; // as it is displayed, in small letters
}
export interface Row extends Subject {
  f: Finding;
  standing: Standing | null;
  margin: number;
  ordinary: boolean;
}
/** A cause is shown with its findings; a cause without findings here is shown with its own words. */
export interface CauseEntry {
  b: Cause;
  alone: Subject[] | null;
}

/** Of a size that scenes have, and near: shown before what is at the ends of the doubles. */
export function isOrdinary({ a, b }: Pair) {
  const size = a.radius + a.height + (a.rounding ?? 0) + b.radius + b.height + (b.rounding ?? 0);
  return size >= 1e-3 && size <= 1e3 && Math.max(Math.hypot(...a.center), Math.hypot(...b.center)) <= 100 * size;
}

const searchText = (parts: (string | number | null | undefined)[]) =>
  parts
    .filter((part) => part !== null && part !== undefined)
    .join(" ")
    .toLowerCase()
    .replaceAll("_", " ");
/** Each of them must occur; "wrong_disjoint" is one. */
const termsOf = (text: string) =>
  text
    .split(/\s+/)
    .map((term) => searchText([term]))
    .filter((term) => term !== "");

const causeText = (b: Cause) =>
  searchText([
    b.key, b.cause, sentenceOf(b), ...b.labels, ...b.methods, b.suppressed?.reason,
  ]);

export function rowsOf(report: FullReport): Row[] {
  const standingOf = standings(report);
  const causeTexts = new Map(report.buckets.map((b) => [b.key, causeText(b)]));
  return report.findings.map((f) => {
    const standing = standingOf(f);
    const words = [`#${f.id}`, severityLabels[f.severity], f.kind, f.method, f.family, f.bucket, f.reason, f.note];
    return {
      f,
      standing,
      method: f.method,
      margin: f.margin?.[0] ?? -1,
      ordinary: isOrdinary(f.pair),
      facet: {
        severity: f.severity,
        kind: f.kind,
        library: library(f.method),
        family: f.family,
        standing: standing ?? "not compared",
      },
      text: searchText([...words, standing, f.bucket === null ? "" : causeTexts.get(f.bucket)]),
    };
  });
}

export function causesOf(report: FullReport): CauseEntry[] {
  const withFindings = new Set(report.findings.map((f) => f.bucket));
  const alone = (b: Cause): Subject[] => {
    const standing = b.standing ?? "not compared";
    const text = searchText([causeText(b), b.method, kindLabel(b.kind), severityLabels[b.severity], standing]);
    const families = b.families.length > 0 ? b.families : [""];
    return b.methods.flatMap((method) =>
      families.map((family) => ({
        method,
        facet: { severity: b.severity, kind: b.kind, library: library(method), family, standing },
        text: `${text} ${searchText([family])}`,
      })),
    );
  };
  return report.buckets.map((b) => ({ b, alone: withFindings.has(b.key) ? null : alone(b) }));
}

function passes(row: Subject, filter: Filter, terms: string[], but?: Facet) {
  for (const facet of facets) {
    if (facet !== but && filter.chosen[facet].size > 0 && !filter.chosen[facet].has(row.facet[facet])) return false;
  }
  return (filter.method === null || row.method === filter.method) && terms.every((term) => row.text.includes(term));
}

export function filtered(rows: Row[], filter: Filter) {
  const terms = termsOf(filter.text);
  return rows.filter((row) => passes(row, filter, terms));
}

/** The causes of the rows that a filter left, and those without findings that it lets pass. */
export function filteredCauses(causes: CauseEntry[], shown: Row[], filter: Filter) {
  const terms = termsOf(filter.text),
    keys = new Set(shown.map((row) => row.f.bucket));
  return causes.filter(({ b, alone }) =>
    alone ? alone.some((subject) => passes(subject, filter, terms)) : keys.has(b.key),
  );
}

type Counts = Record<Facet, Map<string, number>>;
const byFacet = (): Counts => Object.fromEntries(facets.map((facet) => [facet, new Map<string, number>()])) as Counts;

/** How many rows each filter would give beside what the other facets leave; those chosen stay. */
export function chipCounts(rows: Row[], filter: Filter): Counts {
  const counts = byFacet(),
    terms = termsOf(filter.text);
  for (const facet of facets) {
    for (const row of rows) {
      const value = row.facet[facet],
        had = counts[facet].get(value) ?? 0;
      counts[facet].set(value, had + (passes(row, filter, terms, facet) ? 1 : 0));
    }
  }
  return counts;
}

/** The same of causes that have no findings here. */
export function loneCounts(causes: CauseEntry[], filter: Filter): Counts {
  const counts = byFacet(),
    terms = termsOf(filter.text);
  for (const facet of facets) {
    for (const { alone } of causes) {
      for (const [value, subjects] of groupBy(alone ?? [], (subject) => subject.facet[facet])) {
        const passing = subjects.some((subject) => passes(subject, filter, terms, facet));
        counts[facet].set(value, (counts[facet].get(value) ?? 0) + (passing ? 1 : 0));
      }
    }
  }
  return counts;
}

interface OrderOf<C extends string> {
  column: C;
  down: boolean;
}
export const columns = ["id", "severity", "kind", "method", "family", "margin", "bucket", "standing"] as const;
export type Column = (typeof columns)[number];
export type Order = OrderOf<Column>;
export const causeColumns = ["key", "margin", "count", "standing", "seen"] as const;
export type CauseColumn = (typeof causeColumns)[number];
export type CauseOrder = OrderOf<CauseColumn>;

const severityRank: Record<string, number> = { contract: 0, resolution: 1, unresolved: 2 };
const rankOf = (severity: string) => severityRank[severity] ?? 3;
const standingRank: Record<string, number> = { new: 0, back: 1, known: 2, rare: 3, gone: 4 };
const standingOf = (b: Cause) => standingRank[b.standing ?? "known"] ?? 2;
const byName = (a: string, b: string) => (a < b ? -1 : a > b ? 1 : 0);

function compare(x: Row, y: Row, column: Column): number {
  switch (column) {
    case "id":
      return x.f.id - y.f.id;
    case "margin":
      return x.margin - y.margin;
    case "severity":
      return rankOf(x.f.severity) - rankOf(y.f.severity);
    case "standing":
      return byName(x.facet.standing, y.facet.standing);
    default:
      return byName(x.f[column] ?? "", y.f[column] ?? "");
  }
}

/** Equal rows keep their order. */
export const sorted = (rows: Row[], order: Order) =>
  inOrder(rows, (x, y) => (order.down ? -1 : 1) * compare(x, y, order.column));

/** The order in which equal rows are shown: the ordinary first, then those wrong by more. */
export const worstFirst = (rows: Row[]) =>
  inOrder(rows, (x, y) => Number(y.ordinary) - Number(x.ordinary) || y.margin - x.margin);

function compareCauses(x: Cause, y: Cause, column: CauseColumn): number {
  switch (column) {
    case "key":
      return byName(x.key, y.key);
    case "count":
      return x.count - y.count;
    case "margin":
      return (x.margin?.[1] ?? -1) - (y.margin?.[1] ?? -1);
    case "seen":
      return byName(x.first_seen, y.first_seen);
    case "standing":
      return standingOf(x) - standingOf(y);
  }
}

/** Equal ones: the new first, then beyond a claim, then of ordinary size, then the frequent. */
export const sortedCauses = (causes: CauseEntry[], { column, down }: CauseOrder) =>
  inOrder(
    causes,
    ({ b: x }, { b: y }) =>
      (down ? -1 : 1) * compareCauses(x, y, column) ||
      standingOf(x) - standingOf(y) ||
      rankOf(x.severity) - rankOf(y.severity) ||
      Number(isOrdinary(y.simplest.pair)) - Number(isOrdinary(x.simplest.pair)) ||
      y.count - x.count,
  );

/** The filter that a link asks for. */
export function filterOf(query: URLSearchParams): Filter {
  const chosen = { ...noFilter.chosen };
  for (const facet of facets) {
    const values = query.getAll(facet);
    if (values.length > 0) chosen[facet] = new Set(values);
  }
  return { chosen, method: query.get("method"), text: query.get("text") ?? "" };
}

/** All that the address keeps. */
export interface View {
  filter: Filter;
  order: Order;
  causes: CauseOrder;
}
const firstOrder: Order = { column: "severity", down: false },
  firstCauses: CauseOrder = { column: "standing", down: false };

/** "-margin": by margin, downwards. */
function orderOf<C extends string>(text: string | null, all: readonly C[], otherwise: OrderOf<C>): OrderOf<C> {
  const column = all.find((c) => c === text?.replace(/^-/, ""));
  return column === undefined ? otherwise : { column, down: text!.startsWith("-") };
}

export const viewOf = (query: URLSearchParams): View => ({
  filter: filterOf(query),
  order: orderOf(query.get("sort"), columns, firstOrder),
  causes: orderOf(query.get("causes"), causeColumns, firstCauses),
});

export function queryOf({ filter, order, causes }: View): string {
  const told = (o: OrderOf<string>) => `${o.down ? "-" : ""}${o.column}`;
  const query = new URLSearchParams(facets.flatMap((facet) => [...filter.chosen[facet]].map((v) => [facet, v])));
  if (filter.method !== null) query.set("method", filter.method);
  if (filter.text !== "") query.set("text", filter.text);
  if (told(order) !== told(firstOrder)) query.set("sort", told(order));
  if (told(causes) !== told(firstCauses)) query.set("causes", told(causes));
  return query.toString();
}
