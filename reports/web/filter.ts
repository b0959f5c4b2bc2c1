// SPDX-License-Identifier: MIT
// Which findings are shown, and in which order.
import type { Finding, Standing } from "./data.ts";
import type { FullReport } from "./report.ts";
import { standings } from "./report.ts";
import { in_order, library } from "./words.ts";

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

export interface Row {
  f: Finding;
  standing: Standing | null;
  facet: Record<Facet, string>;
  margin: number;
  text: string;
}

export function rows_of(report: FullReport): Row[] {
  const standing_of = standings(report);
  return report.findings.map((f) => {
    const standing = standing_of(f);
    return {
      f,
      standing,
      margin: f.margin?.[0] ?? -1,
      facet: {
        severity: f.severity,
        kind: f.kind,
        library: library(f.method),
        family: f.family,
        standing: standing ?? "not compared",
      },
      text: [f.id, f.method, f.kind, f.family, f.bucket ?? "", f.reason ?? "", f.note ?? ""].join(" ").toLowerCase(),
    };
  });
}

function passes(row: Row, filter: Filter, but?: Facet) {
  for (const facet of facets) {
    if (facet !== but && filter.chosen[facet].size > 0 && !filter.chosen[facet].has(row.facet[facet])) return false;
  }
  return (
    (filter.method === null || row.f.method === filter.method) &&
    (filter.text === "" || row.text.includes(filter.text.toLowerCase()))
  );
}

export const filtered = (rows: Row[], filter: Filter) => rows.filter((row) => passes(row, filter));

/** How many rows each chip would give beside what the other facets leave; chips that are pressed stay. */
export function chip_counts(rows: Row[], filter: Filter): Record<Facet, Map<string, number>> {
  const counts = Object.fromEntries(facets.map((facet) => [facet, new Map<string, number>()])) as Record<
    Facet,
    Map<string, number>
  >;
  for (const facet of facets) {
    for (const row of rows) {
      const value = row.facet[facet],
        had = counts[facet].get(value) ?? 0;
      counts[facet].set(value, had + (passes(row, filter, facet) ? 1 : 0));
    }
  }
  return counts;
}

export const columns = ["id", "severity", "kind", "method", "family", "margin", "bucket", "standing"] as const;
export type Column = (typeof columns)[number];
export interface Order {
  column: Column;
  down: boolean;
}

const severity_rank: Record<string, number> = { contract: 0, resolution: 1, unresolved: 2 };

function compare(x: Row, y: Row, column: Column): number {
  switch (column) {
    case "id":
      return x.f.id - y.f.id;
    case "margin":
      return x.margin - y.margin;
    case "severity":
      return (severity_rank[x.f.severity] ?? 3) - (severity_rank[y.f.severity] ?? 3);
    case "standing":
      return x.facet.standing < y.facet.standing ? -1 : x.facet.standing > y.facet.standing ? 1 : 0;
    default: {
      const a = x.f[column] ?? "",
        b = y.f[column] ?? "";
      return a < b ? -1 : a > b ? 1 : 0;
    }
  }
}

/** Equal rows keep their order. */
export const sorted = (rows: Row[], order: Order) =>
  in_order(rows, (x, y) => (order.down ? -1 : 1) * compare(x, y, order.column));

/** The filter that a link asks for. */
export function filter_of(query: URLSearchParams): Filter {
  const chosen = { ...no_filter.chosen };
  for (const facet of facets) {
    const values = query.getAll(facet);
    if (values.length > 0) chosen[facet] = new Set(values);
  }
  return { chosen, method: query.get("method"), text: query.get("text") ?? "" };
}
