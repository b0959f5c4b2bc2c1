// SPDX-License-Identifier: MIT
// The plots, for the page and for files: the same marks from the same data, with the colours of a Theme.
import * as Plot from "@observablehq/plot";
import { common, decades, logAxis, tips, type Options, type Theme } from "../parts/plot.ts";
import { groupBy, grouped, inOrder, percent, shareBounds, short, time } from "../parts/words.ts";
import type { BackwardError, Calibration, CostPoint, FailureMap, PathStability, SpeedPoint, Tally } from "./data.ts";
import { library } from "./words.ts";

export type Heat = "empty" | "clean" | "bad" | "within" | "undecided";

/** 1 to 5: a share below 1e-4, from 1e-4, 1e-3, 1e-2, 1e-1 on. */
export const heatStep = (share: number) => Math.min(5, Math.max(1, Math.floor(Math.log10(share) + 1e-9) + 6));

const power = (d: number) => (d === 0 ? "1" : `1e${d < 0 ? "\u2212" : ""}${Math.abs(d)}`);
const logTick = (x: number) => power(Math.round(Math.log10(x)));
/** A power of ten below `x`, where none is drawn on a logarithmic axis: only such ticks are labelled. */
const below = (x: number) => 10 ** (Math.ceil(Math.log10(x)) - 1);
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
// Speed against accuracy
// ------------------------------------------------------------------------------------------------

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

interface Box {
  x: number;
  y: number;
  wide: number;
  high: number;
}
const meet = (a: Box, b: Box) =>
  a.x < b.x + b.wide && b.x < a.x + a.wide && a.y < b.y + b.high && b.y < a.y + a.high;
const around = (x: number, y: number, half: number): Box => ({
  x: x - half,
  y: y - half,
  wide: 2 * half,
  high: 2 * half,
});

/** A place for each name beside its mark, in pixels, that meets no mark and no other name. */
function placed(marks: { x: number; y: number; name: string }[], taken: Box[], within: Box): Box[] {
  const letter = 9,
    high = 16,
    gap = 8;
  const all = [...taken];
  return marks.map(({ x, y, name }) => {
    const wide = letter * name.length;
    const rings = Array.from({ length: 24 }, (_, i) => (i % 2 === 0 ? -1 : 1) * Math.ceil(i / 2) * (high / 2));
    const places = rings.flatMap((up) => [
      { x: x + gap, y: y - high / 2 + up, wide, high },
      { x: x - gap - wide, y: y - high / 2 + up, wide, high },
      { x: x - wide / 2, y: y - high / 2 + up, wide, high },
    ]);
    const free = places.find(
      (b) =>
        b.x >= within.x &&
        b.x + b.wide <= within.x + within.wide &&
        b.y >= within.y &&
        b.y + b.high <= within.y + within.high &&
        !all.some((other) => meet(b, other)),
    );
    const box = free ?? places[0]!;
    all.push(box);
    return box;
  });
}

const describePoint = (p: SpeedPoint) =>
  [
    p.method + (p.setting && p.setting !== p.method ? ` (${p.setting})` : ""),
    `${time(p.ns)} a ` +
      `pair${p.p99 === null ? "" : `, p99 ${time(p.p99)}`}${p.max === null ? "" : `, most ${time(p.max)}`}`,
    p.digits === null
      ? "no digits known"
      : `${p.digits === 0 ? "not always right even at 1e\u22121" : `right from 1e\u2212${short(p.digits)} on`}` +
        (p.digits_low === null
          ? "; too few answers to show it"
          : `; with 95 % confidence from 1e\u2212${short(p.digits_low)}`),
    `wrongly reported disjoint ${grouped(p.wrong_disjoint)}, intersecting ${grouped(p.wrong_intersecting)} of ` +
      `${grouped(p.asked)}`,
  ].join("\n");

