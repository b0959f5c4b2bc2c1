// SPDX-License-Identifier: MIT
// The table of findings: many rows of one height, sorted by its heads. Only the rows on the screen are elements.
import { useEffect, useLayoutEffect, useRef, useState } from "preact/hooks";
import { safe, short } from "../parts/words.ts";
import { columns, type Column, type Order, type Row } from "./filter.ts";
import { about } from "./glossary.ts";
import { kindLabel, severityLabels } from "./words.ts";

const rowHeight = 25,
  rowsShown = 22,
  spareRows = 8;
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

const addressOf = (row: Row) => `#/finding/${row.f.id}`;
const open = (row: Row) => {
  location.hash = addressOf(row);
};
const numberClass = (c: Column) => `c-${c} ${numeric.has(c) ? "n" : ""}`;

export function FindingsTable({
  rows,
  order,
  setOrder,
}: {
  rows: Row[];
  order: Order;
  setOrder: (order: Order) => void;
}) {
  const box = useRef<HTMLDivElement>(null);
  const [top, scrolled] = useState(0);
  const [at, move] = useState(-1); // the row that the keys are on; -1: none
  const wanted = useRef(-1); // the row that is to have the focus once it is an element
  useEffect(() => {
    if (box.current) box.current.scrollTop = 0;
    scrolled(0);
    move(-1);
  }, [rows]);
  const shown = columns.filter(
    (c) =>
      (c !== "bucket" || rows.some((r) => r.f.bucket !== null)) &&
      (c !== "standing" || rows.some((r) => r.standing !== null)),
  );
  const turn = (column: Column) =>
    setOrder({ column, down: order.column === column ? !order.down : column === "margin" });
  const first = Math.max(0, Math.floor(top / rowHeight) - spareRows),
    last = Math.min(rows.length, first + rowsShown + 2 * spareRows);
  const stop = at >= first && at < last ? at : Math.min(rows.length - 1, Math.ceil(top / rowHeight));

  useLayoutEffect(() => {
    const element = box.current;
    if (!element || at < 0) return;
    const y = at * rowHeight,
      head = rowHeight;
    if (y < element.scrollTop) element.scrollTop = y;
    else if (y + head + rowHeight > element.scrollTop + element.clientHeight - head)
      element.scrollTop = y + 2 * head + rowHeight - element.clientHeight;
    scrolled(element.scrollTop);
  }, [at, rows]);
  useLayoutEffect(() => {
    const row = box.current?.querySelector<HTMLElement>(`tr[aria-rowindex="${wanted.current + 2}"]`);
    if (wanted.current < 0 || !row) return;
    row.focus({ preventScroll: true });
    wanted.current = -1;
  }, [at, top]);

  /** Among the heads; from the last row of heads down into the rows. */
  const pressHead = (event: KeyboardEvent, head: HTMLElement) => {
    const beside = event.key === "ArrowLeft" ? "previousElementSibling" : "nextElementSibling";
    const to =
      event.key === "ArrowDown"
        ? box.current!.querySelector<HTMLElement>("tbody tr[tabindex='0']")
        : event.key === "ArrowLeft" || event.key === "ArrowRight"
          ? head.closest("th")![beside]?.querySelector("button")
          : null;
    if (!to) return;
    event.preventDefault();
    to.focus();
  };
  const press = (event: KeyboardEvent) => {
    const target = event.target as HTMLElement,
      row = target.closest("tbody tr");
    if (target.closest("thead")) return pressHead(event, target);
    const now = row ? Number(row.getAttribute("aria-rowindex")) - 2 : at;
    const page = rowsShown - 2;
    const step = {
      ArrowDown: 1,
      ArrowUp: -1,
      PageDown: page,
      PageUp: -page,
      Home: -rows.length,
      End: rows.length,
      j: 1,
      k: -1,
    }[event.key];
    if (event.key === "ArrowUp" && now === 0) {
      box.current!.querySelector<HTMLElement>("thead button")!.focus();
      event.preventDefault();
    } else if (step !== undefined && rows.length > 0) {
      const to = Math.min(rows.length - 1, Math.max(0, now + step));
      wanted.current = to;
      move(to);
      event.preventDefault();
    } else if (event.key === "Enter" && now >= 0 && (target === row || target === box.current)) {
      open(rows[now]!);
    }
  };
  return (
    <div
      class="virtual"
      ref={box}
      tabIndex={-1}
      role="region"
      aria-label="Findings; arrow keys choose one, Enter opens it"
      onKeyDown={press}
      onScroll={(event) => scrolled(event.currentTarget.scrollTop)}
      style={{ maxHeight: `${(rowsShown + 1) * rowHeight}px` }}>
      <table class="plain findings" aria-rowcount={rows.length + 1} style={{ "--row": `${rowHeight}px` }}>
        <thead>
          <tr aria-rowindex={1}>
            {shown.map((c) => (
              <th
                scope="col"
                class={numberClass(c)}
                title={about(titles[c])}
                aria-sort={order.column === c ? (order.down ? "descending" : "ascending") : "none"}
                key={c}>
                <button type="button" tabIndex={-1} onClick={() => turn(c)}>
                  {titles[c]}
                </button>
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          <tr class="spacer" aria-hidden="true" style={{ height: `${first * rowHeight}px` }}>
            <td colSpan={shown.length} />
          </tr>
          {rows.slice(first, last).map((row, i) => (
            <tr
              key={row.f.id}
              aria-rowindex={first + i + 2}
              class={first + i === at ? "at" : ""}
              tabIndex={first + i === stop ? 0 : -1}
              data-leads={addressOf(row)}
              aria-selected={first + i === at}
              onClick={() => open(row)}>
              {shown.map((c) => (
                <td
                  class={`${numberClass(c)} ${c === "severity" && row.f.severity === "contract" ? "bad" : ""}`}
                  title={c === "bucket" ? safe(cellOf[c](row)) : undefined}
                  key={c}>
                  {c === "id" ? (
                    <a href={addressOf(row)} tabIndex={-1} onClick={(event) => event.stopPropagation()}>
                      {row.f.id}
                    </a>
                  ) : (
                    safe(cellOf[c](row))
                  )}
                </td>
              ))}
            </tr>
          ))}
          <tr class="spacer" aria-hidden="true" style={{ height: `${(rows.length - last) * rowHeight}px` }}>
            <td colSpan={shown.length} />
          </tr>
        </tbody>
      </table>
    </div>
  );
}
