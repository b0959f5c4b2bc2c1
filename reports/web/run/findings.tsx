// SPDX-License-Identifier: MIT
// The causes (buckets), and every finding that was kept: filtered by chips, sorted by columns, kept in the address.
import { useEffect, useMemo, useState } from "preact/hooks";
import { Section } from "../parts/elements.tsx";
import { save } from "../parts/save.ts";
import { VirtualTable, type ColumnOf } from "../parts/table.tsx";
import { grouped, plural, safe, short } from "../parts/words.ts";
import { remember, type Address } from "./address.ts";
import { Causes } from "./causes.tsx";
import { Missing } from "./elements.tsx";
import { csv_of, json_of } from "./files.ts";
import {
  causes_of,
  chip_counts,
  columns,
  facets,
  filtered,
  filtered_causes,
  lone_counts,
  no_filter,
  query_of,
  rows_of,
  sorted,
  sorted_causes,
  view_of,
  worst_first,
  type Column,
  type Facet,
  type Filter,
  type Order,
  type Row,
  type View,
} from "./filter.ts";
import { about } from "./glossary.ts";
import type { FullReport } from "./report.ts";
import { kind_words, severity_words } from "./words.ts";

const row_height = 25,
  table_rows = 22;
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
const facet_titles: Record<Facet, string> = {
  severity: "Severity",
  kind: "Kind",
  library: "Library",
  family: "Family",
  standing: "Since earlier runs",
};
const numeric = new Set<Column>(["id", "margin"]);

function Chips({
  facet,
  counts,
  lone,
  filter,
  set,
}: {
  facet: Facet;
  counts: Map<string, number>;
  lone: Map<string, number>;
  filter: Filter;
  set: (filter: Filter) => void;
}) {
  const chosen = filter.chosen[facet];
  const all = new Map([...[...lone.keys(), ...chosen].map((value) => [value, 0] as const), ...counts]);
  const values = [...all].sort((x, y) => y[1] - x[1] || (x[0] < y[0] ? -1 : 1));
  if (values.length < 2 && chosen.size === 0) return null;
  const press = (value: string) => {
    const now = new Set(chosen);
    if (!now.delete(value)) now.add(value);
    set({ ...filter, chosen: { ...filter.chosen, [facet]: now } });
  };
  const words = (value: string) => (facet === "severity" ? (severity_words[value] ?? value) : kind_words(value));
  return (
    <div class="chips" role="group" aria-label={facet_titles[facet]}>
      <span class="chips-title" title={about(facet_titles[facet])}>
        {facet_titles[facet]}
      </span>
      {values.map(([value, count]) => {
        const causes = count === 0 ? (lone.get(value) ?? 0) : 0;
        return (
          <button
            type="button"
            class="chip"
            aria-pressed={chosen.has(value)}
            disabled={count + causes === 0 && !chosen.has(value)}
            title={about(words(value))}
            onClick={() => press(value)}
            key={value}>
            {safe(words(value))} <span class="count">{causes > 0 ? plural(causes, "cause") : grouped(count)}</span>
          </button>
        );
      })}
    </div>
  );
}

const cell_of: Record<Column, (row: Row) => string> = {
  id: (r) => String(r.f.id),
  severity: (r) => severity_words[r.f.severity] ?? r.f.severity,
  kind: (r) => kind_words(r.f.kind),
  method: (r) => r.f.method,
  family: (r) => kind_words(r.f.family),
  margin: (r) => short(r.f.margin?.[0]),
  bucket: (r) => r.f.bucket ?? "",
  standing: (r) => r.standing ?? "",
};

function Table({ rows, order, set_order }: { rows: Row[]; order: Order; set_order: (order: Order) => void }) {
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
      ...(c === "bucket" ? { hint: (r: Row) => safe(cell_of[c](r)) } : {}),
      cell: (r) =>
        c === "id" ? (
          <a href={`#/finding/${r.f.id}`} tabIndex={-1} onClick={(event) => event.stopPropagation()}>
            {r.f.id}
          </a>
        ) : (
          safe(cell_of[c](r))
        ),
    };
  });
  const turn = (column: string) =>
    set_order({ column: column as Column, down: order.column === column ? !order.down : column === "margin" });
  return (
    <VirtualTable
      rows={rows}
      columns={told}
      key_of={(r) => r.f.id}
      label="Findings; arrow keys choose one, Enter opens it"
      order={order}
      turn={turn}
      at={at}
      move={move}
      open={(r) => {
        location.hash = `#/finding/${r.f.id}`;
      }}
      address_of={(r) => `#/finding/${r.f.id}`}
      row_height={row_height}
      rows_shown={table_rows}
    />
  );
}

