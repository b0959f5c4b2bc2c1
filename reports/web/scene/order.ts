// SPDX-License-Identifier: MIT
// Which pairs are shown, in which order.
import { inOrder } from "../parts/words.ts";
import { leastOf, riskOf, risks } from "./risk.ts";
import { rank, type Model, type StudiedPair, type Study } from "./study.ts";

export interface Filter {
  models: ReadonlySet<Model>;
  text: string;
} // no model: all
export const noFilter: Filter = { models: new Set(), text: "" };

export const passes = (pair: StudiedPair, filter: Filter) =>
  (filter.models.size === 0 || filter.models.has(pair.needs)) &&
  filter.text
    .toLowerCase()
    .split(/\s+/)
    .every((word) => pair.a.toLowerCase().includes(word) || pair.b.toLowerCase().includes(word));

export const columns = ["pair", "risk", "least", "here", "within", "needs", "sphere", "outer", "inner"] as const;
export type Column = (typeof columns)[number];
export interface Order {
  column: Column;
  down: boolean;
}

const ofModel = (pair: StudiedPair, model: Model) => pair.models[rank(model)]!;
/** The longest false alarm, or what is missed. */
export const worstOf = (pair: StudiedPair, model: Model) =>
  Math.max(ofModel(pair, model).false_alarm, ofModel(pair, model).missed);
export const wrongOf = (pair: StudiedPair, model: Model) => ofModel(pair, model).wrong;

/** What a column is sorted by; `here` are the gaps in the configuration shown. */
function valueOf(study: Study, column: Column, here: readonly (number | null)[]): (i: number) => number | string {
  const pair = (i: number) => study.pairs[i]!;
  switch (column) {
    case "pair":
      return (i) => `${pair(i).a} ${pair(i).b}`;
    case "risk":
      return (i) => risks.indexOf(riskOf(study, i));
    case "least":
      return (i) => leastOf(study, i);
    case "here":
      return (i) => here[i] ?? Infinity;
    case "within":
      return (i) => pair(i).within / Math.max(1, pair(i).samples);
    case "needs":
      return (i) => rank(pair(i).needs);
    case "sphere":
      return (i) => worstOf(pair(i), "sphere");
    case "outer":
      return (i) => worstOf(pair(i), "outer capsule");
    case "inner":
      return (i) => worstOf(pair(i), "inner capsule");
  }
}

/** Indices of study.pairs; among equal ones, first the pair that came nearest. */
export function rowsOf(study: Study, filter: Filter, order: Order, here: readonly (number | null)[] = []): number[] {
  const passing = study.pairs.flatMap((pair, i) => (passes(pair, filter) ? [i] : []));
  const sorted = (rows: number[], column: Column, sign: number) => {
    const value = valueOf(study, column, here),
      values = new Map(rows.map((i) => [i, value(i)]));
    return inOrder(rows, (i, j) => {
      const x = values.get(i)!,
        y = values.get(j)!;
      return x < y ? -sign : x > y ? sign : 0;
    });
  };
  return sorted(sorted(passing, "least", 1), order.column, order.down ? -1 : 1);
}
