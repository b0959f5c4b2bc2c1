// SPDX-License-Identifier: MIT
// What the harness is worth: faults planted one at a time, and which part of it caught each.
import { useMemo, useState } from "preact/hooks";
import { Missing, Section } from "./parts.tsx";
import type { FullReport } from "./report.ts";
import { group_by, grouped, percent, plural, safe } from "./words.ts";

export function Kills({ report }: { report: FullReport }) {
  const matrix = report.kill_matrix;
  const detectors = useMemo(() => {
    const counts = new Map<string, number>();
    for (const row of matrix?.rows ?? []) for (const d of row.caught_by) counts.set(d, (counts.get(d) ?? 0) + 1);
    return [...counts].sort((x, y) => y[1] - x[1]);
  }, [report]);
  const [missed_only, set] = useState(false);
  if (!matrix)
    return (
      <Section id="faults" title="Planted faults">
        <Missing of="kill_matrix" report={report} />
      </Section>
    );
  const missed = matrix.mutants - matrix.caught - matrix.equivalent;
  const rows = missed_only ? matrix.rows.filter((r) => r.caught_by.length === 0) : matrix.rows;
  return (
    <Section
      id="faults"
      title="Planted faults"
      lead={
        "Faults planted one at a time into the solver, the referee and the harness, and what caught each; as last " +
        "measured with daylight mutants matrix, not in this run."
      }>
      <dl class="facts">
        <div>
          <dt>faults</dt>
          <dd>{grouped(matrix.mutants)}</dd>
        </div>
        <div>
          <dt>caught</dt>
          <dd>
            {grouped(matrix.caught)} <span class="soft">{percent(matrix.caught, matrix.mutants)}</span>
          </dd>
        </div>
        <div>
          <dt>argued equivalent</dt>
          <dd>{grouped(matrix.equivalent)}</dd>
        </div>
        <div>
          <dt>missed</dt>
          <dd class={missed > 0 ? "warn" : ""}>{grouped(missed)}</dd>
        </div>
      </dl>
      <table class="plain">
        <thead>
          <tr>
            <th>fault planted in</th>
            <th class="n">faults</th>
            <th class="n">caught</th>
            <th class="n">equivalent</th>
            <th class="n">missed</th>
            {detectors.map(([d]) => (
              <th class="n" key={d}>
                by {safe(d)}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {[...group_by(matrix.rows, (r) => r.file.split("/")[0]!)].map(([folder, of]) => {
            const caught = of.filter((r) => r.caught_by.length > 0).length,
              equivalent = of.filter((r) => r.caught_by.length === 0 && r.equivalent).length;
            return (
              <tr key={folder}>
                <td>{safe(folder)}/</td>
                <td class="n">{of.length}</td>
                <td class="n">{caught}</td>
                <td class="n">{equivalent}</td>
                <td class="n">{of.length - caught - equivalent}</td>
                {detectors.map(([d]) => (
                  <td class="n" key={d}>
                    {of.filter((r) => r.caught_by.includes(d)).length}
                  </td>
                ))}
              </tr>
            );
          })}
        </tbody>
      </table>
      <details class="print">
        <summary>Every fault</summary>
        <p>
          <label>
            <input type="checkbox" checked={missed_only} onChange={(e) => set(e.currentTarget.checked)} /> only those
            that nothing caught
          </label>{" "}
          <span class="soft">{plural(rows.length, "fault")}</span>
        </p>
        <table class="plain">
          <thead>
            <tr>
              <th class="n">#</th>
              <th>file</th>
              <th>fault</th>
              {detectors.map(([d]) => (
                <th key={d}>{safe(d)}</th>
              ))}
            </tr>
          </thead>
          <tbody>
            {rows.map((r) => (
              <tr key={r.mutant}>
                <td class="n">{r.mutant}</td>
                <td>{safe(r.file)}</td>
                <td class="wrap">
                  {safe(r.what)}
                  {r.equivalent && <span class="soft"> Equivalent: {safe(r.equivalent)}</span>}
                </td>
                {detectors.map(([d]) => (
                  <td key={d}>{r.caught_by.includes(d) ? "\u2713" : ""}</td>
                ))}
              </tr>
            ))}
          </tbody>
        </table>
      </details>
    </Section>
  );
}
