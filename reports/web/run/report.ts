// SPDX-License-Identifier: MIT
// The data of the page, put back to the form of data.ts: every finding with its case.
import { shell_quoted } from "../parts/words.ts";
import type { Answer, Case, Finding, MapCell, PackedCase, Report, Standing, Truth } from "./data.ts";

export interface FullReport extends Omit<Report, "findings" | "cases" | "names"> {
  findings: Finding[];
}

type Ends = [number, number];
/** JSON has no number beyond the doubles: "inf" and "-inf" stand for them. */
const number_of = (x: unknown) => (x === "inf" ? Infinity : x === "-inf" ? -Infinity : Number(x));
const ends_of = (ends: Ends): Ends => [number_of(ends[0]), number_of(ends[1])];
const with_ends = <T extends { truth: Truth; margin: Ends | null }>(of: T): T => ({
  ...of,
  truth: of.truth.distance ? { ...of.truth, distance: ends_of(of.truth.distance) } : of.truth,
  margin: of.margin && ends_of(of.margin),
});

function unpack(packed: PackedCase, names: string[]): Omit<Case, "replay"> {
  const { said, ...rest } = with_ends(packed);
  const answers: Record<string, Answer> = Object.create(null);
  for (const [answer, who] of said) for (const index of who) answers[names[index]!] = answer;
  return { ...rest, answers };
}

const no_counts = { wrong_disjoint: 0, wrong_intersecting: 0, failed: 0, undecided: 0 };

export function expand(report: Report): FullReport {
  const { names, run } = report;
  const cases = report.cases.map((packed) => unpack(packed, names));
  const findings = report.findings.map(({ case: at, ...rest }) => {
    const of = cases[at]!;
    return {
      ...of,
      ...rest,
      margin: rest.margin && ends_of(rest.margin),
      pair_margin: of.margin,
      replay: `./daylight replay ${shell_quoted(`${run.folder}:${rest.id}`)}`,
    };
  });
  const buckets = report.buckets.map((b) => ({
    ...b,
    margin: b.margin && ends_of(b.margin),
    simplest: with_ends(b.simplest),
    worst: with_ends(b.worst),
  }));
  const methods = report.methods.map((m) => {
    const { relative, absolute } = m.claim;
    return { ...m, claim: { ...m.claim, relative: number_of(relative), absolute: number_of(absolute) } };
  });
  const maps = report.maps.map((m) => ({ ...m, cells: m.cells.map((c): MapCell => ({ ...no_counts, ...c })) }));
  return { ...report, methods, buckets, findings, maps };
}

/** How a finding stands against earlier runs: as its bucket does, else as its group. */
export function standings(report: FullReport): (f: Finding) => Standing | null {
  const of_bucket = new Map(report.buckets.map((b) => [b.key, b.standing]));
  const key = (g: { method: string; kind: string; severity: string; family: string }) =>
    [g.method, g.kind, g.severity, g.family].join("\n");
  const of_group = new Map(report.history?.groups.map((g) => [key(g), g.standing]));
  return (f) => (f.bucket !== null ? of_bucket.get(f.bucket) : null) ?? of_group.get(key(f)) ?? null;
}

/** Causes by standing; null if there is no earlier run. */
export function changes_of({ changes }: FullReport): { counts: [Standing, number][]; against: string[] } | null {
  if (!changes || changes.against.length === 0) return null;
  const order: Standing[] = ["new", "back", "known", "rare", "gone"];
  return { counts: order.map((s) => [s, changes[s]]), against: changes.against };
}

/** The methods of some rows, each once, in the order of the run; those that it did not ask last. */
export function in_run_order(report: Pick<Report, "methods">, rows: { method: string }[]): string[] {
  const methods = rows.map((row) => row.method),
    asked = report.methods.map((m) => m.name).filter((name) => methods.includes(name));
  return [...new Set([...asked, ...methods])];
}
