// SPDX-License-Identifier: MIT
// The share of wrong answers as margins shrink, compared with the claim.
import { useCallback, useMemo, useState } from "preact/hooks";
import { Figure, Section, Select } from "../parts/elements.tsx";
import { screen } from "../parts/plot.ts";
import { plural, safe } from "../parts/words.ts";
import { calibrationPlot } from "./margin_plots.ts";
import { inRunOrder, type FullReport } from "./report.ts";
import { firstOfEach, seriesOf, shownCap } from "./series.ts";
import { claimOrigin, formatClaim, kindLabel, library } from "./words.ts";

export function Calibration({ report }: { report: FullReport }) {
  const methods = useMemo(() => inRunOrder(report, report.honesty), [report]);
  const families = [...new Set(report.honesty.map((h) => h.family ?? ""))].sort(),
    libraries = [...new Set(methods.map(library))];
  const [of, choose] = useState(""),
    [family, turn] = useState("");
  const shown = of === "" ? firstOfEach(methods) : methods.filter((m) => library(m) === of).slice(0, shownCap);
  const rows = useMemo(
    () => shown.flatMap((m) => report.honesty.filter((h) => h.method === m && (h.family ?? "") === family)),
    [report, of, family],
  );
  const draw = useCallback((width: number) => calibrationPlot(rows, { width, theme: screen }), [rows]);
  if (methods.length === 0) return null;
  const { colour } = seriesOf([...new Set(rows.map((h) => h.method))], screen),
    bins = rows.flatMap((h) => h.bins),
    declined = bins.reduce((n, b) => n + (b.declined ?? 0), 0),
    answers = bins.reduce((n, b) => n + b.asked, -declined);
  return (
    <Section
      id="calibration"
      title="Calibration"
      lead={
        "The share of wrong answers as the margin shrinks. A method that claims to be right above some " +
        "margin must have no wrong answer left of it. An open mark means no wrong answer, and bars are 95 % confidence."
      }>
      <p class="tools">
        <Select
          label="Methods"
          value={of}
          onChange={choose}
          options={[["", "one of each library"], ...libraries.map((name) => [name, safe(name)] as const)]}
        />
        <Select
          label="Pairs"
          value={family}
          onChange={turn}
          options={families.map((f) => [f, f === "" ? "all families together" : kindLabel(f)] as const)}
        />
      </p>
      <Figure
        draw={draw}
        height={330}
        label="Share of wrong answers against margin"
        caption={
          <>
            {plural(answers, "answer")}
            {declined > 0 && `; ${plural(declined, "pair")} declined`}.
          </>
        }
      />
      <ul class="keys">
        {rows.map(({ method }) => {
          const claim = report.methods.find((m) => m.name === method)?.claim;
          return (
            <li key={method}>
              <b style={{ color: colour({ method }) }}>{safe(method)}</b>
              {claim && `: ${formatClaim(claim)}, ${claimOrigin(claim)}`}
            </li>
          );
        })}
      </ul>
    </Section>
  );
}
