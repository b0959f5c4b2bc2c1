// SPDX-License-Identifier: MIT
// Lists of objects as report_data.cpp packs them: a list for each key. In `sparse` null stands for a key that an object
// lacks.

export interface Columns {
  full: Record<string, unknown[]>;
  sparse: Record<string, unknown[]>;
}

const anyColumn = ({ full, sparse }: Columns): unknown[] => Object.values(full)[0] ?? Object.values(sparse)[0] ?? [];

/** The objects; those of a list that is not packed, as they are. */
export function objectsOf<T>(packed: T[] | Columns): T[] {
  if (Array.isArray(packed)) return packed;
  const full = Object.entries(packed.full),
    sparse = Object.entries(packed.sparse);
  const objects: Record<string, unknown>[] = anyColumn(packed).map(() => ({}));
  for (const [key, column] of full) for (const [i, x] of column.entries()) objects[i]![key] = x;
  for (const [key, column] of sparse) for (const [i, x] of column.entries()) if (x !== null) objects[i]![key] = x;
  return objects as T[];
}
