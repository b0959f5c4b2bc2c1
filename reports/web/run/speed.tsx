// SPDX-License-Identifier: MIT
// Speed against accuracy: one mark for each library.
import * as Plot from "@observablehq/plot";
import { group, sort } from "d3-array";
import { useCallback, useMemo, useState } from "preact/hooks";
import { Figure, Section, Select } from "../parts/elements.tsx";
import { colours, common, decades, margins, power, tips, type Options } from "../parts/plot.ts";
import { grouped, safe, short, time } from "../parts/words.ts";
import type { Report, SpeedPoint } from "./data.ts";
import { toFindings } from "./findings.tsx";
import { claimedDigits } from "./report.ts";

export const questions: Record<string, string> = {
  verdict: "yes or no, one pair",
  batch: "yes or no, many pairs at once",
  certificate: "with a proof",
};

/** The accuracy that the answers show with 95 % confidence, or 0. */
const shownDigits = (p: SpeedPoint) => p.digits_low ?? 0;

/** The points that no other beats in both, the faster first. */
export function pareto(points: SpeedPoint[]): SpeedPoint[] {
  const front: SpeedPoint[] = [];
  for (const p of sort(
    points.filter((p) => shownDigits(p) > 0),
    (x, y) => x.ns - y.ns || shownDigits(y) - shownDigits(x),
  ))
    if (front.length === 0 || shownDigits(p) > shownDigits(front[front.length - 1]!)) front.push(p);
  return front;
}

const known = (points: SpeedPoint[]) => points.filter((p) => p.digits !== null);

/** The setting of each library that shows the highest accuracy, and the fastest if several do. */
const bestOfEach = (points: SpeedPoint[]) => {
  const better = (x: SpeedPoint, y: SpeedPoint) =>
    shownDigits(y) - shownDigits(x) || (y.digits ?? 0) - (x.digits ?? 0) || x.ns - y.ns;
  return [...group(points, (p) => p.library).values()].map((of) => sort(of, better)[0]!);
};

/** Each curve from its least accurate setting on. */
const curvesOf = (points: SpeedPoint[]) =>
  [...group(points, (p) => p.curve).values()]
    .filter((c) => c.length > 1)
    .map((c) => sort(c, (x, y) => shownDigits(x) - shownDigits(y) || x.ns - y.ns));

const describePoint = (p: SpeedPoint) =>
  [
    p.method + (p.setting && p.setting !== p.method ? ` (${p.setting})` : ""),
    `${time(p.ns)} a pair${p.p99 === null ? "" : `, p99 ${time(p.p99)}`}`,
    (p.digits === 0
      ? "not always right even at 1e\u22121"
      : `always right if the margin exceeds 1e\u2212${short(p.digits)}`) +
      (p.digits_low === null
        ? "; too few answers to show it"
        : `; with 95 % confidence if it exceeds 1e\u2212${short(p.digits_low)}`),
    `wrongly reported disjoint ${grouped(p.wrong_disjoint)}, intersecting ${grouped(p.wrong_intersecting)} of ` +
      `${grouped(p.asked)}`,
  ].join("\n");

const height = 420;
/** The place of the names, beside the plot. */
const marginRight = 100,
  nameHeight = 15;

/** The points with a height for each name, from the top down, so that no name meets another. */
function namesOf(points: SpeedPoint[], highest: number) {
  const step = (nameHeight / (height - margins.marginTop - margins.marginBottom)) * highest,
    ranked = sort(points, (x, y) => shownDigits(y) - shownDigits(x) || y.ns - x.ns);
  let free = highest;
  return ranked.map((p, i) => {
    const at = Math.max((ranked.length - 1 - i) * step, Math.min(free, shownDigits(p)));
    free = at - step;
    return { p, at };
  });
}

