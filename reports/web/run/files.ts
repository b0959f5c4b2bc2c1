// SPDX-License-Identifier: MIT
// The findings shown, as files: a table for spreadsheets (RFC 4180), and JSON with all that is known of them.
import type { Cylinder } from "../parts/data.ts";
import { wrongDistance } from "./distance.ts";
import type { Row } from "./filter.ts";
import type { FullReport } from "./report.ts";
import { severityLabels } from "./words.ts";

type Cell = string | number | null | undefined;

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

const lengths = (c: Cylinder): number[] => [...c.center, ...c.axis, c.radius, c.height];
const namesOf = (solid: string) =>
  ["center_x", "center_y", "center_z", "axis_x", "axis_y", "axis_z", "radius", "height"].map((n) => `${solid}_${n}`);
const head = [
  ...["id", "method", "kind", "severity", "family", "cause", "since_earlier_runs", "margin_low", "margin_high"],
  ...["truth", "distance_low", "distance_high", "answer", "answer_distance", "error", "reason"],
  ...namesOf("a"),
  ...namesOf("b"),
];

const claimOf = (report: FullReport) => {
  const claims = new Map(report.methods.map((m) => [m.name, m.claim]));
  return ({ f }: Row) => wrongDistance(f, f.answers[f.method], claims.get(f.method));
};

export function csvOf(rows: Row[], report: FullReport): string {
  const errorOf = claimOf(report);
  const lines = rows.map((row): Cell[] => {
    const { f } = row,
      answer = f.answers[f.method];
    return [
      ...[f.id, f.method, f.kind, severityLabels[f.severity] ?? f.severity, f.family, f.bucket, row.standing],
      ...(f.margin ?? [null, null]),
      f.truth.verdict,
      ...(f.truth.distance ?? [null, null]),
      ...[answer?.verdict ?? answer?.failed, answer?.distance, errorOf(row)?.error, f.reason],
      ...lengths(f.pair.a),
      ...lengths(f.pair.b),
    ];
  });
  return [head, ...lines].map((cells) => `${cells.map(csvCell).join(",")}\r\n`).join("");
}

export function jsonOf(rows: Row[], report: FullReport): string {
  const errorOf = claimOf(report);
  const told = rows.map((row) => ({ ...row.f, standing: row.standing, error: errorOf(row)?.error ?? null }));
  const openEnd = (_: string, x: unknown) => (x === Infinity ? "inf" : x === -Infinity ? "-inf" : x);
  return `${JSON.stringify(told, openEnd, 1)}\n`;
}