/** `claimed`: the accuracies, in digits, that engines claim for solids of size 1. */
export function speedPlot(points: SpeedPoint[], o: Options, claimed: number[] = []): Element {
  const known = points.filter((p) => p.digits !== null),
    best = bestOfEach(known),
    front = pareto(best);
  const ticks = decades(known.map((p) => p.ns)),
    highest = Math.max(8, ...known.map((p) => p.digits!)) + 3,
    height = 420;
  const frame: Box = { x: 56, y: 22, wide: o.width - 56 - 30, high: height - 22 - 42 };
  const [low, high] = [Math.log10(ticks[0]!), Math.log10(ticks.at(-1)!)];
  const across = (ns: number) => frame.x + ((Math.log10(ns) - low) / Math.max(1, high - low)) * frame.wide,
    down = (digits: number) => frame.y + (1 - digits / highest) * frame.high;
  const back = (box: Box) => ({
    ns: 10 ** (low + ((box.x - frame.x) / frame.wide) * Math.max(1, high - low)),
    digits: (1 - (box.y + box.high / 2 - frame.y) / frame.high) * highest,
  });
  const fill = (p: SpeedPoint) =>
    library(p.method) === "ours" ? o.theme.own : front.includes(p) ? o.theme.fg : o.theme.soft;
  const band = claimed.length > 0 ? [Math.min(...claimed) - 0.15, Math.max(...claimed) + 0.15] : null;
  const better: Box = { x: frame.x + 8, y: frame.y + 8, wide: 90, high: 34 };
  const bandText = band && { text: "claimed by engines", digits: (band[0]! + band[1]!) / 2 };
  const marks = inOrder(best, (x, y) => x.ns - y.ns);
  const places = placed(
    marks.map((p) => ({ x: across(p.ns), y: down(shownDigits(p)), name: library(p.method) })),
    [
      better,
      ...marks.flatMap((p) => [
        around(across(p.ns), down(shownDigits(p)), 7),
        around(across(p.ns), down(p.digits!), 6),
      ]),
      ...(bandText ? [{ x: frame.x + frame.wide - 130, y: down(bandText.digits) - 8, wide: 130, high: 16 }] : []),
    ],
    frame,
  );
  const names = marks.map((p, i) => ({ p, ...back(places[i]!), far: Math.hypot(
    Math.max(places[i]!.x - across(p.ns), across(p.ns) - places[i]!.x - places[i]!.wide, 0),
    Math.max(places[i]!.y - down(shownDigits(p)), down(shownDigits(p)) - places[i]!.y - places[i]!.high, 0),
  ) }));
  const stairs = front.flatMap((p, i) =>
    (i === 0 ? [] : [{ ns: p.ns, digits: shownDigits(front[i - 1]!) }]).concat({ ns: p.ns, digits: shownDigits(p) }),
  );
  const tip = back({ ...better, wide: 0, high: 0 }),
    tail = back({ x: better.x + 22, y: better.y + 22, wide: 0, high: 0 });
  return Plot.plot(
    common(o, height, {
      x: {
        type: "log",
        label: "time a pair \u2192",
        domain: [ticks[0]!, ticks.at(-1)! > ticks[0]! ? ticks.at(-1)! : ticks[0]! * 10],
        ticks,
        tickFormat: time,
        grid: true,
      },
      y: { label: "\u2191 correct digits", grid: true, domain: [0, highest] },
      marks: [
        ...(band
          ? [
              Plot.rectY([band], {
                y1: band[0],
                y2: band[1],
                fill: o.theme.line,
                fillOpacity: 0.4,
                stroke: o.theme.soft,
                strokeWidth: 0.6,
              }),
            ]
          : []),
        ...(bandText
          ? [
              Plot.text([bandText], {
                frameAnchor: "right",
                y: "digits",
                text: "text",
                fill: o.theme.soft,
                stroke: o.theme.bg,
                strokeWidth: 4,
                paintOrder: "stroke",
                fontSize: 12,
                dx: -4,
              }),
            ]
          : []),
        ...curvesOf(known.filter((p) => shownDigits(p) > 0))
          .filter((c) => c.length > 1)
          .map((c) => Plot.line(c, { x: "ns", y: shownDigits, stroke: fill(c[0]!), strokeWidth: 0.8 })),
        Plot.line(stairs, { x: "ns", y: "digits", stroke: o.theme.fg, strokeWidth: 2 }),
        Plot.ruleX(best, { x: "ns", y1: shownDigits, y2: "digits", stroke: fill }),
        Plot.dot(best, { x: "ns", y: "digits", fill: o.theme.bg, stroke: fill, r: 4 }),
        Plot.dot(best, {
          x: "ns",
          y: shownDigits,
          fill,
          stroke: o.theme.bg,
          r: 6,
          ...(o.link ? { href: (p: SpeedPoint) => o.link!(library(p.method)), target: "_self" } : {}),
          ariaLabel: describePoint,
        }),
        Plot.arrow([0], {
          x1: () => tail.ns,
          y1: () => tail.digits,
          x2: () => tip.ns,
          y2: () => tip.digits,
          stroke: o.theme.own,
          strokeWidth: 2,
        }),
        Plot.text([tail], {
          x: "ns",
          y: "digits",
          text: () => "better",
          textAnchor: "start",
          dx: 6,
          fill: o.theme.own,
          fontSize: 13,
          fontWeight: 600,
        }),
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
          textAnchor: "start",
          fill: (n) => fill(n.p),
          fontSize: 13,
          fontWeight: 600,
          stroke: o.theme.bg,
          strokeWidth: 3,
          paintOrder: "stroke",
        }),
        ...tips(known, o, describePoint, { x: "ns", y: shownDigits }),
      ],
    }),
  );
}

