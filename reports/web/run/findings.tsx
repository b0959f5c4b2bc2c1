// SPDX-License-Identifier: MIT
// The causes, and every finding that was kept: filtered by a search, sorted by columns, kept in the address.
import { useEffect, useLayoutEffect, useMemo, useState } from "preact/hooks";
import { Section } from "../parts/elements.tsx";
import { save } from "../parts/save.ts";
import { VirtualTable, type ColumnOf } from "../parts/table.tsx";
import { grouped, plural, safe, short } from "../parts/words.ts";
import { remember, type Address } from "./address.ts";
import { Causes } from "./causes.tsx";
import { csvOf, jsonOf } from "./files.ts";
import {
  causesOf,
  chipCounts,
  columns,
  filtered,
  filteredCauses,
  loneCounts,
  queryOf,
  rowsOf,
  sorted,
  sortedCauses,
  viewOf,
  worstFirst,
  type Column,
  type Order,
  type Row,
  type View,
} from "./filter.ts";
import { about } from "./glossary.ts";
import type { FullReport } from "./report.ts";
import { Search } from "./search.tsx";
import { kindLabel, severityLabels } from "./words.ts";

const rowHeight = 25,
  tableRows = 22;
const titles: Record<Column, string> = {
  id: "#",
  severity: "severity",
  kind: "kind",
  method: "method",
  family: "family",
  margin: "margin",
  bucket: "cause",
  standing: "since earlier runs",
};
const numeric = new Set<Column>(["id", "margin"]);

const cellOf: Record<Column, (row: Row) => string> = {
  id: (r) => String(r.f.id),
  severity: (r) => severityLabels[r.f.severity] ?? r.f.severity,
  kind: (r) => kindLabel(r.f.kind),
  method: (r) => r.f.method,
  family: (r) => kindLabel(r.f.family),
  margin: (r) => short(r.f.margin?.[0]),
  bucket: (r) => r.f.bucket ?? "",
  standing: (r) => r.standing ?? "",
};

function Table({ rows, order, setOrder }: { rows: Row[]; order: Order; setOrder: (order: Order) => void }) {
  const [at, move] = useState(-1);
  useEffect(() => move(-1), [rows]);
  const shown = columns.filter(
    (c) =>
      (c !== "bucket" || rows.some((r) => r.f.bucket !== null)) &&
      (c !== "standing" || rows.some((r) => r.standing !== null)),
  );
  const told = shown.map((c): ColumnOf<Row> => {
    const hint = about(titles[c]);
    return {
      key: c,
      title: titles[c],
      numeric: numeric.has(c),
      ...(hint === undefined ? {} : { about: hint }),
      bad: (r) => c === "severity" && r.f.severity === "contract",
      ...(c === "bucket" ? { hint: (r: Row) => safe(cellOf[c](r)) } : {}),
      cell: (r) =>
        c === "id" ? (
          <a href={`#/finding/${r.f.id}`} tabIndex={-1} onClick={(event) => event.stopPropagation()}>
            {r.f.id}
          </a>
        ) : (
          safe(cellOf[c](r))
        ),
    };
  });
  const turn = (column: string) =>
    setOrder({ column: column as Column, down: order.column === column ? !order.down : column === "margin" });
  return (
    <VirtualTable
      rows={rows}
      columns={told}
      keyOf={(r) => r.f.id}
      label="Findings; arrow keys choose one, Enter opens it"
      order={order}
      turn={turn}
      at={at}
      move={move}
      open={(r) => {
        location.hash = `#/finding/${r.f.id}`;
      }}
      addressOf={(r) => `#/finding/${r.f.id}`}
      rowHeight={rowHeight}
      rowsShown={tableRows}
    />
  );
}

/** The view that the address asks for; what is changed of it here is written there, so that it can be passed on. */
function useView(address: Address): [View, (view: View) => void] {
  const [view, set] = useState(() => viewOf(address.query));
  useLayoutEffect(() => {
    if (address.detail) return;
    const asked = viewOf(address.query);
    if ([...address.query].length === 0 && !address.again) remember(queryOf(view));
    else set((was) => (queryOf(was) === queryOf(asked) ? was : asked));
  }, [address]);
  useLayoutEffect(() => {
    if (!address.detail) remember(queryOf(view));
  }, [view]);
  return [view, set];
}

const ofAll = (shown: number, all: number, one: string) =>
  shown === all ? plural(all, one) : `${grouped(shown)} of ${plural(all, one)}`;

const lead = (report: FullReport) =>
  `${grouped(report.findings_total)} in all. For each method, kind and family the first ten are kept as examples, ` +
  `and each later one that is worse. The margin of a wrong distance is its error over the size (r + h + r + h). The ` +
  `margin of any other finding is the signed distance between the solids over the size. Margins are lower bounds.`;

export function Findings({ report, address }: { report: FullReport; address: Address }) {
  const all = useMemo(() => rowsOf(report), [report]);
  const allCauses = useMemo(() => causesOf(report), [report]);
  const [view, set] = useView(address);
  const { filter, order } = view;
  const passing = useMemo(() => filtered(all, filter), [all, filter]);
  const shown = useMemo(() => {
    const own = order.column === "margin" || order.column === "id";
    return sorted(own ? passing : worstFirst(passing), order);
  }, [passing, order]);
  const causes = useMemo(
    () => sortedCauses(filteredCauses(allCauses, passing, filter), view.causes),
    [allCauses, passing, filter, view.causes],
  );
  const counts = useMemo(() => chipCounts(all, filter), [all, filter]);
  const lone = useMemo(() => loneCounts(allCauses, filter), [allCauses, filter]);
  const said = [
    ofAll(shown.length, all.length, "finding"),
    ...(allCauses.length > 0 ? [ofAll(causes.length, allCauses.length, "cause")] : []),
  ].join(", ");
  const any = all.length > 0 || allCauses.length > 0;
  return (
    <Section id="findings" title="All findings" lead={all.length === 0 ? undefined : lead(report)}>
      {all.length === 0 && <p class="ok">No method was wrong, and none failed.</p>}
      {any && (
        <Search
          filter={filter}
          set={(filter) => set({ ...view, filter })}
          counts={counts}
          lone={lone}
          said={said}
        />
      )}
      {allCauses.length > 0 && (
        <Causes causes={causes} order={view.causes} setOrder={(order) => set({ ...view, causes: order })} />
      )}
      {all.length > 0 && (
        <>
          <p class="tools saving">
            <span class="soft">Save the findings shown</span>
            <button
              type="button"
              onClick={() => save(`${report.run.id}-findings.csv`, "text/csv", csvOf(shown, report))}>
              CSV
            </button>
            <button
              type="button"
              onClick={() => save(`${report.run.id}-findings.json`, "application/json", jsonOf(shown, report))}>
              JSON
            </button>
          </p>
          <Table rows={shown} order={order} setOrder={(o) => set({ ...view, order: o })} />
          <p class="only-print soft">Of {said}, only the rows that were on the screen are printed.</p>
        </>
      )}
    </Section>
  );
}
