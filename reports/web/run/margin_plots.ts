// SPDX-License-Identifier: MIT
// What happens as the margin shrinks: the share of wrong answers.
import * as Plot from "@observablehq/plot";
import { common, decades, logTick, power, tips, type Options } from "../parts/plot.ts";
import { grouped, percent, shareBounds, short } from "../parts/words.ts";
import type { Calibration } from "./data.ts";
import { seriesOf } from "./series.ts";

/** A power of ten below `x`, which a logarithmic axis does not draw: only such ticks have a label. */
const below = (x: number) => 10 ** (Math.ceil(Math.log10(x)) - 1);

/** The decades of the margin from `first` to `last`, with a label on as many as have `width` pixels for it. */
function marginAxis(first: number, last: number, width: number, pad = 0) {
  const skip = Math.max(1, Math.ceil((last * 46) / width));
  return {
    label: "margin, smaller \u2192",
    domain: [first - pad, last + pad],
    ticks: Array.from({ length: last - first + 1 }, (_, i) => first + i).filter((d) => d % skip === 0),
    tickFormat: (d: number) => power(-d),
  };
}

export function calibrationPlot(all: Calibration[], o: Options): Element {
  const sides = [
    ["wrong_disjoint", "wrongly disjoint"],
    ["wrong_intersecting", "wrongly intersecting"],
  ] as const;
  const rows = all.flatMap((h) =>
    sides.flatMap(([key, side]) =>
      h.bins
        .map((b) => ({ ...b, answered: b.asked - (b.declined ?? 0) }))
        .filter((b) => b.answered > 0)
        .map((b) => {
          const [low, high] = shareBounds(b[key], b.answered);
          return {
            method: h.method,
            side,
            decade: b.decade,
            answered: b.answered,
            wrong: b[key],
            share: b[key] / b.answered,
            low,
            high,
          };
        }),
    ),
  );
  type Share = (typeof rows)[number];
  const floor = below(Math.min(0.01, ...rows.map((r) => r.high)));
  const methods = [...new Set(all.map((h) => h.method))];
  const { colour, symbol } = seriesOf(methods, o.theme);
  const words = (r: Share) =>
    `${r.method}, margin (1e\u2212${r.decade + 1}, 1e\u2212${r.decade}]\nwrong ${grouped(r.wrong)} of ` +
    `${grouped(r.answered)}: ${percent(r.wrong, r.answered)}\n95 %: ${short(r.low, 2)} to ${short(r.high, 2)}`;
  const last = Math.max(0, ...rows.map((r) => r.decade));
  const dx = (r: { method: string }) => (methods.indexOf(r.method) - (methods.length - 1) / 2) * 0.09;
  const x = (r: Share) => r.decade + dx(r);
  const share = (r: Share) => Math.max(floor, r.share),
    low = (r: Share) => Math.max(floor, r.low);
  return Plot.plot(
    common(o, 350, {
      marginTop: 44,
      x: marginAxis(0, last, (o.width - 90) / sides.length, 0.5),
      y: {
        type: "log",
        label: "\u2191 share wrong (bar: 95 %)",
        domain: [floor, 1],
        ticks: decades([floor, 1]),
        tickFormat: (v: number) => (v < floor * 1.01 ? "0" : logTick(v)),
        grid: true,
      },
      fx: { label: null, padding: 0.08 },
      marks: [
        Plot.frame({ stroke: o.theme.line }),
        Plot.ruleX(rows, {
          x,
          y1: low,
          y2: "high",
          fx: "side",
          stroke: colour,
          strokeWidth: (r: Share) => (r.wrong === 0 ? 0.3 : 0.8),
        }),
        ...methods.map((m) =>
          Plot.line(
            rows.filter((r) => r.method === m),
            { x, y: share, fx: "side", stroke: colour({ method: m }), strokeWidth: 1.3 },
          ),
        ),
        Plot.dot(rows, {
          x,
          y: share,
          fx: "side",
          stroke: colour,
          fill: (r: Share) => (r.wrong === 0 ? o.theme.bg : colour(r)),
          symbol,
          r: 3,
          ariaLabel: words,
        }),
        ...tips(rows, o, words, { x, y: share, fx: "side" }),
      ],
    }),
  );
}