// Failure maps
// ----------------------------------------------------------------------------------------------------------

export type Wrongness = "all" | "wrong_disjoint" | "wrong_intersecting" | "failed" | "undecided" | "declined";
type Cell = FailureMap["cells"][number];
export const wrongOf = (c: Cell, what: Wrongness) =>
  what === "all" ? c.wrong_disjoint + c.wrong_intersecting + c.failed : (c[what] ?? 0);
/** Of those, how many the claim allows. */
export function withinOf(c: Cell, what: Wrongness) {
  const disjoint = c.within_disjoint ?? 0,
    intersecting = c.within_intersecting ?? 0;
  return what === "all"
    ? disjoint + intersecting
    : what === "wrong_disjoint"
      ? disjoint
      : what === "wrong_intersecting"
        ? intersecting
        : 0;
}
/** The map of a method with those cells alone in which no other library is wrong beyond its claim. */
export function onlyHere(map: FailureMap, all: FailureMap[]): FailureMap {
  const beyond = (c: Cell) => wrongOf(c, "all") > withinOf(c, "all"),
    key = (c: Cell) => `${c.x} ${c.y}`;
  const others = all.filter((m) => m.plane === map.plane && library(m.method) !== library(map.method));
  const shared = new Set(others.flatMap((m) => m.cells.filter(beyond).map(key)));
  return { ...map, cells: map.cells.filter((c) => !beyond(c) || !shared.has(key(c))) };
}
/** As the table of methods against families has it: what is beyond a claim before what is within. The fill is the
 *  share, the edge what it is of; a cell without such answers has no edge. */
export function mapColours(c: Cell, what: Wrongness, theme: Theme): { fill: string; edge: string | null } {
  const wrong = wrongOf(c, what),
    within = withinOf(c, what);
  const [shades, count] =
    what === "undecided" || what === "declined"
      ? [theme.unanswered, wrong]
      : wrong > within
        ? [theme.heat, wrong - within]
        : [theme.within, within];
  return count === 0
    ? { fill: theme.clean, edge: null }
    : { fill: shades[heatStep(count / c.asked) - 1]!, edge: shades.at(-1)! };
}
const describeCell = (map: FailureMap, c: Cell) =>
  [
    `${map.x.title}: ${map.x.labels[c.x] ?? c.x}`,
    `${map.y.title}: ${map.y.labels[c.y] ?? c.y}`,
    `asked ${grouped(c.asked)}`,
    ...(
      [
        ["wrong_disjoint", "wrongly reported disjoint"],
        ["wrong_intersecting", "wrongly reported intersecting"],
        ["failed", "failed"],
        ["undecided", "undecided"],
        ["declined", "declined"],
      ] as const
    )
      .map(([k, words]) => [words, wrongOf(c, k), withinOf(c, k)] as const)
      .filter(([, count]) => count > 0)
      .map(
        ([words, count, within]) =>
          `${words} ${grouped(count)} (${percent(count, c.asked)})` +
          (within > 0 ? `, ${grouped(within)} of them within its claim` : ""),
      ),
    ...(c.finding !== undefined ? ["click for a case of this cell"] : []),
  ].join("\n");

