// SPDX-License-Identifier: MIT
// One stop of the Tab key for a whole table; arrow keys move inside it.
import type { RefObject } from "preact";
import { useLayoutEffect } from "preact/hooks";

const stopsIn = (element: Element) => [...element.querySelectorAll<HTMLElement>("a, button")];

/** The links and buttons of each row that has any, each with its column. */
function gridOf(table: Element) {
  return [...table.querySelectorAll("tr")]
    .map((row) =>
      [...(row as HTMLTableRowElement).cells].flatMap((cell) =>
        stopsIn(cell).map((stop) => ({ stop, column: cell.cellIndex })),
      ),
    )
    .filter((row) => row.length > 0);
}

/** Where a key leads from a stop; undefined: nowhere. */
function reached(table: Element, from: HTMLElement, key: string): HTMLElement | undefined {
  const grid = gridOf(table);
  const y = grid.findIndex((row) => row.some(({ stop }) => stop === from));
  if (y < 0) return undefined;
  const row = grid[y]!,
    x = row.findIndex(({ stop }) => stop === from),
    column = row[x]!.column;
  const near = (other: typeof row | undefined) =>
    other?.reduce((best, s) => (Math.abs(s.column - column) < Math.abs(best.column - column) ? s : best));
  switch (key) {
    case "ArrowLeft":
      return row[x - 1]?.stop;
    case "ArrowRight":
      return row[x + 1]?.stop;
    case "ArrowUp":
      return near(grid[y - 1])?.stop;
    case "ArrowDown":
      return near(grid[y + 1])?.stop;
    case "Home":
      return near(grid[0])?.stop;
    case "End":
      return near(grid.at(-1))?.stop;
  }
  return undefined;
}

/** Makes the links and buttons of a table one stop: the last one used, at first the first one of its body. */
export function useRoving(ref: RefObject<HTMLTableElement | null>) {
  useLayoutEffect(() => {
    const all = stopsIn(ref.current!);
    const stop = all.find((s) => s.tabIndex === 0 && s.dataset.stop) ?? all.find((s) => s.closest("tbody")) ?? all[0];
    for (const s of all) s.tabIndex = s === stop ? 0 : -1;
  });
  const choose = (to: HTMLElement) => {
    for (const s of stopsIn(ref.current!)) {
      s.tabIndex = s === to ? 0 : -1;
      if (s === to) s.dataset.stop = "1";
      else delete s.dataset.stop;
    }
  };
  return {
    onKeyDown: (event: KeyboardEvent) => {
      const to = reached(ref.current!, event.target as HTMLElement, event.key);
      if (!to) return;
      event.preventDefault();
      to.focus();
    },
    onFocusIn: (event: FocusEvent) => choose(event.target as HTMLElement),
  };
}
