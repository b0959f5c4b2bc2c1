// SPDX-License-Identifier: MIT
// Cells of a table for spreadsheets (RFC 4180), and files that the page saves.

export type Cell = string | number | null | undefined;

/** A spreadsheet would take text that begins like a formula for one. */
const harmless = (text: string) => (/^[=+\-@\t\r]/.test(text) ? `'${text}` : text);
export function csvCell(cell: Cell): string {
  if (cell === null || cell === undefined) return "";
  const number = (x: number) => (Object.is(x, -0) ? "-0" : String(x).replace("Infinity", "inf"));
  const text = typeof cell === "number" ? number(cell) : harmless(cell);
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

/** Hands a file to whoever reads the page. */
export function save(name: string, type: string, text: string) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([text], { type }));
  link.download = name.replace(/[^A-Za-z0-9_.-]+/g, "_");
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}
