// SPDX-License-Identifier: MIT
// How fast and how right, in one picture.
import { useCallback, useMemo, useState } from "preact/hooks";
import { Figure, Section, Select } from "../parts/elements.tsx";
import { screen } from "../parts/plot.ts";
import { grouped, safe, time } from "../parts/words.ts";
import { claimedDigits, type FullReport } from "./report.ts";
import { bestOfEach, pareto, speedPlot } from "./speed_plot.ts";
import { kindLabel, library } from "./words.ts";

const toFindings = (name: string) => `#/findings?${new URLSearchParams({ library: name })}`;
const queryLabels: Record<string, string> = {
  verdict: "yes or no, one pair",
  batch: "yes or no, many pairs at once",
  certificate: "with a proof",
};

export function Speed({ report }: { report: FullReport }) {
  const speed = useMemo(() => report.speed.filter((p) => p.query in queryLabels), [report]);
  const families = useMemo(
    () =>
      [...new Set(speed.map((p) => p.family))].sort(
        (x, y) => Number(y === "all") - Number(x === "all") || (x < y ? -1 : 1),
      ),
    [speed],
  );
  const queries = useMemo(() => [...new Set(speed.map((p) => p.query))], [speed]);
  const [family, choose] = useState(families[0] ?? "all");
  const [query, ask] = useState<string>(queries.includes("verdict") ? "verdict" : (queries[0] ?? "verdict"));
  const points = useMemo(
    () => speed.filter((p) => p.family === family && p.query === query),
    [speed, family, query],
  );
  const draw = useCallback(
    (width: number) => speedPlot(points, { width, theme: screen, link: toFindings }, claimedDigits(report)),
    [points],
  );
  const front = pareto(bestOfEach(points.filter((p) => p.digits !== null)));
  if (speed.length === 0) return null;
  return (
    <Section
      id="speed"
      title="Speed against accuracy"
      lead={
        "One mark for each library, at its most accurate setting. Accuracy is a margin: the method was right about " +
        "yes or no on every pair with a signed distance of at least that part of the size. It says nothing about the " +
        "error of distances."
      }>
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
          </p>
          {points.length === 0 ? (
            <p class="missing">No method was asked this question.</p>
          ) : (
            <Figure
              draw={draw}
              height={420}
              label="The margin down to which a library is right, against time a pair"
              caption={
                <>
                  A filled mark is the accuracy that the answers show with 95 % confidence, and the hollow mark above it
                  is the accuracy that was observed. A thin line joins the settings of one method, and the grey band is
                  what engines claim. No library is both faster and more accurate than{" "}
                  {front.map((p, i) => (
                    <>
                      {i > 0 && ", "}
                      <a href={toFindings(library(p.method))}>{safe(library(p.method))}</a> ({time(p.ns)},{" "}
                      {safe(p.method)})
                    </>
                  ))}
                  . {grouped(Math.max(...points.map((p) => p.asked)))} pairs at most for each method
                  {report.speed_on && ` on ${safe(report.speed_on)}`}.
                </>
              }
            />
          )}
        </>
    </Section>
  );
}