export function mapPlot(
  map: FailureMap,
  what: Wrongness,
  o: Options & { linkFinding?: (id: number) => string },
): Element {
  const coloursOf = (c: Cell) => mapColours(c, what, o.theme);
  const visited = map.cells.filter((c) => c.asked > 0);
  const seen = new Set(visited.map((c) => `${c.x} ${c.y}`));
  const blank = map.x.labels
    .flatMap((_, x) => map.y.labels.map((_, y) => ({ x, y }) as Cell))
    .filter((c) => !seen.has(`${c.x} ${c.y}`));
  const n = { x: map.x.labels.length, y: map.y.labels.length };
  const at = { x: (c: Cell) => c.x, y: (c: Cell) => c.y };
  const words = (c: Cell) => describeCell(map, c);
  const letters = Math.max(...map.x.labels.map((label) => label.length));
  const skip = Math.max(1, Math.ceil((n.x * (7 * letters + 6)) / (o.width - 104)));
  return Plot.plot(
    common(o, 40 + n.y * 17 + 46, {
      title: undefined,
      marginLeft: 74,
      marginBottom: 44,
      x: {
        type: "band",
        domain: Array.from({ length: n.x }, (_, i) => i),
        tickFormat: (i: number) => (i % skip === 0 ? (map.x.labels[i] ?? "") : ""),
        label: `${map.x.title} \u2192`,
        padding: 0.06,
        tickSize: 0,
      },
      y: {
        type: "band",
        domain: Array.from({ length: n.y }, (_, i) => n.y - 1 - i),
        tickFormat: (i: number) => map.y.labels[i] ?? "",
        label: `\u2191 ${map.y.title}`,
        padding: 0.06,
        tickSize: 0,
      },
      marks: [
        Plot.frame({ stroke: o.theme.line }),
        ...[true, false].map((isWrong) =>
          Plot.cell(
            visited.filter((c) => (coloursOf(c).edge !== null) === isWrong),
            {
              ...at,
              fill: (c: Cell) => coloursOf(c).fill,
              stroke: (c: Cell) => coloursOf(c).edge ?? o.theme.line,
              strokeWidth: isWrong ? 1 : 0.5,
              inset: 0.5,
              ...(isWrong ? {} : { className: "ground" }),
              ...(o.linkFinding
                ? { href: (c: Cell) => (c.finding !== undefined ? o.linkFinding!(c.finding) : null), target: "_self" }
                : {}),
              ariaLabel: words,
            },
          ),
        ),
        Plot.text(blank, { ...at, text: () => "\u2215", fill: o.theme.soft, fontSize: 8 }),
        Plot.dot(
          visited.filter((c) => wrongOf(c, what) > 0 && c.finding !== undefined),
          { ...at, r: 1.3, fill: o.theme.fg, pointerEvents: "none" },
        ),
        ...tips(visited, o, words, { ...at, maxRadius: 14 }),
      ],
    }),
  );
}

// Calibration: share wrong against margin
// -------------------------------------------------------------------------------------

/** Curves in one plot: as many as have a distinct colour and symbol. */
export const shownCap = 8;

/** The first method of each library, ours first, what the documents have last: shown first. */
export function firstOfEach(methods: string[]): string[] {
  const firsts = methods.filter((m, i) => methods.findIndex((n) => library(n) === library(m)) === i);
  const rank = (m: string) => (library(m) === "ours" ? 0 : m.startsWith("seed") ? 2 : 1);
  return inOrder(firsts, (x, y) => rank(x) - rank(y)).slice(0, shownCap);
}

