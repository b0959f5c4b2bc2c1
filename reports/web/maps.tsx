// SPDX-License-Identifier: MIT
// Where in the space of pairs a method fails, and our solver beside it.
import { useCallback, useMemo, useState } from "preact/hooks";
import type { FailureMap } from "./data.ts";
import { Figure, Missing, Section, Select } from "./parts.tsx";
import { map_plot, screen, wrong_of, type Wrongness } from "./plots.ts";
import type { FullReport } from "./report.ts";
import { grouped, percent, safe } from "./words.ts";

const planes = [
  ["angle-margin", "Angle of the axes and margin"],
  ["aspect-margin", "Aspect and margin"],
  ["scale-offset", "Scale and offset"],
] as const;
const kinds: readonly (readonly [Wrongness, string])[] = [
  ["all", "wrong or failed"],
  ["wrong_disjoint", "said disjoint wrongly"],
  ["wrong_intersecting", "said intersecting wrongly"],
  ["failed", "failed"],
  ["undecided", "undecided"],
];

function total(map: FailureMap, what: Wrongness) {
  return map.cells.reduce(([wrong, asked], c) => [wrong + wrong_of(c, what), asked + c.asked] as const, [
    0, 0,
  ] as readonly [number, number]);
}

function One({ map, what }: { map: FailureMap | undefined; what: Wrongness }) {
  const draw = useCallback(
    (width: number) => map_plot(map!, what, { width, theme: screen, link_finding: (id) => `#/finding/${id}` }),
    [map, what],
  );
  if (!map) return <p class="missing">Not counted.</p>;
  const [wrong, asked] = total(map, what);
  return (
    <Figure
      draw={draw}
      height={86 + map.y.labels.length * 17}
      label={`${map.method}, ${map.plane}`}
      caption={`${grouped(wrong)} of ${grouped(asked)} (${percent(wrong, asked)})`}
    />
  );
}

export function Maps({ report }: { report: FullReport }) {
  const methods = useMemo(() => [...new Set(report.maps.map((m) => m.method))], [report]);
  const own = report.methods.find((m) => m.own && methods.includes(m.name))?.name ?? methods[0] ?? "";
  const wrongs = (method: string) =>
    report.maps.filter((m) => m.method === method).reduce((n, m) => n + total(m, "all")[0], 0);
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
          ? "How often a method was wrong, by what the pair is like; the stronger the colour, the larger the share. " +
            "A dot marks a cell that leads to a case."
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
              {["<1e\u22124", "1e\u22124", "1e\u22123", "1e\u22122", "\u22650.1"].map((words, i) => (
                <span key={words}>
                  <i style={{ background: screen.heat[i] }} />
                  {words}
                </span>
              ))}
              <i style={{ background: "var(--clean)" }} />
              none wrong<i class="blank">∕</i>not visited
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
