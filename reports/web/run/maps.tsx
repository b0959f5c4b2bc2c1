// SPDX-License-Identifier: MIT
// The failure map of a method: a cell for each place in the space of pairs.
import * as Plot from "@observablehq/plot";
import { useCallback, useMemo, useState } from "preact/hooks";
import { Figure, Section, Select } from "../parts/elements.tsx";
import { cellColours, colours, common, tips, type Options, type Outcomes } from "../parts/plot.ts";
import { grouped, percent, safe } from "../parts/words.ts";
import type { FailureMap, MapCell, Report } from "./data.ts";
import { Legend } from "./elements.tsx";

const planes = [
  ["angle-margin", "Angle of the axes and margin"],
  ["aspect-margin", "Aspect and margin"],
  ["scale-offset", "Scale and offset"],
  ["margin-shapes", "Margin and shapes"],
] as const;

function outcomesOf(c: MapCell): Outcomes {
  const within = c.within_disjoint + c.within_intersecting;
  const bad = c.wrong_disjoint + c.wrong_intersecting - within + c.failed;
  return { asked: c.asked, bad, within, undecided: c.undecided + c.declined };
}

const described = [
  ["wrong_disjoint", "wrongly reported disjoint"],
  ["wrong_intersecting", "wrongly reported intersecting"],
  ["failed", "failed"],
  ["undecided", "undecided"],
  ["declined", "declined"],
] as const;
const describeCell = ({ x, y }: FailureMap, c: MapCell) =>
  [
    `${x.title}: ${x.labels[c.x]}`,
    `${y.title}: ${y.labels[c.y]}`,
    `asked ${grouped(c.asked)}`,
    ...described
      .filter(([key]) => c[key] > 0)
      .map(([key, words]) => `${words} ${grouped(c[key])} (${percent(c[key], c.asked)})`),
    `within the claim ${grouped(outcomesOf(c).within)}`,
    ...(c.finding === undefined ? [] : ["click for a case of this cell"]),
  ].join("\n");

export function mapPlot(map: FailureMap, o: Options): Element {
  const visited = map.cells.filter((c) => c.asked > 0);
  const across = { type: "band", padding: 0.06, tickSize: 0 } as const;
  const longest = (labels: string[]) => 7 * Math.max(...labels.map((label) => label.length)),
    left = Math.max(74, longest(map.y.labels) + 34),
    skip = Math.max(1, Math.ceil((map.x.labels.length * (longest(map.x.labels) + 6)) / (o.width - left - 30)));
  const words = (c: MapCell) => describeCell(map, c),
    edgeOf = (c: MapCell) => cellColours(outcomesOf(c)).edge,
    link = (c: MapCell) => (c.finding === undefined ? null : o.link!(String(c.finding)));
  return Plot.plot(
    common(o, heightOf(map), {
      marginLeft: left,
      marginBottom: 44,
      x: {
        ...across,
        domain: map.x.labels.map((_, i) => i),
        tickFormat: (i: number) => (i % skip === 0 ? map.x.labels[i]! : ""),
        label: `${map.x.title} \u2192`,
      },
      y: {
        ...across,
        domain: map.y.labels.map((_, i) => i).reverse(),
        tickFormat: (i: number) => map.y.labels[i]!,
        label: `\u2191 ${map.y.title}`,
      },
      marks: [
        Plot.frame({ stroke: colours.line }),
        Plot.cell(visited, {
          x: "x",
          y: "y",
          fill: (c: MapCell) => cellColours(outcomesOf(c)).fill,
          stroke: (c: MapCell) => edgeOf(c) ?? colours.line,
          inset: 0.5,
          ...(o.link && { href: link, target: "_self" }),
          ariaLabel: words,
        }),
        Plot.dot(
          visited.filter((c) => edgeOf(c) !== null && c.finding !== undefined),
          { x: "x", y: "y", r: 1.3, fill: colours.fg, pointerEvents: "none" },
        ),
        ...tips(visited, o, words, { x: "x", y: "y", maxRadius: 14 }),
      ],
    }),
  );
}
const heightOf = (map: FailureMap) => 86 + map.y.labels.length * 17;

export function Maps({ report }: { report: Report }) {
  const methods = useMemo(() => [...new Set(report.maps.map((m) => m.method))], [report]);
  const failing = report.maps.find((m) => m.cells.some((c) => outcomesOf(c).bad > 0));
  const [method, choose] = useState(failing?.method ?? methods[0] ?? "");
  const [plane, turn] = useState<string>(planes[0][0]);
  const map = report.maps.find((m) => m.plane === plane && m.method === method);
  const draw = useCallback(
    (width: number) => mapPlot(map!, { width, link: (finding) => `#/finding/${finding}` }),
    [map],
  );
  if (methods.length === 0) return null;
  return (
    <Section
      id="maps"
      title="Failure maps"
      lead={
        "The share of wrong answers of a method, by properties of the pair. " +
        "If a cell has answers wrong beyond the claim, the share counts only them. " +
        "A cell with a dot leads to a case."
      }>
      <p class="tools">
        <Select label="Method" value={method} onChange={choose} options={methods.map((m) => [m, safe(m)])} />
        <Select label="Plane" value={plane} onChange={turn} options={planes} />
      </p>
      <Legend empty="no pairs" />
      {map ? (
        <Figure draw={draw} height={heightOf(map)} label={`${safe(method)}, ${plane}`} />
      ) : (
        <p class="missing">Not counted.</p>
      )}
    </Section>
  );
}
