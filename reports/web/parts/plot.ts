// SPDX-License-Identifier: MIT
// What all plots share: colours, size, and ticks of a logarithmic axis.
import * as Plot from "@observablehq/plot";

export interface Theme {
  fg: string;
  soft: string;
  line: string;
  bg: string;
  disjoint: string;
  intersecting: string;
  failed: string;
  undecided: string;
  own: string;
  clean: string;
  heat: string[]; // of steps 1 to 5: beyond a claim or failed
  within: string[]; // likewise: wrong within a claim
  unanswered: string[]; // likewise: undecided or declined
  series: string[];
}
/** `document`: where there is none of a browser. `link`: where a click on a point leads. */
export interface Options {
  width: number;
  theme: Theme;
  document?: Document;
  link?: (method: string, family?: string) => string;
  title?: string;
}

/** Safe for those who do not tell red from green (Okabe and Ito). */
export const paper: Theme = {
  fg: "#1a1a1a",
  soft: "#666666",
  line: "#d0d0d0",
  bg: "#ffffff",
  disjoint: "#1a1a1a",
  intersecting: "#666666",
  failed: "#007a55",
  undecided: "#8a8a8a",
  own: "#007a55",
  clean: "#e6f0ea",
  heat: ["#fde3e0", "#f6b9b4", "#ea8981", "#c93a33", "#8f1612"],
  within: ["#e9ecef", "#d0d5db", "#b1b9c2", "#8c96a1", "#68727d"],
  unanswered: ["#f8f1d9", "#efe2b2", "#e0cc7c", "#c9ae46", "#a58a1d"],
  series: [
    "#0072b2",
    "#d55e00",
    "#8b3f86",
    "#b58900",
    "#3f6f8f",
    "#a0522d",
    "#5b5b9e",
    "#6b6b6b",
    "#c0507a",
    "#4d7f3a",
  ],
};
export const screen: Theme = {
  fg: "var(--fg)",
  soft: "var(--soft)",
  line: "var(--line)",
  bg: "var(--bg)",
  disjoint: "var(--fg)",
  intersecting: "var(--soft)",
  failed: "var(--own)",
  undecided: "var(--grey)",
  own: "var(--own)",
  clean: "var(--clean)",
  heat: [1, 2, 3, 4, 5].map((i) => `var(--bad-${i})`),
  within: [1, 2, 3, 4, 5].map((i) => `var(--within-${i})`),
  unanswered: [1, 2, 3, 4, 5].map((i) => `var(--undecided-${i})`),
  series: Array.from({ length: 10 }, (_, i) => `var(--series-${i})`),
};

/** Powers of ten that the values span. */
export function decades(values: number[]): number[] {
  const logs = values.filter((v) => v > 0).map(Math.log10);
  if (logs.length === 0) return [1];
  const low = Math.floor(Math.min(...logs)),
    high = Math.ceil(Math.max(...logs));
  return Array.from({ length: high - low + 1 }, (_, i) => 10 ** (low + i));
}
export const power = (d: number) => (d === 0 ? "1" : `1e${d < 0 ? "\u2212" : ""}${Math.abs(d)}`);
export const logTick = (x: number) => power(Math.round(Math.log10(x)));

/** Around a plot that asks for no other. */
export const margins = { left: 56, right: 30, top: 22, bottom: 42 };

export function common(o: Options, height: number, more: Plot.PlotOptions): Plot.PlotOptions {
  return {
    width: o.width,
    height,
    marginLeft: margins.left,
    marginBottom: margins.bottom,
    marginRight: margins.right,
    marginTop: margins.top,
    style: {
      background: "transparent",
      color: o.theme.fg,
      fontFamily: "system-ui, sans-serif",
      fontSize: "11px",
      overflow: "visible",
    },
    color: { type: "identity" },
    symbol: { type: "identity" },
    ...(o.document ? { document: o.document } : {}),
    ...more,
  } as Plot.PlotOptions;
}

/** The words of the point nearest to the pointer; none in a file. */
export const tips = <T>(
  data: T[],
  o: Options,
  title: (point: T) => string,
  at: Plot.TipOptions & { maxRadius?: number },
) =>
  o.document ? [] : [Plot.tip(data, Plot.pointer({ ...at, title, fill: o.theme.bg, stroke: o.theme.line }))];
