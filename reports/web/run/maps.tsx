// SPDX-License-Identifier: MIT
// Where in the space of pairs a method fails, and our solver beside it.
import { useCallback, useMemo, useState } from "preact/hooks";
import { Figure, Section, Select } from "../parts/elements.tsx";
import { screen } from "../parts/plot.ts";
import { grouped, percent, safe } from "../parts/words.ts";
import type { FailureMap } from "./data.ts";
import { Missing } from "./elements.tsx";
import { mapPlot, withinOf, wrongOf, type Wrongness } from "./plots.ts";
import type { FullReport } from "./report.ts";

const planes = [
  ["angle-margin", "Angle of the axes and margin"],
  ["aspect-margin", "Aspect and margin"],
  ["scale-offset", "Scale and offset"],
] as const;
const kinds: readonly (readonly [Wrongness, string])[] = [
  ["all", "wrong or failed"],
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

function One({ map, what }: { map: FailureMap | undefined; what: Wrongness }) {
  const draw = useCallback(
    (width: number) => mapPlot(map!, what, { width, theme: screen, linkFinding: (id) => `#/finding/${id}` }),
    [map, what],
  );
  if (!map) return <p class="missing">Not counted.</p>;
  return (
    <Figure
      draw={draw}
      height={86 + map.y.labels.length * 17}
      label={`${map.method}, ${map.plane}`}
      caption={formatTotal(map, what)}
    />
  );
}

export function Maps({ report }: { report: FullReport }) {
  const methods = useMemo(() => [...new Set(report.maps.map((m) => m.method))], [report]);
  const own = report.methods.find((m) => m.own && methods.includes(m.name))?.name ?? methods[0] ?? "";
  const wrongs = (method: string) =>
    report.maps.filter((m) => m.method === method).reduce((n, m) => n + total(m, "all").beyond, 0);
  const worst = useMemo(
    () =>
      methods
        .filter((m) => m !== own)
        .map((m) => [wrongs(m), m] as const)
        .sort((x, y) => y[0] - x[0])[0]?.[1] ?? own,
    [report],
  );
  const [method, choose] = useState(worst);
  const [what, count] = useState<Wrongness>("all");
  const find = (name: string, plane: string) => report.maps.find((m) => m.method === name && m.plane === plane);
  return (
    <Section
      id="maps"
      title="Failure maps"
      lead={
        methods.length
          ? "The share of wrong answers of a method, by properties of the pair. A stronger colour is a larger share. " +
            "If any answer of a cell is wrong beyond the claim, its share counts only those. " +
            "A cell with a dot leads to a case."
          : undefined
      }>
      {methods.length === 0 ? (
        <Missing of="maps" report={report} />
      ) : (
        <>
          <p class="tools">
            <Select label="Method" value={method} onChange={choose} options={methods.map((m) => [m, m] as const)} />
            <Select label="Count" value={what} onChange={(w) => count(w as Wrongness)} options={kinds} />
            <span class="legend" aria-hidden="true">
              {(
                [
                  [screen.heat, "beyond the claim or failed"],
                  [screen.within, "within the claim"],
                  [screen.unanswered, "undecided or declined"],
                ] as const
              ).map(([shades, words]) => (
                <span key={words}>
                  {shades.map((background) => (
                    <i style={{ background }} key={background} />
                  ))}
                  {words}
                </span>
              ))}
              <i style={{ background: "var(--clean)" }} />
              none<i class="blank">∕</i>not visited; the five shades: a share below 1e−4, from 1e−4, 1e−3, 0.01, 0.1 on
            </span>
          </p>
          <div class="pairs-of">
            <h3>{safe(method)}</h3>
            <h3>{safe(own)}</h3>
            {planes.map(([plane, title]) => [
              <div key={plane}>
                <p class="soft">{title}</p>
                <One map={find(method, plane)} what={what} />
              </div>,
              <div key={`${plane} own`}>
                <p class="soft">{title}</p>
                <One map={find(own, plane)} what={what} />
              </div>,
            ])}
          </div>
        </>
      )}
    </Section>
  );
}