/** The colour and symbol of each method of a list. */
export const seriesOf = (methods: string[], theme: Theme) => ({
  colour: (p: { method: string }) => theme.series[methods.indexOf(p.method) % theme.series.length]!,
  symbol: (p: { method: string }) => symbols[methods.indexOf(p.method) % symbols.length]!,
});

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
      x: {
        label: "margin, smaller \u2192",
        domain: [-0.5, last + 0.5],
        ticks: Array.from({ length: last + 1 }, (_, i) => i).filter(
          (i) => i % Math.ceil((last * 46 * 2) / (o.width - 90)) === 0,
        ),
        tickFormat: (d: number) => power(-d),
      },
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

// Stability
// ------------------------------------------------------------------------------------------------------------

export function costPlot(points: CostPoint[], o: Options): Element {
  const methods = [...new Set(points.map((p) => p.method))];
  const { colour, symbol } = seriesOf(methods, o.theme);
  const byMethod = [...groupBy(points, (p) => p.method).values()].map((ps) =>
    inOrder(ps, (x, y) => x.decade - y.decade),
  );
  const words = (p: CostPoint) =>
    `${p.method}, margin 1e\u2212${p.decade}\nhalf within ${time(p.p50)}\n99 % within ${time(p.p99)}\nall within ` +
    `${time(p.max)}`;
  const last = Math.max(1, ...points.map((p) => p.decade)),
    first = Math.min(0, ...points.map((p) => p.decade));
  return Plot.plot(
    common(o, 330, {
      x: {
        label: "margin, smaller \u2192",
        domain: [first, last],
        ticks: Array.from({ length: last - first + 1 }, (_, i) => first + i).filter(
          (i) => i % Math.ceil((last * 46) / (o.width - 90)) === 0,
        ),
        tickFormat: (d: number) => power(-d),
      },
      y: logAxis(
        "\u2191 time a pair: line p50, band to p99, dot longest",
        points.flatMap((p) => [p.p50, p.max]),
        time,
      ),
      marks: [
        ...byMethod.map((ps) =>
          Plot.areaY(ps, {
            x: "decade",
            y1: "p50",
            y2: "p99",
            fill: colour(ps[0]!),
            fillOpacity: 0.1,
            stroke: colour(ps[0]!),
            strokeWidth: 0.4,
          }),
        ),
        ...byMethod.map((ps) => Plot.line(ps, { x: "decade", y: "p50", stroke: colour(ps[0]!), strokeWidth: 1.5 })),
        Plot.dot(points, {
          x: "decade",
          y: "max",
          stroke: colour,
          r: 2.2,
          symbol,
          ariaLabel: words,
        }),
        ...tips(points, o, words, { x: "decade", y: "p50" }),
      ],
    }),
  );
}

export function tracePlot(path: PathStability, o: Options): Element {
  const trace = path.trace ?? [];
  const colour = (t: { verdict: string }) =>
    ({ disjoint: o.theme.intersecting, intersecting: o.theme.disjoint, touching: o.theme.failed })[t.verdict] ??
    o.theme.undecided;
  const shape = (t: { verdict: string }) =>
    ({ disjoint: "circle", intersecting: "square", touching: "diamond2" })[t.verdict] ?? "times";
  const known = trace.some((t) => t.distance !== null);
  // Steps go by decades towards 0.
  const nearest = Math.min(1, ...trace.map((t) => Math.abs(t.at)).filter((v) => v > 0));
  const farthest = Math.max(...trace.map((t) => Math.abs(t.at)));
  const y = (t: (typeof trace)[number]) =>
    known ? t.distance : t.verdict === "disjoint" ? 1 : t.verdict === "intersecting" ? -1 : 0;
  const words = (t: (typeof trace)[number]) =>
    `at ${short(t.at, 6)}: ${t.verdict}${t.distance === null ? "" : `, distance ${short(t.distance, 6)}`}`;
  const flips = trace
    .slice(1)
    .flatMap((t, i) => (t.verdict === trace[i]!.verdict ? [] : [{ at: (t.at + trace[i]!.at) / 2 }]));
  return Plot.plot(
    common(o, 220, {
      x: {
        type: "symlog",
        constant: nearest,
        label: "along the path \u2192",
        grid: true,
        ticks: [-farthest, 0, farthest],
        tickFormat: (v: number) => short(v),
      },
      y: known
        ? { label: "\u2191 distance it returns", grid: true, tickFormat: (v: number) => short(v) }
        : {
            label: null,
            domain: [-1.6, 1.6],
            ticks: [-1, 1],
            tickFormat: (v: number) => (v > 0 ? "disjoint" : "intersecting"),
          },
      marginLeft: 68,
      marks: [
        ...(known ? [Plot.ruleY([0], { stroke: o.theme.soft })] : []),
        Plot.ruleX(flips, { x: "at", stroke: o.theme.soft, strokeDasharray: "3 3" }),
        ...(known
          ? [
              Plot.line(
                trace.filter((t) => t.distance !== null),
                { x: "at", y: "distance", stroke: o.theme.soft, strokeWidth: 0.8 },
              ),
            ]
          : []),
        Plot.dot(trace, { x: "at", y, fill: colour, symbol: shape, r: 2.6, ariaLabel: words }),
        ...tips(trace, o, words, { x: "at", y }),
      ],
    }),
  );
}