/** The view that the address asks for; what is changed of it here is written there, so that it can be passed on. */
function useView(address: Address): [View, (view: View) => void] {
  const [view, set] = useState(() => view_of(address.query));
  useEffect(() => {
    if (address.detail) return;
    const asked = view_of(address.query);
    if ([...address.query].length === 0 && !address.again) remember(query_of(view));
    else set((was) => (query_of(was) === query_of(asked) ? was : asked));
  }, [address]);
  useEffect(() => {
    if (!address.detail) remember(query_of(view));
  }, [view]);
  return [view, set];
}

function Filters({
  view,
  set,
  counts,
  lone,
  said,
}: {
  view: View;
  set: (view: View) => void;
  counts: ReturnType<typeof chip_counts>;
  lone: ReturnType<typeof lone_counts>;
  said: string;
}) {
  const { filter } = view,
    to = (filter: Filter) => set({ ...view, filter });
  const clear = filter.method !== null || filter.text !== "" || facets.some((f) => filter.chosen[f].size > 0);
  return (
    <div class="filters">
      {facets.map((facet) => (
        <Chips facet={facet} counts={counts[facet]} lone={lone[facet]} filter={filter} set={to} key={facet} />
      ))}
      <div class="chips">
        <span class="chips-title" title={about("text")}>
          Text
        </span>
        <input
          type="search"
          value={filter.text}
          placeholder="method, family, cause, reason, number"
          aria-label="Search causes and findings"
          onInput={(event) => to({ ...filter, text: event.currentTarget.value })}
        />
        {filter.method !== null && (
          <button type="button" class="chip" aria-pressed="true" onClick={() => to({ ...filter, method: null })}>
            method {safe(filter.method)}
          </button>
        )}
        {clear && (
          <button type="button" onClick={() => to(no_filter)}>
            Clear
          </button>
        )}
        <span class="soft" role="status">
          {said}
        </span>
      </div>
    </div>
  );
}

const of_all = (shown: number, all: number, one: string) =>
  shown === all ? plural(all, one) : `${grouped(shown)} of ${plural(all, one)}`;

const lead = (report: FullReport) =>
  `${grouped(report.findings_total)} in all; of each method, kind and family the first ten and ever worse ones are ` +
  `kept as examples. The margin of a wrong distance is its error over the size (r + h + r + h); of any other finding ` +
  `it is the signed distance between the solids over the size. Both are what it is at least.`;

export function Findings({ report, address }: { report: FullReport; address: Address }) {
  const all = useMemo(() => rows_of(report), [report]);
  const all_causes = useMemo(() => causes_of(report), [report]);
  const [view, set] = useView(address);
  const { filter, order } = view;
  const passing = useMemo(() => filtered(all, filter), [all, filter]);
  const shown = useMemo(() => {
    const own = order.column === "margin" || order.column === "id";
    return sorted(own ? passing : worst_first(passing), order);
  }, [passing, order]);
  const causes = useMemo(
    () => sorted_causes(filtered_causes(all_causes, passing, filter), view.causes),
    [all_causes, passing, filter, view.causes],
  );
  const counts = useMemo(() => chip_counts(all, filter), [all, filter]);
  const lone = useMemo(() => lone_counts(all_causes, filter), [all_causes, filter]);
  const said = [
    of_all(shown.length, all.length, "finding"),
    ...(all_causes.length > 0 ? [of_all(causes.length, all_causes.length, "cause")] : []),
  ].join(", ");
  const any = all.length > 0 || all_causes.length > 0;
  return (
    <Section id="findings" title="Findings" lead={all.length === 0 ? undefined : lead(report)}>
      {all.length === 0 && <p class="ok">No method was wrong, and none failed.</p>}
      {all.length > 0 && all_causes.length === 0 && <Missing of="buckets" report={report} />}
      {any && <Filters view={view} set={set} counts={counts} lone={lone} said={said} />}
      {all_causes.length > 0 && (
        <Causes causes={causes} order={view.causes} set_order={(order) => set({ ...view, causes: order })} />
      )}
      {all.length > 0 && (
        <>
          <p class="tools saving">
            <span class="soft">Save the findings shown</span>
            <button
              type="button"
              onClick={() => save(`${report.run.id}-findings.csv`, "text/csv", csv_of(shown, report))}>
              CSV
            </button>
            <button
              type="button"
              onClick={() => save(`${report.run.id}-findings.json`, "application/json", json_of(shown, report))}>
              JSON
            </button>
          </p>
          <Table rows={shown} order={order} set_order={(o) => set({ ...view, order: o })} />
          <p class="only-print soft">Of {said}, printed are the rows that were on the screen.</p>
        </>
      )}
    </Section>
  );
}