/** `claimed`: the accuracies, in digits, that engines claim for solids of size 1. */
export function speedPlot(all: SpeedPoint[], o: Options, claimed: number[]): Element {
  const points = known(all),
    best = bestOfEach(points),
    front = pareto(best);
  const ticks = decades(points.map((p) => p.ns)),
    domain = [ticks[0]!, Math.max(ticks.at(-1)!, ticks[0]! * 10)],
    highest = Math.ceil(Math.max(8, ...points.map((p) => p.digits!))) + 1;
  const colour = (p: SpeedPoint) =>
    p.library === "ours" ? colours.own : front.includes(p) ? colours.fg : colours.soft;
  const names = namesOf(best, highest),
    end = () => domain[1]!,
    shown = { x: "ns", y: shownDigits };
  return Plot.plot(
    common(o, height, {
      marginRight,
      x: { type: "log", label: "time a pair (logarithmic) \u2192", domain, ticks, tickFormat: time, grid: true },
      y: {
        label: "\u2191 always right if the margin exceeds",
        labelAnchor: "top",
        grid: true,
        domain: [0, highest],
        tickFormat: (d: number) => power(-d),
      },
      marks: [
        Plot.rectY(claimed.length > 0 ? [0] : [], {
          y1: Math.min(...claimed) - 0.15,
          y2: Math.max(...claimed) + 0.15,
          fill: colours.line,
          fillOpacity: 0.4,
        }),
        ...curvesOf(points.filter((p) => shownDigits(p) > 0)).map((c) =>
          Plot.line(c, { ...shown, stroke: colour(c[0]!), strokeWidth: 0.8 }),
        ),
        Plot.line(front, { ...shown, curve: "step-after", stroke: colours.fg, strokeWidth: 2 }),
        Plot.link(names, {
          x1: (n) => n.p.ns,
          y1: (n) => shownDigits(n.p),
          x2: end,
          y2: "at",
          stroke: colours.soft,
          strokeWidth: 0.4,
        }),
        Plot.ruleX(best, { x: "ns", y1: shownDigits, y2: "digits", stroke: colour }),
        Plot.dot(best, { x: "ns", y: "digits", fill: colours.bg, stroke: colour, r: 4 }),
        Plot.dot(best, {
          ...shown,
          fill: colour,
          r: 5,
          ...(o.link && { href: (p: SpeedPoint) => o.link!(p.library), target: "_self" }),
          ariaLabel: describePoint,
        }),
        Plot.text(names, {
          x: end,
          y: "at",
          text: (n) => n.p.library,
          dx: 6,
          textAnchor: "start",
          fontSize: 12,
          fontWeight: 600,
          fill: (n) => colour(n.p),
        }),
        ...tips(points, o, describePoint, shown),
      ],
    }),
  );
}

export function Speed({ report }: { report: Report }) {
  const asked = Object.keys(questions).filter((query) => known(report.speed).some((p) => p.query === query));
  const [query, ask] = useState(asked[0] ?? "");
  const points = useMemo(() => report.speed.filter((p) => p.query === query), [report, query]);
  const draw = useCallback(
    (width: number) =>
      speedPlot(points, { width, link: (library) => toFindings({ library }) }, claimedDigits(report)),
    [points],
  );
  if (points.length === 0) return null;
  const front = pareto(bestOfEach(known(points)));
  return (
    <Section
      id="speed"
      title="Speed against accuracy"
      lead={
        "One mark for each library, at its most accurate setting. Accuracy is a margin. On every pair with at " +
        "least this margin, the library's yes or no was right. Errors of distances do not count."
      }>
      <p class="tools">
        <Select label="Question" value={query} onChange={ask} options={asked.map((q) => [q, questions[q]!])} />
      </p>
      <Figure
        draw={draw}
        height={height}
        label="The margin down to which a library is right, against time a pair"
        caption={
          "A filled mark is the accuracy that the answers show with 95 % confidence, and the hollow mark above it is " +
          "the accuracy that was observed. A thin line joins the settings of one method, and the grey band is what " +
          "engines claim. No library is both faster and more accurate than " +
          `${safe(front.map((p) => `${p.library} (${time(p.ns)}, ${p.method})`).join(", "))}. ` +
          `${grouped(Math.max(...points.map((p) => p.asked)))} pairs at most for each method` +
          `${report.speed_on ? ` on ${safe(report.speed_on)}` : ""}.`
        }
      />
    </Section>
  );
}