export function backwardPlot(rows: BackwardError[], o: Options): Element {
  const sorted = inOrder(rows, (x, y) => y.max - x.max);
  const least = Math.min(...rows.flatMap((r) => [r.p50, r.p99, r.max]).filter((v) => v > 0), 1);
  const at = (v: number) => Math.min(Math.max(v, least), 10); // beyond: solids far apart that were taken for meeting
  const words = (r: BackwardError) =>
    `${r.method}: ${grouped(r.wrong)} wrong answers\nhalf right for an input within ${short(r.p50)} of its size\n` +
    `99 % within ${short(r.p99)}\nall within ${short(r.max)}`;
  return Plot.plot(
    common(o, 40 + rows.length * 17 + 40, {
      marginLeft: 190,
      x: logAxis(
        "backward error, in sizes: dot p50, tick p99, end largest \u2192",
        rows.flatMap((r) => [at(r.p50), at(r.max)]),
        logTick,
        o.width - 160,
      ),
      y: { type: "band", domain: sorted.map((r) => r.method), label: null, tickSize: 0 },
      marks: [
        Plot.link(sorted, {
          x1: (r: BackwardError) => at(r.p50),
          x2: (r: BackwardError) => at(r.max),
          y1: "method",
          y2: "method",
          stroke: o.theme.soft,
          strokeWidth: 1.5,
        }),
        Plot.tickX(sorted, { x: (r: BackwardError) => at(r.p99), y: "method", stroke: o.theme.soft, inset: 4 }),
        Plot.dot(sorted, { x: (r: BackwardError) => at(r.max), y: "method", stroke: o.theme.disjoint, r: 2.5 }),
        Plot.dot(sorted, { x: (r: BackwardError) => at(r.p50), y: "method", fill: o.theme.fg, r: 3, ariaLabel: words }),
        ...tips(sorted, o, words, { x: (r: BackwardError) => at(r.p50), y: "method" }),
      ],
    }),
  );
}

// Methods against families, for files: the page has a table
// --------------------------------------------------------------

export function familiesPlot(tallies: Tally[], methods: string[], families: string[], o: Options): Element {
  const rows = tallies.filter((t) => t.asked > 0 && methods.includes(t.method));
  const fill = (t: Tally) => {
    const bad = t.contract + t.failed;
    if (bad > 0) return o.theme.heat[heatStep(bad / t.asked) - 1]!;
    if (t.resolution > 0) return o.theme.within[heatStep(t.resolution / t.asked) - 1]!;
    return t.undecided > 0 ? o.theme.unanswered[heatStep(t.undecided / t.asked) - 1]! : o.theme.clean;
  };
  return Plot.plot(
    common(o, 150 + methods.length * 13, {
      marginLeft: 190,
      marginTop: 130,
      marginBottom: 8,
      x: {
        type: "band",
        domain: families,
        axis: "top",
        tickRotate: -60,
        label: null,
        tickFormat: (f: string) => f.replaceAll("_", " "),
        tickSize: 0,
        padding: 0.06,
      },
      y: { type: "band", domain: methods, label: null, tickSize: 0, padding: 0.08 },
      marks: [Plot.cell(rows, { x: "family", y: "method", fill })],
    }),
  );
}
