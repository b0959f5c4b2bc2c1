// SPDX-License-Identifier: MIT
// Which methods a plot shows first, and the colour and symbol of each.
import type { Theme } from "../parts/plot.ts";
import { inOrder } from "../parts/words.ts";
import { isText, library } from "./words.ts";

const symbols = [
  "circle",
  "triangle",
  "square",
  "diamond",
  "star",
  "wye",
  "cross",
  "hexagon",
  "diamond2",
  "square2",
] as const;

/** Curves in one plot: as many as have a distinct colour and symbol. */
export const shownCap = 8;

/** The first method of each library, ours first, what the documents have last: shown first. */
export function firstOfEach(methods: string[]): string[] {
  const firsts = methods.filter((m, i) => methods.findIndex((n) => library(n) === library(m)) === i);
  const rank = (m: string) => (library(m) === "ours" ? 0 : isText(m) ? 2 : 1);
  return inOrder(firsts, (x, y) => rank(x) - rank(y)).slice(0, shownCap);
}

/** The colour and symbol of each method of a list. */
export const seriesOf = (methods: string[], theme: Theme) => ({
  colour: (p: { method: string }) => theme.series[methods.indexOf(p.method) % theme.series.length]!,
  symbol: (p: { method: string }) => symbols[methods.indexOf(p.method) % symbols.length]!,
});
