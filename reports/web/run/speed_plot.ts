// SPDX-License-Identifier: MIT
// Speed against accuracy: one mark for each library.
import * as Plot from "@observablehq/plot";
import { around, farFrom, firstFree, placed, type Box, type Spot } from "../parts/labels.ts";
import { common, decades, margins, tips, type Options } from "../parts/plot.ts";
import { groupBy, grouped, inOrder, short, time } from "../parts/words.ts";
import type { SpeedPoint } from "./data.ts";
import { library } from "./words.ts";

/** The accuracy that the answers show with 95 % confidence; what is not shown is none. */
const shownDigits = (p: SpeedPoint) => p.digits_low ?? 0;

/** Those that no other beats in both: the faster first. */
export function pareto(points: SpeedPoint[]): SpeedPoint[] {
  const front: SpeedPoint[] = [];
  for (const p of inOrder(
    points.filter((p) => shownDigits(p) > 0),
    (x, y) => x.ns - y.ns || shownDigits(y) - shownDigits(x),
  ))
    if (front.length === 0 || shownDigits(p) > shownDigits(front[front.length - 1]!)) front.push(p);
  return front;
}

/** Of each library the setting that shows the highest accuracy, and of equal ones the fastest. */
export const bestOfEach = (points: SpeedPoint[]) =>
  [...groupBy(points, (p) => library(p.method)).values()].map((of) =>
    of.reduce((best, p) => {
      const more = shownDigits(p) - shownDigits(best) || (p.digits ?? 0) - (best.digits ?? 0) || best.ns - p.ns;
      return more > 0 ? p : best;
    }),
  );

/** Each curve along its settings: by number if all are numbers, else from the least accurate on. */
const curvesOf = (points: SpeedPoint[]) =>
  [...groupBy(points, (p) => p.curve).values()].map((c) => {
    const numbers = c.every((p) => p.setting !== "" && !Number.isNaN(Number(p.setting)));
    return inOrder(c, (x, y) =>
      numbers ? Number(x.setting) - Number(y.setting) : shownDigits(x) - shownDigits(y) || x.ns - y.ns,
    );
  });

const describePoint = (p: SpeedPoint) =>
  [
    p.method + (p.setting && p.setting !== p.method ? ` (${p.setting})` : ""),
    `${time(p.ns)} a ` +
      `pair${p.p99 === null ? "" : `, p99 ${time(p.p99)}`}${p.max === null ? "" : `, most ${time(p.max)}`}`,
    p.digits === null
      ? "no digits known"
      : (p.digits === 0
          ? "not always right even at 1e\u22121"
          : `right above a margin of 1e\u2212${short(p.digits)}`) +
        (p.digits_low === null
          ? "; too few answers to show it"
          : `; with 95 % confidence above 1e\u2212${short(p.digits_low)}`),
    `wrongly reported disjoint ${grouped(p.wrong_disjoint)}, intersecting ${grouped(p.wrong_intersecting)} of ` +
      `${grouped(p.asked)}`,
  ].join("\n");

const height = 420;

interface Place {
  ns: number;
  digits: number;
}
const shown = (p: SpeedPoint): Place => ({ ns: p.ns, digits: shownDigits(p) });

/** From a place in the plot to pixels, and back. */
function scales(frame: Box, [first, last]: [number, number], highest: number) {
  const low = Math.log10(first),
    span = Math.log10(last) - low;
  return {
    spotOf: ({ ns, digits }: Place): Spot => ({
      x: frame.x + ((Math.log10(ns) - low) / span) * frame.wide,
      y: frame.y + (1 - digits / highest) * frame.high,
    }),
    placeAt: ({ x, y }: Spot): Place => ({
      ns: 10 ** (low + ((x - frame.x) / frame.wide) * span),
      digits: (1 - (y - frame.y) / frame.high) * highest,
    }),
  };
}

/** The line of what is reached at each time. */
const stairsOf = (front: SpeedPoint[]): Place[] =>
  front.flatMap((p, i) => [...(i === 0 ? [] : [{ ns: p.ns, digits: shownDigits(front[i - 1]!) }]), shown(p)]);

const outlined = (o: Options, strokeWidth: number) =>
  ({ stroke: o.theme.bg, strokeWidth, paintOrder: "stroke" }) as const;
const bold = { fontSize: 13, fontWeight: 600, textAnchor: "start" } as const;

/** The accuracies that engines claim, with words that begin at a place. */
const bandMarks = ([low, high]: [number, number], words: Place, o: Options) => [
  Plot.rectY([0], {
    y1: low,
    y2: high,
    fill: o.theme.line,
    fillOpacity: 0.4,
    stroke: o.theme.soft,
    strokeWidth: 0.6,
  }),
  Plot.text([words], {
    x: "ns",
    y: "digits",
    text: () => "claimed by engines",
    textAnchor: "start",
    fill: o.theme.soft,
    fontSize: 12,
    ...outlined(o, 4),
  }),
];

