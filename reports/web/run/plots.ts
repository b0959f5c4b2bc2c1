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
/** Colours by library, ours apart; the same in every plot of a report. */
export function palette(libraries: Iterable<string>, theme: Theme): Map<string, string> {
  const colours = new Map([["ours", theme.own]]);
  for (const name of [...new Set(libraries)].sort())
    if (name !== "ours") colours.set(name, theme.series[(colours.size - 1) % theme.series.length]!);
  return colours;
}
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
const symbolOf = (libraries: string[]) => new Map(libraries.map((name, i) => [name, symbols[i % symbols.length]!]));

// Speed against accuracy
// ------------------------------------------------------------------------------------------------

/** Those that no other beats in both: the faster first. */
export function pareto(points: SpeedPoint[]): SpeedPoint[] {
  const front: SpeedPoint[] = [];
  for (const p of inOrder(
    points.filter((p) => p.digits !== null && p.digits > 0),
    (x, y) => x.ns - y.ns || y.digits! - x.digits!,
  ))
    if (front.length === 0 || p.digits! > front[front.length - 1]!.digits!) front.push(p);
  return front;
}

/** Each curve along its settings: by number where all are numbers, else from the least accurate on. */
const curvesOf = (points: SpeedPoint[]) =>
  [...groupBy(points, (p) => p.curve).values()].map((c) => {
    const numbers = c.every((p) => p.setting !== "" && !Number.isNaN(Number(p.setting)));
    return inOrder(c, (x, y) =>
      numbers ? Number(x.setting) - Number(y.setting) : x.digits! - y.digits! || x.ns - y.ns,
    );
  });
/** Room that a name takes in the plot: digits high, and as a part of its width for each letter. */
const nameHeight = 0.5,
  pointHeight = 0.38,
  nameWidth = 0.0083;

/** A name of a curve and where it begins, a place near its point where neither a point nor another name is. */
interface Name {
  p: SpeedPoint;
  ns: number;
  digits: number;
}
function named(points: SpeedPoint[], all: SpeedPoint[], highest: number): Name[] {
  const logs = all.map((p) => Math.log10(p.ns)),
    [low, high] = [Math.floor(Math.min(...logs)), Math.ceil(Math.max(...logs))], // as the axis has it
    span = Math.max(1, high - low);
  const wide = (p: SpeedPoint) => nameWidth * span * p.curve.length;
  const names: Name[] = [];
  const free = (at: Name) =>
    at.digits <= highest &&
    all.every(
      (q) =>
        Math.abs(q.digits! - at.digits) >= pointHeight ||
        Math.log10(q.ns) > Math.log10(at.ns) + wide(at.p) + 0.01 * span ||
        Math.log10(at.ns) > Math.log10(q.ns) + 0.01 * span,
    ) &&
    names.every(
      (q) =>
        Math.abs(q.digits - at.digits) >= nameHeight ||
        Math.log10(q.ns) > Math.log10(at.ns) + wide(at.p) ||
        Math.log10(at.ns) > Math.log10(q.ns) + wide(q.p),
    );
  for (const p of inOrder(points, (x, y) => x.ns - y.ns)) {
    // Right of the point or left of it, a little above it; else ever farther up and down.
    const x = Math.log10(p.ns);
    const places = Array.from({ length: 40 }, (_, i) => 0.4 + (i % 2 === 0 ? -1 : 1) * Math.ceil(i / 2) * nameHeight)
      .flatMap((up) => [x + 0.006 * span, x - wide(p) - 0.006 * span].map((start) => [start, up] as const))
      .filter(([start, up]) => start >= low && start + wide(p) <= high && p.digits! + up >= 0.2)
      .map(([start, up]) => ({ p, ns: 10 ** start, digits: p.digits! + up }));
    names.push(places.find(free) ?? { p, ns: p.ns, digits: p.digits! });
  }
  return names;
}
const describePoint = (p: SpeedPoint) =>
  [
    p.method + (p.setting && p.setting !== p.method ? ` (${p.setting})` : ""),
    `${time(p.ns)} a ` +
      `pair${p.p99 === null ? "" : `, p99 ${time(p.p99)}`}${p.max === null ? "" : `, most ${time(p.max)}`}`,
    p.digits === null
      ? "no digits known"
      : `${p.digits === 0 ? "not always right even at 1e\u22121" : `right from 1e\u2212${short(p.digits)} on`}` +
        `${p.digits_low === null ? "" : `; with 95 % confidence from 1e\u2212${short(p.digits_low)}`}`,
    `wrongly reported disjoint ${grouped(p.wrong_disjoint)}, intersecting ${grouped(p.wrong_intersecting)} of ` +
      `${grouped(p.asked)}`,
  ].join("\n");

