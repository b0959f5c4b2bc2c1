// SPDX-License-Identifier: MIT
// The causes (buckets), and every finding that was kept: filtered by chips, sorted by columns.
import { useEffect, useMemo, useState } from "preact/hooks";
import type { Bucket } from "./data.ts";
import {
  chip_counts,
  columns,
  facets,
  filter_of,
  filtered,
  no_filter,
  rows_of,
  sorted,
  type Column,
  type Facet,
  type Filter,
  type Order,
  type Row,
} from "./filter.ts";
import { Missing, Section } from "./parts.tsx";
import type { FullReport } from "./report.ts";
import { VirtualTable, type ColumnOf } from "./table.tsx";
import { grouped, in_order, kind_words, percent, plural, range, safe, severity_words, short } from "./words.ts";

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
  standing: "standing",
};
const facet_titles: Record<Facet, string> = {
  severity: "Severity",
  kind: "Kind",
  library: "Library",
  family: "Family",
  standing: "Standing",
};
const numeric = new Set<Column>(["id", "margin"]);

const few = (names: string[]) =>
  names.length < 4 ? safe(names.join(", ")) : `${safe(names.slice(0, 2).join(", "))} and ${names.length - 2} more`;

export const bucket_address = (key: string) => `#/bucket/${key.split("/").map(encodeURIComponent).join("/")}`;

function Buckets({ report }: { report: FullReport }) {
  if (report.buckets.length === 0)
    return report.findings.length === 0 ? null : <Missing of="buckets" report={report} />;
  const worst_first = (x: Bucket, y: Bucket) =>
    x.severity === y.severity ? y.count - x.count : x.severity === "contract" ? -1 : y.severity === "contract" ? 1 : 0;
  return (
    <div class="scroll">
      <table class="plain buckets">
        <thead>
          <tr>
            <th>cause</th>
            <th>methods</th>
            <th>severity</th>
            <th class="n">findings</th>
            <th class="n">margins</th>
            <th class="n">of its stratum</th>
            <th>standing</th>
            <th>first seen</th>
          </tr>
        </thead>
        <tbody>
          {in_order(report.buckets, worst_first).map((b) => (
            <tr key={b.key} class={b.suppressed ? "suppressed" : ""}>
              <td class="wrap">
                <a href={bucket_address(b.key)}>{safe(b.key)}</a>
                {b.suppressed && (
                  <>
                    {" "}
                    <span class="tag" title={safe(b.suppressed.reason)}>
                      suppressed until {safe(b.suppressed.expires)}
                    </span>
                  </>
                )}
                <div class="soft">
                  {b.cause
                    ? safe(b.cause)
                    : b.labels.map((l) => (
                        <span class="tag" key={l}>
                          {safe(l)}
                        </span>
                      ))}
                </div>
              </td>
              <td class="wrap soft" title={safe((b.methods ?? [b.method]).join(", "))}>
                {few(b.methods ?? [b.method])}
              </td>
              <td class={b.severity === "contract" ? "bad" : ""}>{severity_words[b.severity] ?? safe(b.severity)}</td>
              <td class="n">{grouped(b.count)}</td>
              <td class="n">{range(b.margin)}</td>
              <td class="n" title={b.share ? `${grouped(b.share.wrong)} of ${grouped(b.share.asked)}` : ""}>
                {b.share ? percent(b.share.wrong, b.share.asked) : "\u2013"}
              </td>
              <td>{b.standing ?? "\u2013"}</td>
              <td>{safe(b.first_seen)}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}

function Chips({
  facet,
  counts,
  filter,
  set,
}: {
  facet: Facet;
  counts: Map<string, number>;
  filter: Filter;
  set: (filter: Filter) => void;
}) {
  const chosen = filter.chosen[facet];
  const values = [...counts].sort((x, y) => y[1] - x[1] || (x[0] < y[0] ? -1 : 1));
  if (values.length < 2 && chosen.size === 0) return null;
  const press = (value: string) => {
    const now = new Set(chosen);
    if (!now.delete(value)) now.add(value);
    set({ ...filter, chosen: { ...filter.chosen, [facet]: now } });
  };
  const words = (value: string) => (facet === "severity" ? (severity_words[value] ?? value) : kind_words(value));
  return (
    <div class="chips" role="group" aria-label={facet_titles[facet]}>
      <span class="chips-title">{facet_titles[facet]}</span>
      {values.map(([value, count]) => (
        <button
          type="button"
          class="chip"
          aria-pressed={chosen.has(value)}
          disabled={count === 0 && !chosen.has(value)}
          onClick={() => press(value)}
          key={value}>
          {safe(words(value))} <span class="count">{grouped(count)}</span>
        </button>
      ))}
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
  const told = shown.map((c): ColumnOf<Row> => ({
    key: c,
    title: titles[c],
    numeric: numeric.has(c),
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
  }));
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
      row_height={row_height}
      rows_shown={table_rows}
    />
  );
}

export function Findings({ report, query }: { report: FullReport; query: URLSearchParams | null }) {
  const all = useMemo(() => rows_of(report), [report]);
  const [filter, set] = useState(no_filter);
  const [order, set_order] = useState<Order>({ column: "severity", down: false });
  const [by_margin, keep] = useState(true); // until a column is chosen: the worst first
  useEffect(() => {
    if (query && [...query].length > 0) set(filter_of(query));
  }, [query?.toString()]);
  const shown = useMemo(() => {
    const rows = filtered(all, filter);
    return sorted(by_margin ? sorted(rows, { column: "margin", down: true }) : rows, order);
  }, [all, filter, order, by_margin]);
  const counts = useMemo(() => chip_counts(all, filter), [all, filter]);
  const clear = filter.method !== null || filter.text !== "" || facets.some((f) => filter.chosen[f].size > 0);
  return (
    <Section
      id="findings"
      title="Findings"
      lead={
        all.length === 0
          ? undefined
          : `${grouped(report.findings_total)} in all; of each method, kind and family the first ten and ever worse ` +
            `ones are kept with their pair. The margin is the signed distance over the size (r + h + r + h), at ` +
            `least.`
      }>
      {all.length === 0 && <p class="ok">No method was wrong, and none failed.</p>}
      <Buckets report={report} />
      {all.length > 0 && (
        <>
          <div class="filters">
            {facets.map((facet) => (
              <Chips facet={facet} counts={counts[facet]} filter={filter} set={set} key={facet} />
            ))}
            <div class="chips">
              <span class="chips-title">Text</span>
              <input
                type="search"
                value={filter.text}
                placeholder="method, family, cause, reason, number"
                aria-label="Search findings"
                onInput={(event) => set({ ...filter, text: event.currentTarget.value })}
              />
              {filter.method !== null && (
                <button type="button" class="chip" aria-pressed="true" onClick={() => set({ ...filter, method: null })}>
                  method {safe(filter.method)}
                </button>
              )}
              {clear && (
                <button type="button" onClick={() => set(no_filter)}>
                  Clear
                </button>
              )}
              <span class="soft" role="status">
                {shown.length === all.length
                  ? plural(shown.length, "finding")
                  : `${grouped(shown.length)} of ${plural(all.length, "finding")}`}
              </span>
            </div>
          </div>
          <Table
            rows={shown}
            order={order}
            set_order={(o) => {
              keep(o.column !== "margin" && o.column !== "id");
              set_order(o);
            }}
          />
        </>
      )}
    </Section>
  );
}
