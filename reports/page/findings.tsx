// SPDX-License-Identifier: MIT
// The causes (buckets), and every finding that was kept: filtered by chips, sorted by columns; only the rows on the
// screen are elements.
import { useEffect, useLayoutEffect, useMemo, useRef, useState } from "preact/hooks";
import type { Bucket } from "./data.ts";
import { chip_counts, columns, facets, filter_of, filtered, no_filter, rows_of, sorted, type Column, type Facet, type Filter, type Order, type Row } from "./filter.ts";
import { Missing, Section } from "./parts.tsx";
import type { FullReport } from "./report.ts";
import { grouped, in_order, kind_words, percent, plural, range, safe, severity_words, short } from "./words.ts";

const row_height = 25, table_rows = 22, spare_rows = 8;
const titles: Record<Column, string> = { id: "#", severity: "severity", kind: "kind", method: "method", family: "family", margin: "margin", bucket: "cause", standing: "standing" };
const facet_titles: Record<Facet, string> = { severity: "Severity", kind: "Kind", library: "Library", family: "Family", standing: "Standing" };
const numeric = new Set<Column>(["id", "margin"]);

const few = (names: string[]) => names.length < 4 ? safe(names.join(", ")) : `${safe(names.slice(0, 2).join(", "))} and ${names.length - 2} more`;

export const bucket_address = (key: string) => `#/bucket/${key.split("/").map(encodeURIComponent).join("/")}`;

