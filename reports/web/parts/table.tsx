// SPDX-License-Identifier: MIT
// A table of many rows of one height, sorted by its heads; only the rows on the screen are elements.
import type { ComponentChildren } from "preact";
import { useEffect, useLayoutEffect, useRef, useState } from "preact/hooks";

const spareRows = 8;

export interface ColumnOf<Row> {
  key: string;
  title: string;
  numeric?: boolean;
  cell: (row: Row) => ComponentChildren;
  hint?: (row: Row) => string;
  bad?: (row: Row) => boolean;
  about?: string;
}
interface TableOf<Row> {
  rows: Row[];
  columns: ColumnOf<Row>[];
  keyOf: (row: Row) => number;
  label: string;
  order: { column: string; down: boolean };
  turn: (column: string) => void;
  at: number;
  move: (at: number) => void; // the row that the keys are on; -1: none
  open: (row: Row) => void;
  addressOf?: (row: Row) => string; // where that leads, if to a view of its own
  rowHeight: number;
  rowsShown: number;
}

export function VirtualTable<Row>({
  rows,
  columns,
  keyOf,
  label,
  order,
  turn,
  at,
  move,
  open,
  addressOf,
  rowHeight,
  rowsShown,
}: TableOf<Row>) {
  const box = useRef<HTMLDivElement>(null);
  const [top, scrolled] = useState(0);
  const wanted = useRef(-1); // the row that is to have the focus once it is an element
  useEffect(() => {
    if (box.current) box.current.scrollTop = 0;
    scrolled(0);
  }, [rows]);
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
      aria-label={label}
      onKeyDown={press}
      onScroll={(event) => scrolled(event.currentTarget.scrollTop)}
      style={{ maxHeight: `${(rowsShown + 1) * rowHeight}px` }}>
      <table class="plain findings" aria-rowcount={rows.length + 1} style={{ "--row": `${rowHeight}px` }}>
        <thead>
          <tr aria-rowindex={1}>
            {columns.map((c) => (
              <th
                scope="col"
                class={`c-${c.key} ${c.numeric ? "n" : ""}`}
                title={c.about}
                aria-sort={order.column === c.key ? (order.down ? "descending" : "ascending") : "none"}
                key={c.key}>
                <button type="button" tabIndex={-1} onClick={() => turn(c.key)}>
                  {c.title}
                </button>
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          <tr class="spacer" aria-hidden="true" style={{ height: `${first * rowHeight}px` }}>
            <td colSpan={columns.length} />
          </tr>
          {rows.slice(first, last).map((row, i) => (
            <tr
              key={keyOf(row)}
              aria-rowindex={first + i + 2}
              class={first + i === at ? "at" : ""}
              tabIndex={first + i === stop ? 0 : -1}
              data-leads={addressOf?.(row)}
              aria-selected={first + i === at}
              onClick={() => open(row)}>
              {columns.map((c) => (
                <td
                  class={`c-${c.key} ${c.numeric ? "n" : ""} ${c.bad?.(row) ? "bad" : ""}`}
                  title={c.hint?.(row)}
                  key={c.key}>
                  {c.cell(row)}
                </td>
              ))}
            </tr>
          ))}
          <tr class="spacer" aria-hidden="true" style={{ height: `${(rows.length - last) * rowHeight}px` }}>
            <td colSpan={columns.length} />
          </tr>
        </tbody>
      </table>
    </div>
  );
}