export function speedPlot(points: SpeedPoint[], o: Options): Element {
  const known = points.filter((p) => p.digits !== null);
  const libraries = [
    ...palette(
      points.map((p) => library(p.method)),
      o.theme,
    ).keys(),
  ];
  const colour = palette(libraries, o.theme),
    shape = symbolOf(libraries);
  const front = pareto(known);
  const times = known.flatMap((p) => [p.ns, p.p99 ?? p.ns]);
  const fill = (p: SpeedPoint) => colour.get(library(p.method))!;
  const ends = curvesOf(known).map((c) => c.reduce((best, p) => (p.digits! > best.digits! ? p : best)));
  const highest = Math.max(4, ...known.map((p) => p.digits!)) + 3;
  const names = named(ends, known, highest - 0.3);
  const stairs = front.flatMap((p, i) =>
    (i === 0 ? [] : [{ ns: p.ns, digits: front[i - 1]!.digits! }]).concat({ ns: p.ns, digits: p.digits! }),
  );
  return Plot.plot(
    common(o, 420, {
      x: logAxis("time a pair (median; whisker: p99) \u2192", times, time),
      y: {
        label: "\u2191 correct digits d: right at every margin from 1e\u2212d on (whisker: down to the 95 % bound)",
        grid: true,
        domain: [0, highest],
      },
      marks: [
        Plot.line(stairs, { x: "ns", y: "digits", stroke: o.theme.soft, strokeDasharray: "5 3", strokeWidth: 1.2 }),
        Plot.ruleY(
          known.filter((p) => p.p99 !== null && p.p99 > p.ns),
          { x1: "ns", x2: "p99", y: "digits", stroke: fill, strokeOpacity: 0.45 },
        ),
        Plot.ruleX(
          known.filter((p) => p.digits_low !== null),
          { x: "ns", y1: "digits_low", y2: "digits", stroke: fill, strokeOpacity: 0.7 },
        ),
        ...curvesOf(known)
          .filter((c) => c.length > 1)
          .map((c) => Plot.line(c, { x: "ns", y: "digits", stroke: fill(c[0]!), strokeWidth: 1.3 })),
        Plot.dot(known, {
          x: "ns",
          y: "digits",
          fill,
          stroke: o.theme.bg,
          strokeWidth: 0.8,
          symbol: (p: SpeedPoint) => shape.get(library(p.method)),
          r: 4.5,
          ...(o.link ? { href: (p: SpeedPoint) => o.link!(p.method, p.family), target: "_self" } : {}),
          ariaLabel: describePoint,
        }),
        Plot.link(
          names.filter((n) => Math.abs(n.digits - n.p.digits!) > nameHeight),
          {
            x1: (n: Name) => n.p.ns,
            y1: (n: Name) => n.p.digits,
            x2: "ns",
            y2: "digits",
            stroke: (n: Name) => fill(n.p),
            strokeWidth: 0.5,
          },
        ),
        Plot.text(names, {
          x: "ns",
          y: "digits",
          text: (n: Name) => n.p.curve,
          textAnchor: "start",
          fill: (n: Name) => fill(n.p),
          fontSize: 10,
          stroke: o.theme.bg,
          strokeWidth: 3,
          paintOrder: "stroke",
        }),
        ...tips(known, o, describePoint, { x: "ns", y: "digits" }),
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
/** As the table of methods against families has it: what is beyond a claim before what is within. */
function mapColour(c: Cell, what: Wrongness, theme: Theme) {
  const wrong = wrongOf(c, what),
    within = withinOf(c, what);
  const [shades, count] =
    what === "undecided" || what === "declined"
      ? [theme.unanswered, wrong]
      : wrong > within
        ? [theme.heat, wrong - within]
        : [theme.within, within];
  return count === 0 ? theme.clean : shades[heatStep(count / c.asked) - 1]!;
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
  const fill = (c: Cell) => mapColour(c, what, o.theme);
  const visited = map.cells.filter((c) => c.asked > 0);
  const seen = new Set(visited.map((c) => `${c.x} ${c.y}`));
  const blank = map.x.labels
    .flatMap((_, x) => map.y.labels.map((_, y) => ({ x, y }) as Cell))
    .filter((c) => !seen.has(`${c.x} ${c.y}`));
  const n = { x: map.x.labels.length, y: map.y.labels.length };
  const at = { x: (c: Cell) => c.x, y: (c: Cell) => c.y };
  const words = (c: Cell) => describeCell(map, c);
  const skip = Math.max(1, Math.ceil((n.x * 40) / (o.width - 90)));
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
        Plot.cell(visited, {
          ...at,
          fill,
          stroke: o.theme.line,
          strokeWidth: 0.5,
          inset: 0,
          ...(o.linkFinding
            ? { href: (c: Cell) => (c.finding !== undefined ? o.linkFinding!(c.finding) : null), target: "_self" }
            : {}),
          ariaLabel: words,
        }),
        Plot.text(blank, { ...at, text: () => "\u2215", fill: o.theme.soft, fillOpacity: 0.6, fontSize: 8 }),
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
    ["wrong_disjoint", "reported disjoint, but they intersect"],
    ["wrong_intersecting", "reported intersecting, but they are disjoint"],
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
    common(o, 330, {
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
          strokeOpacity: (r: Share) => (r.wrong === 0 ? 0.2 : 0.5),
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
        ticks: Array.from({ length: last - first + 1 }, (_, i) => first + i),
        tickFormat: (d: number) => power(-d),
      },
      y: logAxis(
        "\u2191 time a pair: line p50, band to p99, dot longest",
        points.flatMap((p) => [p.p50, p.max]),
        time,
      ),
      marks: [
        ...byMethod.map((ps) =>
          Plot.areaY(ps, { x: "decade", y1: "p50", y2: "p99", fill: colour(ps[0]!), fillOpacity: 0.14 }),
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
        ticks: 7,
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
        "how far the input must move for the answer to be right, in sizes: dot p50, tick p99, end largest \u2192",
        rows.flatMap((r) => [at(r.p50), at(r.max)]),
        logTick,
      ),
      y: { type: "band", domain: sorted.map((r) => r.method), label: null, tickSize: 0 },
      marks: [
        Plot.link(sorted, {
          x1: (r: BackwardError) => at(r.p50),
          x2: (r: BackwardError) => at(r.max),
          y1: "method",
          y2: "method",
          stroke: o.theme.line,
          strokeWidth: 3,
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