function Buckets({ report }: { report: FullReport }) {
  if (report.buckets.length === 0)
    return report.findings.length === 0 ? null : <Missing of="buckets" report={report} />;
  const worst_first = (x: Bucket, y: Bucket) => (x.severity === y.severity ? y.count - x.count : x.severity === "contract" ? -1 : y.severity === "contract" ? 1 : 0);
  return (
    <div class="scroll">
      <table class="plain buckets">
        <thead><tr><th>cause</th><th>methods</th><th>severity</th><th class="n">findings</th><th class="n">margins</th><th class="n">of its stratum</th><th>standing</th><th>first seen</th></tr></thead>
        <tbody>
          {in_order(report.buckets, worst_first).map((b) => (
            <tr key={b.key} class={b.suppressed ? "suppressed" : ""}>
              <td class="wrap"><a href={bucket_address(b.key)}>{safe(b.key)}</a>{b.suppressed && <> <span class="tag" title={safe(b.suppressed.reason)}>suppressed until {safe(b.suppressed.expires)}</span></>}
                <div class="soft">{b.cause ? safe(b.cause) : b.labels.map((l) => <span class="tag" key={l}>{safe(l)}</span>)}</div></td>
              <td class="wrap soft" title={safe((b.methods ?? [b.method]).join(", "))}>{few(b.methods ?? [b.method])}</td>
              <td class={b.severity === "contract" ? "bad" : ""}>{severity_words[b.severity] ?? safe(b.severity)}</td>
              <td class="n">{grouped(b.count)}</td>
              <td class="n">{range(b.margin)}</td>
              <td class="n" title={b.share ? `${grouped(b.share.wrong)} of ${grouped(b.share.asked)}` : ""}>{b.share ? percent(b.share.wrong, b.share.asked) : "\u2013"}</td>
              <td>{b.standing ?? "\u2013"}</td>
              <td>{safe(b.first_seen)}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}

function Chips({ facet, counts, filter, set }: { facet: Facet; counts: Map<string, number>; filter: Filter; set: (filter: Filter) => void }) {
  const chosen = filter.chosen[facet];
  const values = [...counts].sort((x, y) => y[1] - x[1] || (x[0] < y[0] ? -1 : 1));
  if (values.length < 2 && chosen.size === 0) return null;
  const press = (value: string) => {
    const now = new Set(chosen);
    if (!now.delete(value)) now.add(value);
    set({ ...filter, chosen: { ...filter.chosen, [facet]: now } });
  };
  const words = (value: string) => facet === "severity" ? severity_words[value] ?? value : kind_words(value);
  return (
    <div class="chips" role="group" aria-label={facet_titles[facet]}>
      <span class="chips-title">{facet_titles[facet]}</span>
      {values.map(([value, count]) => (
        <button type="button" class="chip" aria-pressed={chosen.has(value)} disabled={count === 0 && !chosen.has(value)} onClick={() => press(value)} key={value}>
          {safe(words(value))} <span class="count">{grouped(count)}</span>
        </button>
      ))}
    </div>
  );
}

const cell_of: Record<Column, (row: Row) => string> = {
  id: (r) => String(r.f.id), severity: (r) => severity_words[r.f.severity] ?? r.f.severity, kind: (r) => kind_words(r.f.kind), method: (r) => r.f.method,
  family: (r) => kind_words(r.f.family), margin: (r) => short(r.f.margin?.[0]), bucket: (r) => r.f.bucket ?? "", standing: (r) => r.standing ?? "" };

function Table({ rows, order, set_order }: { rows: Row[]; order: Order; set_order: (order: Order) => void }) {
  const box = useRef<HTMLDivElement>(null);
  const [top, scrolled] = useState(0);
  const [at, move] = useState(-1);
  useEffect(() => {
    move(-1);
    if (box.current) box.current.scrollTop = 0;
    scrolled(0);
  }, [rows]);
  const first = Math.max(0, Math.floor(top / row_height) - spare_rows), last = Math.min(rows.length, first + table_rows + 2 * spare_rows);
  const columns_shown = columns.filter((c) => (c !== "bucket" || rows.some((r) => r.f.bucket !== null)) && (c !== "standing" || rows.some((r) => r.standing !== null)));

  useLayoutEffect(() => {
    const element = box.current;
    if (!element || at < 0) return;
    const y = at * row_height, head = row_height;
    if (y < element.scrollTop) element.scrollTop = y;
    else if (y + head + row_height > element.scrollTop + element.clientHeight - head) element.scrollTop = y + 2 * head + row_height - element.clientHeight;
  }, [at]);
  const press = (event: KeyboardEvent) => {
    const page = table_rows - 2;
    const step = { ArrowDown: 1, ArrowUp: -1, PageDown: page, PageUp: -page, Home: -rows.length, End: rows.length, j: 1, k: -1 }[event.key];
    if (step !== undefined && rows.length > 0) {
      move((was) => Math.min(rows.length - 1, Math.max(0, was + step)));
      event.preventDefault();
    } else if (event.key === "Enter" && at >= 0 && event.target === box.current) {
      location.hash = `#/finding/${rows[at]!.f.id}`;
    }
  };
  const turn = (column: Column) => set_order({ column, down: order.column === column ? !order.down : column === "margin" });
  return (
    <div class="virtual" ref={box} tabIndex={0} role="region" aria-label="Findings; arrow keys choose one, Enter opens it" onKeyDown={press}
      onScroll={(event) => scrolled(event.currentTarget.scrollTop)} style={{ maxHeight: `${(table_rows + 1) * row_height}px` }}>
      <table class="plain findings" aria-rowcount={rows.length + 1}>
        <thead>
          <tr aria-rowindex={1}>
            {columns_shown.map((c) => (
              <th scope="col" class={`c-${c} ${numeric.has(c) ? "n" : ""}`} aria-sort={order.column === c ? (order.down ? "descending" : "ascending") : "none"} key={c}>
                <button type="button" onClick={() => turn(c)}>{titles[c]}</button>
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          <tr class="spacer" aria-hidden="true" style={{ height: `${first * row_height}px` }}><td colSpan={columns_shown.length} /></tr>
          {rows.slice(first, last).map((r, i) => (
            <tr key={r.f.id} aria-rowindex={first + i + 2} class={first + i === at ? "at" : ""} aria-selected={first + i === at} onClick={() => { location.hash = `#/finding/${r.f.id}`; }}>
              {columns_shown.map((c) => (
                <td class={`c-${c} ${numeric.has(c) ? "n" : ""} ${c === "severity" && r.f.severity === "contract" ? "bad" : ""}`} title={c === "bucket" ? safe(cell_of[c](r)) : undefined} key={c}>
                  {c === "id" ? <a href={`#/finding/${r.f.id}`} tabIndex={-1} onClick={(event) => event.stopPropagation()}>{r.f.id}</a> : safe(cell_of[c](r))}
                </td>
              ))}
            </tr>
          ))}
          <tr class="spacer" aria-hidden="true" style={{ height: `${(rows.length - last) * row_height}px` }}><td colSpan={columns_shown.length} /></tr>
        </tbody>
      </table>
    </div>
  );
}

export function Findings({ report, query }: { report: FullReport; query: URLSearchParams | null }) {
  const all = useMemo(() => rows_of(report), [report]);
  const [filter, set] = useState(no_filter);
  const [order, set_order] = useState<Order>({ column: "severity", down: false });
  const [by_margin, keep] = useState(true);  // until a column is chosen: the worst first
  useEffect(() => { if (query && [...query].length > 0) set(filter_of(query)); }, [query?.toString()]);
  const shown = useMemo(() => {
    const rows = filtered(all, filter);
    return sorted(by_margin ? sorted(rows, { column: "margin", down: true }) : rows, order);
  }, [all, filter, order, by_margin]);
  const counts = useMemo(() => chip_counts(all, filter), [all, filter]);
  const clear = filter.method !== null || filter.text !== "" || facets.some((f) => filter.chosen[f].size > 0);
  return (
    <Section id="findings" title="Findings"
      lead={all.length === 0 ? undefined : `${grouped(report.findings_total)} in all; of each method, kind and family the first ten and ever worse ones are kept with their pair. The margin is the signed distance over the size (r + h + r + h), at least.`}>
      {all.length === 0 && <p class="ok">No method was wrong, and none failed.</p>}
      <Buckets report={report} />
      {all.length > 0 && (
        <>
          <div class="filters">
            {facets.map((facet) => <Chips facet={facet} counts={counts[facet]} filter={filter} set={set} key={facet} />)}
            <div class="chips">
              <span class="chips-title">Text</span>
              <input type="search" value={filter.text} placeholder="method, family, cause, reason, number" aria-label="Search findings" onInput={(event) => set({ ...filter, text: event.currentTarget.value })} />
              {filter.method !== null && <button type="button" class="chip" aria-pressed="true" onClick={() => set({ ...filter, method: null })}>method {safe(filter.method)}</button>}
              {clear && <button type="button" onClick={() => set(no_filter)}>Clear</button>}
              <span class="soft" role="status">{shown.length === all.length ? plural(shown.length, "finding") : `${grouped(shown.length)} of ${plural(all.length, "finding")}`}</span>
            </div>
          </div>
          <Table rows={shown} order={order} set_order={(o) => { keep(o.column !== "margin" && o.column !== "id"); set_order(o); }} />
        </>
      )}
    </Section>
  );
}
