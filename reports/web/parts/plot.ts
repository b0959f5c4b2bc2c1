// SPDX-License-Identifier: MIT
// All plots share these: colours, size, and ticks of a logarithmic axis.
import * as Plot from "@observablehq/plot";

/** `document` is for Node, which has none. `link` returns the address to which a click on a point leads. */
export interface Options {
  width: number;
  document?: Document;
  link?: (of: string) => string;
}

/** Colours of style.css; chart.mjs puts their values into files. */
export const colours = {
  fg: "var(--fg)",
  soft: "var(--soft)",
  line: "var(--line)",
  bg: "var(--bg)",
  own: "var(--own)",
  series: Array.from({ length: 10 }, (_, i) => `var(--series-${i})`),
};

/** Pairs by the outcome of a method. The first outcome that occurs gives a cell its colour. */
export const outcomes = ["bad", "within", "undecided"] as const;
export type Outcomes = { [outcome in (typeof outcomes)[number] | "asked"]: number };

/** How strong the colour of an outcome is: 1 to 5, for a share below 1e-4, from 1e-4, 1e-3, 1e-2, 0.1 on. */
export const shade = (outcome: string, step: number) => `var(--${outcome}-${step})`;
const stepOf = (share: number) => Math.min(5, Math.max(1, Math.floor(Math.log10(share) + 1e-9) + 6));

/** The fill shows the share, and the edge its outcome. A cell without such answers has no edge. */
export function cellColours(c: Outcomes): { fill: string; edge: string | null } {
  const worst = outcomes.find((outcome) => c[outcome] > 0);
  if (!worst) return { fill: "var(--clean)", edge: null };
  return { fill: shade(worst, stepOf(c[worst] / c.asked)), edge: shade(worst, 5) };
}

/** Powers of ten that the values span. */
export function decades(values: number[]): number[] {
  const logs = values.filter((v) => v > 0).map(Math.log10);
  if (logs.length === 0) return [1];
  const low = Math.floor(Math.min(...logs)),
    high = Math.ceil(Math.max(...logs));
  return Array.from({ length: high - low + 1 }, (_, i) => 10 ** (low + i));
}
export const power = (d: number) => (d === 0 ? "1" : `1e${d < 0 ? "\u2212" : ""}${Math.abs(d)}`);

/** Around a plot that asks for no other. */
export const margins = { marginLeft: 68, marginRight: 30, marginTop: 22, marginBottom: 42 };

export const common = (o: Options, height: number, more: Plot.PlotOptions): Plot.PlotOptions => ({
  width: o.width,
  height,
  ...margins,
  style: {
    background: "transparent",
    color: colours.fg,
    fontFamily: "system-ui, sans-serif",
    fontSize: "11px",
    overflow: "visible",
  },
  color: { type: "identity" },
  symbol: { type: "identity" },
  ...(o.document && { document: o.document }),
  ...more,
});

/** The words of the point nearest to the pointer; none in a file. */
export const tips = <T>(
  data: T[],
  o: Options,
  title: (point: T) => string,
  at: Plot.TipOptions & { maxRadius?: number },
) =>
  o.document ? [] : [Plot.tip(data, Plot.pointer({ ...at, title, fill: colours.bg, stroke: colours.line }))];
