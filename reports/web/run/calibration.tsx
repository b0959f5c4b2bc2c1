// SPDX-License-Identifier: MIT
// The share of wrong answers as margins shrink, compared with the claim, and the cost of an answer.
import { useCallback, useMemo, useState } from "preact/hooks";
import { Figure, Section, Select } from "../parts/elements.tsx";
import { screen } from "../parts/plot.ts";
import { plural, safe } from "../parts/words.ts";
import { calibrationPlot, costPlot } from "./margin_plots.ts";
import { inRunOrder, type FullReport } from "./report.ts";
import { firstOfEach, seriesOf, shownCap } from "./series.ts";
import { formatClaim, kindLabel, claimOrigin } from "./words.ts";

function Chooser({
  methods,
  chosen,
  set,
}: {
  methods: string[];
  chosen: string[];
  set: (chosen: string[]) => void;
}) {
  const { colour } = seriesOf(chosen, screen);
  const others = methods.filter((m) => !chosen.includes(m));
  return (
    <div class="chips plain-chips" role="group" aria-label="Methods shown">
      {chosen.map((m) => (
        <button
          type="button"
          class="chip"
          title="Leave it out"
          style={{ background: colour({ method: m }), borderColor: colour({ method: m }), color: "var(--bg)" }}
          onClick={() => set(chosen.filter((c) => c !== m))}
          key={m}>
          {safe(m)} <span aria-hidden="true">×</span>
        </button>
      ))}
      <select
        value=""
        aria-label="Show another method"
        disabled={others.length === 0}
        onChange={(event) => {
          set([...chosen, event.currentTarget.value].slice(-shownCap));
          event.currentTarget.value = "";
        }}>
        <option value="">show another…</option>
        {others.map((m) => (
          <option value={m} key={m}>
            {m}
          </option>
        ))}
      </select>
    </div>
  );
}

export function Calibration({ report }: { report: FullReport }) {
  const methods = useMemo(() => inRunOrder(report, report.honesty), [report]);
  const families = useMemo(
    () =>
      [...new Set(report.honesty.map((h) => h.family))].sort((x, y) =>
        x === null ? -1 : y === null ? 1 : x < y ? -1 : 1,
      ),
    [report],
  );
  const [chosen, set] = useState(() => firstOfEach(methods));
  const [family, choose] = useState(families[0] ?? "");
  const rows = useMemo(
    () => chosen.flatMap((m) => report.honesty.filter((h) => h.method === m && (h.family ?? "") === (family ?? ""))),
    [report, chosen, family],
  );
  const draw = useCallback((width: number) => calibrationPlot(rows, { width, theme: screen }), [rows]);
  const count = (of: (b: (typeof rows)[number]["bins"][number]) => number) =>
    rows.reduce((n, h) => n + h.bins.reduce((k, b) => k + of(b), 0), 0);
  if (methods.length === 0) return null;
  const declined = count((b) => b.declined ?? 0),
    answers = count((b) => b.asked) - declined;
  return (
    <Section
      id="calibration"
      title="Calibration"
      lead={
        "The share of wrong answers as the margin shrinks. A method that claims to be right above some " +
        "margin must have no wrong answer left of it. An open mark means no wrong answer, and bars are 95 % confidence."
      }>
      {families.length > 1 && (
        <p class="tools">
          <Select
            label="Pairs"
            value={family ?? ""}
            onChange={choose}
            options={families.map((f) => [f ?? "", f === null ? "all families together" : kindLabel(f)] as const)}
          />
        </p>
      )}
      <Chooser methods={methods} chosen={chosen} set={set} />
      {rows.length > 0 && (
        <Figure
          draw={draw}
          height={330}
          label="Share of wrong answers against margin"
          caption={
            <>
              {plural(answers, "answer")}
              {declined > 0 && `; ${plural(declined, "pair")} declined`}.{" "}
              {chosen.map((m) => {
                const claim = report.methods.find((r) => r.name === m)?.claim;
                return claim ? (
                  <span key={m}>
                    {safe(m)}: {formatClaim(claim)}, {claimOrigin(claim)}.{" "}
                  </span>
                ) : null;
              })}
            </>
          }
        />
      )}
    </Section>
  );
}

export function Cost({ report }: { report: FullReport }) {
  const methods = useMemo(() => inRunOrder(report, report.cost), [report]);
  const [chosen, set] = useState(() => firstOfEach(methods));
  const points = useMemo(() => chosen.flatMap((m) => report.cost.filter((c) => c.method === m)), [report, chosen]);
  const draw = useCallback((width: number) => costPlot(points, { width, theme: screen }), [points]);
  if (methods.length === 0) return null;
  return (
    <>
      <h3>Cost near touching</h3>
      <Chooser methods={methods} chosen={chosen} set={set} />
      {points.length > 0 && (
        <Figure
          draw={draw}
          height={330}
          label="Time a pair against margin"
          caption={
            "The time for an answer as the margin shrinks. Half of the pairs are below the line, 99 of 100 are below " +
            "the top of the band, and no pair is above the marks."
          }
        />
      )}
    </>
  );
}
