// SPDX-License-Identifier: MIT
// The findings shown, as files: a table for spreadsheets (RFC 4180), and JSON with all that is known of them.
import type { Cylinder } from "../parts/data.ts";
import { csv_cell, type Cell } from "../parts/save.ts";
import { wrong_distance } from "./distance.ts";
import type { Row } from "./filter.ts";
import type { FullReport } from "./report.ts";
import { severity_words } from "./words.ts";

const lengths = (c: Cylinder): number[] => [...c.center, ...c.axis, c.radius, c.height];
const names_of = (solid: string) =>
  ["center_x", "center_y", "center_z", "axis_x", "axis_y", "axis_z", "radius", "height"].map((n) => `${solid}_${n}`);
const head = [
  ...["id", "method", "kind", "severity", "family", "cause", "since_earlier_runs", "margin_low", "margin_high"],
  ...["truth", "distance_low", "distance_high", "answer", "answer_distance", "error", "reason"],
  ...names_of("a"),
  ...names_of("b"),
];

const claim_of = (report: FullReport) => {
  const claims = new Map(report.methods.map((m) => [m.name, m.claim]));
  return ({ f }: Row) => wrong_distance(f, f.answers[f.method], claims.get(f.method));
};

export function csv_of(rows: Row[], report: FullReport): string {
  const error_of = claim_of(report);
  const lines = rows.map((row): Cell[] => {
    const { f } = row,
      answer = f.answers[f.method];
    return [
      ...[f.id, f.method, f.kind, severity_words[f.severity] ?? f.severity, f.family, f.bucket, row.standing],
      ...(f.margin ?? [null, null]),
      f.truth.verdict,
      ...(f.truth.distance ?? [null, null]),
      ...[answer?.verdict ?? answer?.failed, answer?.distance, error_of(row)?.error, f.reason],
      ...lengths(f.pair.a),
      ...lengths(f.pair.b),
    ];
  });
  return [head, ...lines].map((cells) => `${cells.map(csv_cell).join(",")}\r\n`).join("");
}

export function json_of(rows: Row[], report: FullReport): string {
  const error_of = claim_of(report);
  const told = rows.map((row) => ({ ...row.f, standing: row.standing, error: error_of(row)?.error ?? null }));
  const open_end = (_: string, x: unknown) => (x === Infinity ? "inf" : x === -Infinity ? "-inf" : x);
  return `${JSON.stringify(told, open_end, 1)}\n`;
}
