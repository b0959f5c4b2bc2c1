// SPDX-License-Identifier: MIT
// Speed against accuracy: one mark for each library.
import * as Plot from "@observablehq/plot";
import { common, decades, margins, power, tips, type Options } from "../parts/plot.ts";
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
/** Where names stand: beside the plot. */
const marginRight = 100,
  nameHeight = 15;

/** The line of what is reached at each time. */
const stairsOf = (front: SpeedPoint[]) =>
  front.flatMap((p, i) => [
    ...(i === 0 ? [] : [{ ns: p.ns, digits: shownDigits(front[i - 1]!) }]),
    { ns: p.ns, digits: shownDigits(p) },
  ]);

/** The points with a height for each name, from the top down, so that no name meets another. */
function namesOf(points: SpeedPoint[], highest: number) {
  const step = (nameHeight / (height - margins.top - margins.bottom)) * highest,
    ranked = inOrder(points, (x, y) => shownDigits(y) - shownDigits(x) || y.ns - x.ns);
  let free = highest;
  return ranked.map((p, i) => {
    const at = Math.max((ranked.length - 1 - i) * step, Math.min(free, shownDigits(p)));
    free = at - step;
    return { p, at };
  });
}

/** `claimed`: the accuracies, in digits, that engines claim for solids of size 1. */
export function speedPlot(points: SpeedPoint[], o: Options, claimed: number[] = []): Element {
  const known = points.filter((p) => p.digits !== null),
    best = bestOfEach(known),
    front = pareto(best);
  const ticks = decades(known.map((p) => p.ns)),
    domain = [ticks[0]!, Math.max(ticks.at(-1)!, ticks[0]! * 10)],
    highest = Math.ceil(Math.max(8, ...known.map((p) => p.digits!))) + 1;
  const colour = (p: SpeedPoint) =>
    library(p.method) === "ours" ? o.theme.own : front.includes(p) ? o.theme.fg : o.theme.soft;
  const names = namesOf(best, highest),
    end = () => domain[1]!;
  return Plot.plot(
    common(o, height, {
      marginRight,
      marginLeft: 64,
      x: { type: "log", label: "time a pair (logarithmic) \u2192", domain, ticks, tickFormat: time, grid: true },
      y: {
        label: "\u2191 right down to a margin of",
        labelAnchor: "top",
        grid: true,
        domain: [0, highest],
        tickFormat: (d: number) => power(-d),
      },
      marks: [
        Plot.rectY(claimed.length > 0 ? [0] : [], {
          y1: Math.min(...claimed) - 0.15,
          y2: Math.max(...claimed) + 0.15,
          fill: o.theme.line,
          fillOpacity: 0.4,
        }),
        ...curvesOf(known.filter((p) => shownDigits(p) > 0))
          .filter((c) => c.length > 1)
          .map((c) => Plot.line(c, { x: "ns", y: shownDigits, stroke: colour(c[0]!), strokeWidth: 0.8 })),
        Plot.line(stairsOf(front), { x: "ns", y: "digits", stroke: o.theme.fg, strokeWidth: 2 }),
        Plot.link(names, {
          x1: (n) => n.p.ns,
          y1: (n) => shownDigits(n.p),
          x2: end,
          y2: "at",
          stroke: o.theme.soft,
          strokeWidth: 0.4,
        }),
        Plot.ruleX(best, { x: "ns", y1: shownDigits, y2: "digits", stroke: colour }),
        Plot.dot(best, { x: "ns", y: "digits", fill: o.theme.bg, stroke: colour, r: 4 }),
        Plot.dot(best, {
          x: "ns",
          y: shownDigits,
          fill: colour,
          r: 5,
          ...(o.link
            ? { href: (p: SpeedPoint) => o.link!(library(p.method)), target: "_self" }
            : {}),
          ariaLabel: describePoint,
        }),
        Plot.text(names, {
          x: end,
          y: "at",
          text: (n) => library(n.p.method),
          dx: 6,
          textAnchor: "start",
          fontSize: 12,
          fontWeight: 600,
          fill: (n) => colour(n.p),
        }),
        ...tips(known, o, describePoint, { x: "ns", y: shownDigits }),
      ],
    }),
  );
}
