// SPDX-License-Identifier: MIT
// The causes, and every finding that was kept, filtered by a text and selections.
import { useMemo, useState } from "preact/hooks";
import { Section, Select } from "../parts/elements.tsx";
import { grouped, plural, safe, short } from "../parts/words.ts";
import { Causes, causeAddress } from "./causes.tsx";
import { Heads } from "./elements.tsx";
import { causesOf, facets, filtered, filterOf, queryOf, rowsOf, valuesOf } from "./filter.ts";
import type { Facet, Filter, Row } from "./filter.ts";
import type { FullReport } from "./report.ts";
import { kindLabel, severityLabels } from "./words.ts";

const facetLabels: Record<Facet, string> = {
  severity: "Severity",
  library: "Library",
  family: "Family",
  standing: "Since earlier runs",
};
const valueLabel = (value: string) => severityLabels[value] ?? kindLabel(safe(value));

const ofAll = (shown: number, all: number, one: string) =>
  shown === all ? plural(all, one) : `${grouped(shown)} of ${plural(all, one)}`;

const lead = (report: FullReport) =>
  `${grouped(report.findings_total)} in all. For each method, kind and family the first ten are kept as examples, ` +
  `and each later one that is worse. The margin of a wrong distance is its error over the size (r + h + r + h). The ` +
  `margin of any other finding is the signed distance between the solids over the size. Margins are lower bounds. ` +
  `Those beyond a claim come first, then those of ordinary size, then those wrong by more.`;

const rowsAtFirst = 100;

function FindingsTable({ rows }: { rows: Row[] }) {
  const [whole, show] = useState(false);
  return (
    <>
      <div class="scroll">
        <table class="plain findings">
          <Heads of={["n:#", "severity", "kind", "method", "family", "n:margin", "cause"]} />
          <tbody>
            {rows.slice(0, whole ? rows.length : rowsAtFirst).map(({ f }) => (
              <tr key={f.id}>
                <td class="n">
                  <a href={`#/finding/${f.id}`}>{f.id}</a>
                </td>
                <td class={f.severity === "contract" ? "bad" : ""}>{valueLabel(f.severity)}</td>
                <td>{safe(kindLabel(f.kind))}</td>
                <td>{safe(f.method)}</td>
                <td>{safe(kindLabel(f.family))}</td>
                <td class="n">{short(f.margin?.[0])}</td>
                <td>{f.bucket && <a href={causeAddress(f.bucket)}>{safe(f.bucket)}</a>}</td>
              </tr>
            ))}
          </tbody>
        </table>
      </div>
      {!whole && rows.length > rowsAtFirst && (
        <button type="button" onClick={() => show(true)}>
          Show all {plural(rows.length, "finding")}
        </button>
      )}
    </>
  );
}

export function Findings({
  report,
  query,
  remember,
}: {
  report: FullReport;
  query: URLSearchParams;
  remember: (query: string) => void;
}) {
  const allRows = useMemo(() => rowsOf(report), [report]),
    allCauses = useMemo(() => causesOf(report), [report]);
  const filter = filterOf(query),
    set = (part: Partial<Filter>) => remember(queryOf({ ...filter, ...part }));
  const rows = useMemo(() => filtered(allRows, filter), [allRows, queryOf(filter)]),
    causes = useMemo(() => filtered(allCauses, filter), [allCauses, queryOf(filter)]);
  if (allRows.length + allCauses.length === 0)
    return (
      <Section id="findings" title="All findings">
        <p class="ok">No method was wrong, and none failed.</p>
      </Section>
    );
  return (
    <Section id="findings" title="All findings" lead={lead(report)}>
      <p class="tools filters">
        <input
          type="search"
          placeholder="Words to find"
          aria-label="Text of causes and findings"
          value={filter.text}
          onInput={(event) => set({ text: event.currentTarget.value })}
        />
        {facets.map((facet) => {
          const values = [...new Set([...valuesOf(allCauses, facet), ...valuesOf(allRows, facet)])].sort();
          return values.length === 0 ? null : (
            <Select
              label={facetLabels[facet]}
              value={filter[facet]}
              onChange={(value) => set({ [facet]: value })}
              options={[["", "all"], ...values.map((v) => [v, valueLabel(v)] as const)]}
              key={facet}
            />
          );
        })}
        <button type="button" disabled={queryOf(filter) === ""} onClick={() => remember("")}>
          Clear
        </button>
        <span role="status">
          {ofAll(rows.length, allRows.length, "finding")}
          {allCauses.length > 0 && `, ${ofAll(causes.length, allCauses.length, "cause")}`}
        </span>
      </p>
      {causes.length > 0 && <Causes causes={causes} />}
      {rows.length > 0 && <FindingsTable rows={rows} key={queryOf(filter)} />}
    </Section>
  );
}
