// SPDX-License-Identifier: MIT
// How the time and the pairs grow with the number of cylinders, on logarithmic scales: a straight line is a power.
import * as Plot from "@observablehq/plot";
import { power_law, total_ms, type GrowthRow } from "./crowd.ts";
import { common, decades, time_tick, type Options } from "./plots.ts";
import { grouped, time } from "./words.ts";

export interface Line {
  name: string;
  colour: string;
  of: (row: GrowthRow) => number;
  strong?: boolean; // with the line of its power beside it
}

export const time_lines = (o: Pick<Options, "theme">): Line[] => [
  { name: "in all", colour: o.theme.own, of: (row) => 1e6 * total_ms(row.cpu_ms), strong: true },
  { name: "tree of boxes", colour: o.theme.series[0]!, of: (row) => 1e6 * row.cpu_ms.tree },
  { name: "models", colour: o.theme.series[3]!, of: (row) => 1e6 * row.cpu_ms.prepare },
  { name: "answers", colour: o.theme.series[1]!, of: (row) => 1e6 * row.cpu_ms.ladder },
];
export const pair_lines = (o: Pick<Options, "theme">): Line[] => [
  { name: "boxes meet", colour: o.theme.series[0]!, of: (row) => row.candidates, strong: true },
  { name: "within", colour: o.theme.series[1]!, of: (row) => row.within },
];

export const height = 300;
const left = 72,
  right = 124, // for the names at the ends of the lines
  top = 22,
  bottom = 42;
/** Names at the ends are so far apart at least, in pixels. */
const name_height = 13;

/** Where the names stand: beside the last points, moved apart where they would lie on each other. */
function named(lines: Line[], last: GrowthRow, y: (v: number) => number) {
  const names = lines
    .map((line) => ({ line, value: line.of(last), at: y(line.of(last)) }))
    .sort((p, q) => p.at - q.at);
  for (let i = 1; i < names.length; ++i) names[i]!.at = Math.max(names[i]!.at, names[i - 1]!.at + name_height);
  return names.map(({ line, value, at }) => ({ line, value, dy: at - y(value) }));
}

export function growth_plot(
  rows: GrowthRow[],
  lines: Line[],
  o: Options,
  { label, tick, words }: { label: string; tick: (v: number) => string; words: (v: number) => string },
): Element {
  const shown = lines.filter((line) => rows.some((row) => line.of(row) > 0));
  const points = shown.flatMap((line) =>
    rows.filter((row) => line.of(row) > 0).map((row) => ({ line, n: row.cylinders, value: line.of(row) })),
  );
  const numbers = rows.map((row) => row.cylinders),
    values = points.map((p) => p.value);
  const domain = { x: [Math.min(...numbers) / 1.3, Math.max(...numbers) * 1.3] as const };
  const powers = decades(numbers).filter((t) => t >= domain.x[0] && t <= domain.x[1]);
  const ends = decades(values),
    low = ends[0]!,
    high = Math.max(ends[ends.length - 1]!, 10 * low);
  const y = (v: number) => height - bottom - (Math.log(v / low) / Math.log(high / low)) * (height - top - bottom);
  const fits = shown.flatMap((line) => {
    const law = line.strong ? power_law(rows.map((row) => [row.cylinders, line.of(row)])) : null;
    return law === null
      ? []
      : [domain.x[0], numbers[numbers.length - 1]!].map((n) => ({ line, n, value: law.factor * n ** law.exponent, exponent: law.exponent }));
  });
  const exponent_of = (line: Line) => {
    const fit = fits.find((p) => p.line === line);
    return fit && `: n^${fit.exponent.toFixed(2)}`;
  };
  return Plot.plot(
    common(o, height, {
      marginLeft: left,
      marginRight: right,
      marginTop: top,
      marginBottom: bottom,
      x: {
        type: "log",
        domain: domain.x,
        label: "cylinders \u2192",
        labelAnchor: "center",
        ticks: powers.length > 1 ? powers : numbers,
        tickFormat: grouped,
        grid: true,
      },
      y: {
        type: "log",
        domain: [low, high],
        label: `\u2191 ${label}`,
        ticks: decades([low, high]),
        tickFormat: tick,
        grid: true,
      },
      color: { type: "identity" },
      marks: [
        Plot.line(points, {
          x: "n",
          y: "value",
          z: (p: { line: Line }) => p.line.name,
          stroke: (p: { line: Line }) => p.line.colour,
          strokeWidth: (p: { line: Line }) => (p.line.strong ? 2.2 : 1.3),
        }),
        Plot.line(fits, {
          x: "n",
          y: "value",
          z: (p: { line: Line }) => p.line.name,
          stroke: o.theme.fg,
          strokeDasharray: "5 4",
          strokeWidth: 1,
        }),
        Plot.dot(points, {
          x: "n",
          y: "value",
          fill: (p: { line: Line }) => p.line.colour,
          stroke: o.theme.bg,
          strokeWidth: 0.8,
          r: (p: { line: Line }) => (p.line.strong ? 4.5 : 3.2),
          ariaLabel: (p: { line: Line; n: number; value: number }) =>
            `${p.line.name}, ${grouped(p.n)} cylinders: ${words(p.value)}`,
        }),
        ...named(shown, rows[rows.length - 1]!, y).map(({ line, value, dy }) =>
          Plot.text([{ n: numbers[numbers.length - 1]!, value }], {
            x: "n",
            y: "value",
            text: () => line.name + (exponent_of(line) ?? ""),
            dx: 9,
            dy,
            textAnchor: "start",
            fill: line.colour,
            fontWeight: line.strong ? 700 : 400,
          }),
        ),
        Plot.tip(
          points,
          Plot.pointer({
            x: "n",
            y: "value",
            title: (p: { line: Line; n: number; value: number }) =>
              `${p.line.name}\n${grouped(p.n)} cylinders: ${words(p.value)}`,
            fill: o.theme.bg,
            stroke: o.theme.line,
          }),
        ),
      ],
      r: { type: "identity" },
    }),
  );
}

export const time_plot = (rows: GrowthRow[], o: Options) =>
  growth_plot(rows, time_lines(o), o, { label: "CPU time", tick: time_tick, words: time });
export const pairs_plot = (rows: GrowthRow[], o: Options) =>
  growth_plot(rows, pair_lines(o), o, { label: "pairs", tick: grouped, words: grouped });