/** Above or below the band, at its right or left end. */
const placesForWords = (frame: Box, top: number, bottom: number): Box[] =>
  [top - 17, bottom + 1].flatMap((y) =>
    [frame.x + frame.wide - 124, frame.x + 4].map((x) => ({ x, y, wide: 124, high: 16 })),
  );

/** An arrow from one place to the other. */
const betterMarks = (tail: Place, tip: Place, o: Options) => [
  Plot.arrow([0], {
    x1: () => tail.ns,
    y1: () => tail.digits,
    x2: () => tip.ns,
    y2: () => tip.digits,
    stroke: o.theme.own,
    strokeWidth: 2,
  }),
  Plot.text([tail], { x: "ns", y: "digits", text: () => "better", dx: 6, fill: o.theme.own, ...bold }),
];

/** `claimed`: the accuracies, in digits, that engines claim for solids of size 1. */
export function speedPlot(points: SpeedPoint[], o: Options, claimed: number[] = []): Element {
  const known = points.filter((p) => p.digits !== null),
    best = inOrder(bestOfEach(known), (x, y) => x.ns - y.ns),
    front = pareto(best);
  const ticks = decades(known.map((p) => p.ns)),
    domain: [number, number] = [ticks[0]!, Math.max(ticks.at(-1)!, ticks[0]! * 10)],
    highest = Math.max(8, ...known.map((p) => p.digits!)) + 3;
  const frame: Box = {
    x: margins.left,
    y: margins.top,
    wide: o.width - margins.left - margins.right,
    high: height - margins.top - margins.bottom,
  };
  const { spotOf, placeAt } = scales(frame, domain, highest);
  const colour = (p: SpeedPoint) =>
    library(p.method) === "ours" ? o.theme.own : front.includes(p) ? o.theme.fg : o.theme.soft;
  const band: [number, number] | null =
    claimed.length > 0 ? [Math.min(...claimed) - 0.15, Math.max(...claimed) + 0.15] : null;

  const better: Box = { x: frame.x + 8, y: frame.y + 8, wide: 90, high: 34 };
  const taken = [
    better,
    ...best.flatMap((p) => [around(spotOf(shown(p)), 7), around(spotOf({ ns: p.ns, digits: p.digits! }), 6)]),
  ];
  const edges = band?.map((digits) => spotOf({ ns: domain[0], digits }).y);
  const words = edges && firstFree(placesForWords(frame, edges[1]!, edges[0]!), taken, frame);
  if (words) taken.push(words);
  const boxes = placed(
    best.map((p) => ({ ...spotOf(shown(p)), name: library(p.method) })),
    taken,
    frame,
  );
  const middleOf = (box: Box) => placeAt({ x: box.x, y: box.y + box.high / 2 });
  const names = best.map((p, i) => {
    const box = boxes[i]!;
    return { p, ...middleOf(box), far: farFrom(spotOf(shown(p)), box) };
  });

  return Plot.plot(
    common(o, height, {
      x: { type: "log", label: "time a pair \u2192", domain, ticks, tickFormat: time, grid: true },
      y: { label: "\u2191 correct digits", grid: true, domain: [0, highest] },
      marks: [
        ...(band && words ? bandMarks(band, middleOf(words), o) : []),
        ...curvesOf(known.filter((p) => shownDigits(p) > 0))
          .filter((c) => c.length > 1)
          .map((c) => Plot.line(c, { x: "ns", y: shownDigits, stroke: colour(c[0]!), strokeWidth: 0.8 })),
        Plot.line(stairsOf(front), { x: "ns", y: "digits", stroke: o.theme.fg, strokeWidth: 2 }),
        Plot.ruleX(best, { x: "ns", y1: shownDigits, y2: "digits", stroke: colour }),
        Plot.dot(best, { x: "ns", y: "digits", fill: o.theme.bg, stroke: colour, r: 4 }),
        Plot.dot(best, {
          x: "ns",
          y: shownDigits,
          fill: colour,
          stroke: o.theme.bg,
          r: 6,
          ...(o.link ? { href: (p: SpeedPoint) => o.link!(library(p.method)), target: "_self" } : {}),
          ariaLabel: describePoint,
        }),
        ...betterMarks(placeAt({ x: better.x + 22, y: better.y + 22 }), placeAt(better), o),
        Plot.link(
          names.filter((n) => n.far > 12),
          {
            x1: (n) => n.p.ns,
            y1: (n) => shownDigits(n.p),
            x2: "ns",
            y2: "digits",
            stroke: o.theme.soft,
            strokeWidth: 0.6,
          },
        ),
        Plot.text(names, {
          x: "ns",
          y: "digits",
          text: (n) => library(n.p.method),
          fill: (n) => colour(n.p),
          ...bold,
          ...outlined(o, 3),
        }),
        ...tips(known, o, describePoint, { x: "ns", y: shownDigits }),
      ],
    }),
  );
}
