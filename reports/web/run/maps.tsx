// SPDX-License-Identifier: MIT
// Where in the space of pairs a method fails, one large, and a small map of each library.
import { useCallback, useMemo, useState } from "preact/hooks";
import { Figure, Section, Select } from "../parts/elements.tsx";
import { screen } from "../parts/plot.ts";
import { grouped, percent, safe } from "../parts/words.ts";
import type { FailureMap } from "./data.ts";
import { ShareLegend } from "./elements.tsx";
import { mapColours, mapPlot, onlyHere, withinOf, wrongOf, type Wrongness } from "./map_plot.ts";
import { inRunOrder, type FullReport } from "./report.ts";
import { firstOfEach } from "./series.ts";
import { library } from "./words.ts";

const planes = [
  ["angle-margin", "Angle of the axes and margin"],
  ["aspect-margin", "Aspect and margin"],
  ["scale-offset", "Scale and offset"],
] as const;
type Count = Wrongness | "only";
const kinds: readonly (readonly [Count, string])[] = [
  ["all", "wrong or failed"],
  ["only", "only this library is wrong"],
  ["wrong_disjoint", "wrongly reported disjoint"],
  ["wrong_intersecting", "wrongly reported intersecting"],
  ["failed", "failed"],
  ["undecided", "undecided"],
  ["declined", "declined"],
];

function total(map: FailureMap, what: Wrongness) {
  const sum = (count: (c: FailureMap["cells"][number]) => number) => map.cells.reduce((n, c) => n + count(c), 0);
  const within = sum((c) => withinOf(c, what));
  return { beyond: sum((c) => wrongOf(c, what)) - within, within, asked: sum((c) => c.asked) };
}

function formatTotal(map: FailureMap, what: Wrongness) {
  const { beyond, within, asked } = total(map, what);
  const told = (count: number) => (count === 0 ? "0" : `${grouped(count)} (${percent(count, asked)})`);
  if (!["all", "wrong_disjoint", "wrong_intersecting"].includes(what)) return `${told(beyond)} of ${grouped(asked)}`;
  const failed = what === "all" ? " or failed" : "";
  return `${told(beyond)} beyond its claim${failed}, ${told(within)} within it, of ${grouped(asked)}`;
}

function Large({ map, what }: { map: FailureMap; what: Wrongness }) {
  const draw = useCallback(
    (width: number) => mapPlot(map, what, { width, theme: screen, linkFinding: (id) => `#/finding/${id}` }),
    [map, what],
  );
  return (
    <Figure
      draw={draw}
      height={86 + map.y.labels.length * 17}
      label={`${map.method}, ${map.plane}`}
      caption={formatTotal(map, what)}
    />
  );
}

/** The same without words, to choose from; where no pair was, nothing is drawn. */
interface Choice {
  map: FailureMap;
  what: Wrongness;
  chosen: boolean;
  choose: () => void;
}
function Small({ map, what, chosen, choose }: Choice) {
  const [wide, high] = [map.x.labels.length, map.y.labels.length];
  return (
    <button type="button" class="mini" aria-pressed={chosen} onClick={choose}>
      {safe(library(map.method))}
      <svg viewBox={`0 0 ${wide} ${high}`} aria-hidden="true" preserveAspectRatio="none" height={6 * high}>
        {map.cells.map((c) => {
          const { fill, edge } = mapColours(c, what, screen);
          return (
            <rect
              class={edge ? "" : "ground"}
              x={c.x + 0.05}
              y={high - 1 - c.y + 0.05}
              width={0.9}
              height={0.9}
              fill={fill}
              stroke={edge ?? "none"}
              vector-effect="non-scaling-stroke"
              stroke-width={0.8}
              key={`${c.x} ${c.y}`}
            />
          );
        })}
      </svg>
    </button>
  );
}

export function Maps({ report }: { report: FullReport }) {
  const methods = useMemo(() => inRunOrder(report, report.maps), [report]);
  const [method, choose] = useState(methods[0] ?? "");
  const [plane, turn] = useState<string>(planes[0][0]);
  const [count, set] = useState<Count>("all");
  const what = count === "only" ? "all" : count;
  const maps = useMemo(() => {
    const of = report.maps.filter((m) => m.plane === plane);
    return count === "only" ? of.map((m) => onlyHere(m, of)) : of;
  }, [report, plane, count]);
  if (methods.length === 0) return null;
  const large = maps.find((m) => m.method === method);
  const minis = firstOfEach(methods).flatMap((name) => maps.filter((m) => m.method === name));
  return (
    <Section
      id="maps"
      title="Failure maps"
      lead={
        "The share of wrong answers of a method, by properties of the pair. " +
        "If any answer of a cell is wrong beyond the claim, its share counts only those. " +
        "A cell with a dot leads to a case."
      }>
      <p class="tools">
        <Select label="Plane" value={plane} onChange={turn} options={planes} />
        <Select label="Count" value={count} onChange={(w) => set(w as Count)} options={kinds} />
        <Select label="Method" value={method} onChange={choose} options={methods.map((m) => [m, m] as const)} />
      </p>
      <p class="legend" aria-hidden="true">
        <i style={{ background: screen.heat[3] }} /> beyond the claim or failed
        <i style={{ background: screen.within[3] }} /> within the claim
        <i style={{ background: screen.unanswered[3] }} /> undecided or declined
        <i style={{ background: "var(--clean)" }} /> none <i class="blank">∕</i>
        {count === "only" ? "not visited, or another library is wrong here too" : "not visited"}. <ShareLegend />
      </p>
      <div class="maps">
        <div>
          <h3>{safe(method)}</h3>
          {large ? <Large map={large} what={what} /> : <p class="missing">Not counted.</p>}
        </div>
        <div>
          <h3>One method of each library</h3>
          <div class="minis">
            {minis.map((map) => (
              <Small
                map={map}
                what={what}
                chosen={map.method === method}
                choose={() => choose(map.method)}
                key={map.method}
              />
            ))}
          </div>
        </div>
      </div>
    </Section>
  );
}
