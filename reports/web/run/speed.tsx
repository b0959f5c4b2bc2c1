// SPDX-License-Identifier: MIT
// How fast and how right, in one picture.
import { useCallback, useMemo, useState } from "preact/hooks";
import { Figure, Section, Select } from "../parts/elements.tsx";
import { screen } from "../parts/plot.ts";
import { safe, time } from "../parts/words.ts";
import { Missing } from "./elements.tsx";
import { palette, pareto, speedPlot } from "./plots.ts";
import type { FullReport } from "./report.ts";
import { kindLabel, library } from "./words.ts";

const toFindings = (method: string) => `#/findings?${new URLSearchParams({ method })}`;
const queryLabels: Record<string, string> = {
  verdict: "yes or no, one pair",
  batch: "yes or no, many pairs at once",
  certificate: "with a proof",
  distance: "signed distance",
};

export function Speed({ report }: { report: FullReport }) {
  const families = useMemo(
    () =>
      [...new Set(report.speed.map((p) => p.family))].sort(
        (x, y) => Number(y === "all") - Number(x === "all") || (x < y ? -1 : 1),
      ),
    [report],
  );
  const queries = useMemo(() => [...new Set(report.speed.map((p) => p.query))], [report]);
  const [family, choose] = useState(families[0] ?? "all");
  const [query, ask] = useState<string>(queries.includes("verdict") ? "verdict" : (queries[0] ?? "verdict"));
  const points = useMemo(
    () => report.speed.filter((p) => p.family === family && p.query === query),
    [report, family, query],
  );
  const draw = useCallback(
    (width: number) => speedPlot(points, { width, theme: screen, link: toFindings }),
    [points],
  );
  const front = pareto(points);
  return (
    <Section
      id="speed"
      title="Speed against accuracy"
      lead={
        report.speed.length
          ? "Accuracy is a margin: the method was right on every pair with at least that signed distance over size. " +
            "A line joins the settings of one method. A click on a point shows the findings of its method."
          : undefined
      }>
      {report.speed.length === 0 ? (
        <Missing of="speed" report={report} />
      ) : (
        <>
          <p class="tools">
            <Select
              label="Pairs"
              value={family}
              onChange={choose}
              options={families.map((f) => [f, f === "all" ? "all families together" : kindLabel(f)] as const)}
            />
            <Select
              label="Question"
              value={query}
              onChange={ask}
              options={queries.map((q) => [q, queryLabels[q] ?? q] as const)}
            />
            <span class="legend" aria-hidden="true">
              {[
                ...palette(
                  points.map((p) => library(p.method)),
                  screen,
                ),
              ].map(([name, colour]) => (
                <span key={name}>
                  <i style={{ background: colour }} />
                  {safe(name)}
                </span>
              ))}
            </span>
          </p>
          {points.length === 0 ? (
            <p class="missing">No method was asked this question.</p>
          ) : (
            <>
              <Figure
                draw={draw}
                height={420}
                label="Correct digits against time a pair"
                caption={
                  <>
                    Dashed: no method is both faster and more accurate than{" "}
                    {front.map((p, i) => (
                      <>
                        {i > 0 && ", "}
                        <a href={toFindings(p.method)}>{safe(p.method)}</a> ({time(p.ns)})
                      </>
                    ))}
                    .
                  </>
                }
              />
            </>
          )}
        </>
      )}
    </Section>
  );
}
