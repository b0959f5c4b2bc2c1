// SPDX-License-Identifier: MIT
// A table of many rows of one height, sorted by its heads; only the rows on the screen are elements.
import type { ComponentChildren } from "preact";
import { useEffect, useLayoutEffect, useRef, useState } from "preact/hooks";

const spare_rows = 8;

export interface ColumnOf<Row> {
  key: string;
  title: string;
  numeric?: boolean;
  cell: (row: Row) => ComponentChildren;
  hint?: (row: Row) => string;
  bad?: (row: Row) => boolean;
  about?: string;
}
export interface TableOf<Row> {
  rows: Row[];
  columns: ColumnOf<Row>[];
  key_of: (row: Row) => number;
  label: string;
  order: { column: string; down: boolean };
  turn: (column: string) => void;
  at: number;
  move: (at: number) => void; // the row that the keys are on; -1: none
  open: (row: Row) => void;
  row_height: number;
  rows_shown: number;
}

export function VirtualTable<Row>({
  rows,
  columns,
  key_of,
  label,
  order,
  turn,
  at,
  move,
  open,
  row_height,
  rows_shown,
}: TableOf<Row>) {
  const box = useRef<HTMLDivElement>(null);
  const [top, scrolled] = useState(0);
  useEffect(() => {
    if (box.current) box.current.scrollTop = 0;
    scrolled(0);
  }, [rows]);
  const first = Math.max(0, Math.floor(top / row_height) - spare_rows),
    last = Math.min(rows.length, first + rows_shown + 2 * spare_rows);

  useLayoutEffect(() => {
    const element = box.current;
    if (!element || at < 0) return;
    const y = at * row_height,
      head = row_height;
    if (y < element.scrollTop) element.scrollTop = y;
    else if (y + head + row_height > element.scrollTop + element.clientHeight - head)
      element.scrollTop = y + 2 * head + row_height - element.clientHeight;
  }, [at, rows]);
  const press = (event: KeyboardEvent) => {
    const page = rows_shown - 2;
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
    if (step !== undefined && rows.length > 0) {
      move(Math.min(rows.length - 1, Math.max(0, at + step)));
      event.preventDefault();
    } else if (event.key === "Enter" && at >= 0 && event.target === box.current) {
      open(rows[at]!);
    }
  };
  return (
    <div
      class="virtual"
      ref={box}
      tabIndex={0}
      role="region"
      aria-label={label}
      onKeyDown={press}
      onScroll={(event) => scrolled(event.currentTarget.scrollTop)}
      style={{ maxHeight: `${(rows_shown + 1) * row_height}px` }}>
      <table class="plain findings" aria-rowcount={rows.length + 1} style={{ "--row": `${row_height}px` }}>
        <thead>
          <tr aria-rowindex={1}>
            {columns.map((c) => (
              <th
                scope="col"
                class={`c-${c.key} ${c.numeric ? "n" : ""}`}
                title={c.about}
                aria-sort={order.column === c.key ? (order.down ? "descending" : "ascending") : "none"}
                key={c.key}>
                <button type="button" onClick={() => turn(c.key)}>
                  {c.title}
                </button>
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          <tr class="spacer" aria-hidden="true" style={{ height: `${first * row_height}px` }}>
            <td colSpan={columns.length} />
          </tr>
          {rows.slice(first, last).map((row, i) => (
            <tr
              key={key_of(row)}
              aria-rowindex={first + i + 2}
              class={first + i === at ? "at" : ""}
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
          <tr class="spacer" aria-hidden="true" style={{ height: `${(rows.length - last) * row_height}px` }}>
            <td colSpan={columns.length} />
          </tr>
        </tbody>
      </table>
    </div>
  );
}
