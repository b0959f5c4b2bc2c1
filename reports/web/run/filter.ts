// SPDX-License-Identifier: MIT
// Which findings and causes are shown, and in which order: what a link says of it and what the address keeps.
import type { Pair } from "../parts/data.ts";
import { group_by, in_order } from "../parts/words.ts";
import type { Bucket, Finding, Standing } from "./data.ts";
import { standings, type FullReport } from "./report.ts";
import { kind_words, library, severity_words } from "./words.ts";

export const facets = ["severity", "kind", "library", "family", "standing"] as const;
export type Facet = (typeof facets)[number];
/** Chips pressed, by facet; no chip of a facet pressed is all of them. `method` comes from links alone. */
export interface Filter {
  chosen: Record<Facet, ReadonlySet<string>>;
  method: string | null;
  text: string;
}
export const no_filter: Filter = {
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
/** A cause is shown with its findings; one that has none here with what it says of itself. */
export interface Cause {
  b: Bucket;
  alone: Subject[] | null;
}

/** Of a size that scenes have, and near: shown before what is at the ends of the doubles. */
export function is_ordinary({ a, b }: Pair) {
  const size = a.radius + a.height + (a.rounding ?? 0) + b.radius + b.height + (b.rounding ?? 0);
  return size >= 1e-3 && size <= 1e3 && Math.max(Math.hypot(...a.center), Math.hypot(...b.center)) <= 100 * size;
}

const spoken = (parts: (string | number | null | undefined)[]) =>
  parts
    .filter((part) => part !== null && part !== undefined)
    .join(" ")
    .toLowerCase()
    .replaceAll("_", " ");
/** Each of them must occur; "wrong_disjoint" is one. */
const terms_of = (text: string) =>
  text
    .split(/\s+/)
    .map((term) => spoken([term]))
    .filter((term) => term !== "");

const cause_words = (b: Bucket) =>
  spoken([b.key, b.cause, ...b.labels, ...b.methods, b.note?.owner, b.note?.note, b.suppressed?.reason]);

export function rows_of(report: FullReport): Row[] {
  const standing_of = standings(report);
  const said_of = new Map(report.buckets.map((b) => [b.key, cause_words(b)]));
  return report.findings.map((f) => {
    const standing = standing_of(f);
    const words = [`#${f.id}`, severity_words[f.severity], f.kind, f.method, f.family, f.bucket, f.reason, f.note];
    return {
      f,
      standing,
      method: f.method,
      margin: f.margin?.[0] ?? -1,
      ordinary: is_ordinary(f.pair),
      facet: {
        severity: f.severity,
        kind: f.kind,
        library: library(f.method),
        family: f.family,
        standing: standing ?? "not compared",
      },
      text: spoken([...words, standing, f.bucket === null ? "" : said_of.get(f.bucket)]),
    };
  });
}

export function causes_of(report: FullReport): Cause[] {
  const with_findings = new Set(report.findings.map((f) => f.bucket));
  const alone = (b: Bucket): Subject[] => {
    const standing = b.standing ?? "not compared";
    const text = spoken([cause_words(b), b.method, kind_words(b.kind), severity_words[b.severity], standing]);
    const families = b.families.length > 0 ? b.families : [""];
    return b.methods.flatMap((method) =>
      families.map((family) => ({
        method,
        facet: { severity: b.severity, kind: b.kind, library: library(method), family, standing },
        text: `${text} ${spoken([family])}`,
      })),
    );
  };
  return report.buckets.map((b) => ({ b, alone: with_findings.has(b.key) ? null : alone(b) }));
}

function passes(row: Subject, filter: Filter, terms: string[], but?: Facet) {
  for (const facet of facets) {
    if (facet !== but && filter.chosen[facet].size > 0 && !filter.chosen[facet].has(row.facet[facet])) return false;
  }
  return (filter.method === null || row.method === filter.method) && terms.every((term) => row.text.includes(term));
}

export function filtered(rows: Row[], filter: Filter) {
  const terms = terms_of(filter.text);
  return rows.filter((row) => passes(row, filter, terms));
}

/** The causes of the rows that a filter left, and those without findings that it lets pass. */
export function filtered_causes(causes: Cause[], shown: Row[], filter: Filter) {
  const terms = terms_of(filter.text),
    keys = new Set(shown.map((row) => row.f.bucket));
  return causes.filter(({ b, alone }) =>
    alone ? alone.some((subject) => passes(subject, filter, terms)) : keys.has(b.key),
  );
}

type Counts = Record<Facet, Map<string, number>>;
const by_facet = (): Counts => Object.fromEntries(facets.map((facet) => [facet, new Map<string, number>()])) as Counts;

/** How many rows each chip would give beside what the other facets leave; chips that are pressed stay. */
export function chip_counts(rows: Row[], filter: Filter): Counts {
  const counts = by_facet(),
    terms = terms_of(filter.text);
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
export function lone_counts(causes: Cause[], filter: Filter): Counts {
  const counts = by_facet(),
    terms = terms_of(filter.text);
  for (const facet of facets) {
    for (const { alone } of causes) {
      for (const [value, subjects] of group_by(alone ?? [], (subject) => subject.facet[facet])) {
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
export const cause_columns = ["key", "methods", "severity", "count", "margin", "share", "standing", "seen"] as const;
export type CauseColumn = (typeof cause_columns)[number];
export type CauseOrder = OrderOf<CauseColumn>;

const severity_rank: Record<string, number> = { contract: 0, resolution: 1, unresolved: 2 };
const rank_of = (severity: string) => severity_rank[severity] ?? 3;
const standing_rank: Record<string, number> = { new: 0, back: 1, known: 2, rare: 3, gone: 4 };
const standing_of = (b: Bucket) => standing_rank[b.standing ?? "known"] ?? 2;
const by_name = (a: string, b: string) => (a < b ? -1 : a > b ? 1 : 0);

function compare(x: Row, y: Row, column: Column): number {
  switch (column) {
    case "id":
      return x.f.id - y.f.id;
    case "margin":
      return x.margin - y.margin;
    case "severity":
      return rank_of(x.f.severity) - rank_of(y.f.severity);
    case "standing":
      return by_name(x.facet.standing, y.facet.standing);
    default:
      return by_name(x.f[column] ?? "", y.f[column] ?? "");
  }
}

/** Equal rows keep their order. */
export const sorted = (rows: Row[], order: Order) =>
  in_order(rows, (x, y) => (order.down ? -1 : 1) * compare(x, y, order.column));

/** The order in which equal rows are shown: the ordinary first, then those wrong by more. */
export const worst_first = (rows: Row[]) =>
  in_order(rows, (x, y) => Number(y.ordinary) - Number(x.ordinary) || y.margin - x.margin);

const share_of = ({ share }: Bucket) => (share && share.asked > 0 ? share.wrong / share.asked : -1);

function compare_causes(x: Bucket, y: Bucket, column: CauseColumn): number {
  switch (column) {
    case "key":
      return by_name(x.key, y.key);
    case "methods":
      return by_name(x.methods.join(), y.methods.join());
    case "severity":
      return rank_of(x.severity) - rank_of(y.severity);
    case "count":
      return x.count - y.count;
    case "margin":
      return (x.margin?.[1] ?? -1) - (y.margin?.[1] ?? -1);
    case "share":
      return share_of(x) - share_of(y);
    case "seen":
      return by_name(x.first_seen, y.first_seen);
    case "standing":
      return standing_of(x) - standing_of(y);
  }
}

/** Equal ones: the new first, then beyond a claim, then of ordinary size, then the frequent. */
export const sorted_causes = (causes: Cause[], { column, down }: CauseOrder) =>
  in_order(
    causes,
    ({ b: x }, { b: y }) =>
      (down ? -1 : 1) * compare_causes(x, y, column) ||
      standing_of(x) - standing_of(y) ||
      rank_of(x.severity) - rank_of(y.severity) ||
      Number(is_ordinary(y.simplest.pair)) - Number(is_ordinary(x.simplest.pair)) ||
      y.count - x.count,
  );

/** The filter that a link asks for. */
export function filter_of(query: URLSearchParams): Filter {
  const chosen = { ...no_filter.chosen };
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
const first_order: Order = { column: "severity", down: false },
  first_causes: CauseOrder = { column: "standing", down: false };

/** "-margin": by margin, downwards. */
function order_of<C extends string>(text: string | null, all: readonly C[], otherwise: OrderOf<C>): OrderOf<C> {
  const column = all.find((c) => c === text?.replace(/^-/, ""));
  return column === undefined ? otherwise : { column, down: text!.startsWith("-") };
}

export const view_of = (query: URLSearchParams): View => ({
  filter: filter_of(query),
  order: order_of(query.get("sort"), columns, first_order),
  causes: order_of(query.get("causes"), cause_columns, first_causes),
});

export function query_of({ filter, order, causes }: View): string {
  const told = (o: OrderOf<string>) => `${o.down ? "-" : ""}${o.column}`;
  const query = new URLSearchParams(facets.flatMap((facet) => [...filter.chosen[facet]].map((v) => [facet, v])));
  if (filter.method !== null) query.set("method", filter.method);
  if (filter.text !== "") query.set("text", filter.text);
  if (told(order) !== told(first_order)) query.set("sort", told(order));
  if (told(causes) !== told(first_causes)) query.set("causes", told(causes));
  return query.toString();
}
