// SPDX-License-Identifier: MIT
// The quality of our own tests: planted faults, one at a time, and the tests that detect each.
import { useMemo, useState } from "preact/hooks";
import { Section } from "../parts/elements.tsx";
import { groupBy, grouped, percent, plural, safe } from "../parts/words.ts";
import { Fact, Heads } from "./elements.tsx";
import type { FullReport } from "./report.ts";

const told = "The test that detected the fault.";

export function Kills({ report }: { report: FullReport }) {
  const matrix = report.kill_matrix;
  const detectors = useMemo(() => {
    const counts = new Map<string, number>();
    for (const row of matrix?.rows ?? []) for (const d of row.caught_by) counts.set(d, (counts.get(d) ?? 0) + 1);
    return [...counts].sort((x, y) => y[1] - x[1]);
  }, [report]);
  const tests = detectors.map(([d]) => safe(d));
  const [missedOnly, set] = useState(false);
  if (!matrix) return null;
  const missed = matrix.mutants - matrix.caught - matrix.equivalent;
  const rows = missedOnly ? matrix.rows.filter((r) => r.caught_by.length === 0) : matrix.rows;
  return (
    <Section
      id="faults"
      title="Planted faults"
      lead={
        "The quality of our own tests. We plant one fault at a time in the solver, the referee or the comparison, " +
        "and record the tests that detect it. daylight mutants matrix measured this, not this run."
      }>
      <dl class="facts">
        <Fact label="faults">{grouped(matrix.mutants)}</Fact>
        <Fact label="caught">
          {grouped(matrix.caught)} <span class="soft">{percent(matrix.caught, matrix.mutants)}</span>
        </Fact>
        <Fact label="changes nothing">{grouped(matrix.equivalent)}</Fact>
        <Fact label="missed" kind={missed > 0 ? "warn" : ""}>
          {grouped(missed)}
        </Fact>
      </dl>
      <div class="scroll">
        <table class="plain">
          <Heads
            of={["put into", "n:faults", "n:caught", "n:changes nothing", "n:missed", ...tests.map((d) => `n:by ${d}`)]}
            told={told}
          />
          <tbody>
            {[...groupBy(matrix.rows, (r) => r.file.split("/")[0]!)].map(([folder, of]) => {
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
      </div>
      <details>
        <summary>Every fault</summary>
        <p>
          <label>
            <input type="checkbox" checked={missedOnly} onChange={(e) => set(e.currentTarget.checked)} /> only faults
            that no test detected
          </label>{" "}
          <span class="soft">{plural(rows.length, "fault")}</span>
        </p>
        <div class="scroll">
          <table class="plain">
            <Heads of={["#", "file", "fault", ...tests]} told={told} />
            <tbody>
              {rows.map((r) => (
                <tr key={r.mutant}>
                  <td class="n">{r.mutant}</td>
                  <td>{safe(r.file)}</td>
                  <td class="wrap">
                    {safe(r.what)}
                    {r.equivalent && <span class="soft"> Changes nothing: {safe(r.equivalent)}</span>}
                  </td>
                  {detectors.map(([d]) => (
                    <td key={d}>{r.caught_by.includes(d) ? "\u2713" : ""}</td>
                  ))}
                </tr>
              ))}
            </tbody>
          </table>
        </div>
      </details>
    </Section>
  );
}
