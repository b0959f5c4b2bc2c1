// SPDX-License-Identifier: MIT
// What a model costs against how often it is wrong, accepted alone for every pair; and the recommended set.
import * as Plot from "@observablehq/plot";
import { common, decades, tips, type Options } from "../parts/plot.ts";
import { grouped, plural, short, time } from "../parts/words.ts";
import { modelColour, type Model, type Study } from "./study.ts";

interface Point {
  name: string;
  model: Model | null;
  ns: number;
  wrong: number;
  words: string;
}

function pointsOf(study: Study): Point[] {
  const ns = study.ns_per_configuration,
    samples = study.pairs.reduce((n, pair) => n + pair.samples, 0);
  const worst = (alarm: number, missed: number) => [
    ...(alarm > 0 ? [`false alarms up to ${short(alarm)} beyond the clearance`] : []),
    ...(missed > 0 ? [`missed down to ${short(missed)} below it`] : []),
  ];
  const point = (name: string, model: Model | null, cost: number, wrong: number, more: string[]): Point => ({
    name,
    model,
    ns: cost,
    wrong,
    words: [
      `${name}: ${time(cost)} a configuration`,
      `${wrong === 0 ? "no wrong answer" : plural(wrong, "wrong answer")} in ${grouped(samples)} samples`,
      ...more,
    ].join("\n"),
  });
  return [
    ...study.models.map((m) =>
      point(`${m.model} alone`, m.model, ns.alone[m.model], m.wrong, worst(m.false_alarm, m.missed)),
    ),
    point(
      "recommended",
      null,
      ns.recommended,
      study.pairs.reduce((n, pair) => n + pair.recommended_wrong, 0),
      study.words.forgiven ? [study.words.forgiven] : [],
    ),
  ];
}

const height = 340,
  left = 64,
  right = 34;
/** The width of a letter of a name, about, in pixels; and the height of a line. */
const letter = 6.2,
  lineHeight = 13;

/** A name above its point, higher where another one is in its way. */
function named(points: Point[], x: (p: Point) => number, y: (p: Point) => number) {
  const taken: { left: number; right: number; y: number }[] = [];
  return [...points]
    .sort((p, q) => x(p) - x(q))
    .map((p) => {
      const wide = (p.name.length * letter) / 2 + 3;
      let dy = -12;
      const box = () => ({ left: x(p) - wide, right: x(p) + wide, y: y(p) + dy });
      while (taken.some((t) => t.left < box().right && t.right > box().left && Math.abs(t.y - box().y) < lineHeight))
        dy -= lineHeight;
      taken.push(box());
      return { p, dy };
    });
}

/** None wrong stands on the lowest line, a decade below one. */
export function costPlotOfStudy(study: Study, o: Options): Element {
  const points = pointsOf(study),
    costs = points.map((p) => p.ns);
  const none = 0.1,
    most = Math.max(10, ...points.map((p) => p.wrong)),
    low = Math.min(...costs) / 2.2,
    high = Math.max(...costs) * 2.2,
    top = most * 4;
  const wrong = (p: Point) => Math.max(none, p.wrong);
  const x = (p: Point) => left + (Math.log(p.ns / low) / Math.log(high / low)) * (o.width - left - right);
  const y = (p: Point) => height - 42 - (Math.log(wrong(p) / none) / Math.log(top / none)) * (height - 64);
  const fill = (p: Point) => (p.model ? `var(${modelColour[p.model]})` : o.theme.own);
  const marks = named(points, x, y);
  return Plot.plot(
    common(o, height, {
      marginLeft: left,
      marginRight: right,
      x: {
        type: "log",
        domain: [low, high],
        label: "time per configuration, all pairs \u2192",
        ticks: decades(costs).filter((t) => t >= low && t <= high),
        tickFormat: time,
        grid: true,
      },
      y: {
        type: "log",
        domain: [none, top],
        label: "\u2191 wrong answers",
        ticks: [none, ...decades([1, most]).filter((t) => t <= top)],
        tickFormat: (v: number) => (v === none ? "none" : grouped(v)),
        grid: true,
      },
      marks: [
        Plot.ruleY([none], { stroke: o.theme.own, strokeWidth: 2, strokeOpacity: 0.5 }),
        ...marks
          .filter(({ dy }) => dy < -20)
          .map(({ p, dy }) =>
            Plot.link([p], {
              x1: "ns",
              x2: "ns",
              y1: wrong,
              y2: () => none * Math.exp(((height - 42 - y(p) - dy - 8) / (height - 64)) * Math.log(top / none)),
              stroke: o.theme.soft,
              strokeWidth: 0.7,
            }),
          ),
        Plot.dot(points, {
          x: "ns",
          y: wrong,
          fill,
          stroke: o.theme.bg,
          strokeWidth: 0.8,
          r: (p: Point) => (p.model ? 5.5 : 8),
          symbol: (p: Point) => (p.model ? "circle" : "star"),
          ariaLabel: (p: Point) => p.words,
        }),
        ...marks.map(({ p, dy }) =>
          Plot.text([p], {
            x: "ns",
            y: wrong,
            text: "name",
            dy,
            fill: p.model ? o.theme.fg : o.theme.own,
            fontWeight: p.model ? 400 : 700,
            stroke: o.theme.bg,
            strokeWidth: 3,
            paintOrder: "stroke",
          }),
        ),
        ...tips(points, o, (p: Point) => p.words, { x: "ns", y: wrong }),
      ],
      r: { type: "identity" },
    }),
  );
}
