// SPDX-License-Identifier: MIT
// The data of the page, put back to the form of data.ts: every finding with its case.
import { shell_quoted } from "../parts/words.ts";
import type { Answer, Bucket, Case, Finding, MapCell, PackedCase, Report, Standing, Truth } from "./data.ts";

export interface FullReport extends Report {
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
  const names = report.names ?? [];
  const cases = (report.cases ?? []).map((packed) => unpack(packed, names));
  const folder = report.run.folder ?? report.run.id;
  const findings = report.findings.map((f) => {
    if (!("case" in f)) return { ...with_ends(f), pair_margin: f.margin && ends_of(f.margin) };
    const { case: at, ...rest } = f,
      of = cases[at]!;
    return {
      ...of,
      ...rest,
      margin: f.margin === undefined ? of.margin : f.margin && ends_of(f.margin),
      pair_margin: of.margin,
      replay: `./daylight replay ${shell_quoted(`${folder}:${f.id}`)}`,
    };
  });
  const buckets = report.buckets.map((b): Bucket => {
    const { first_version: first, last_version: last } = b;
    const margin = b.margin && ends_of(b.margin),
      shown = { margin, simplest: with_ends(b.simplest), worst: b.worst && with_ends(b.worst) };
    return { ...b, ...shown, ...(first && !b.versions ? { versions: { first, last: last || first } } : {}) };
  });
  const methods = report.methods.map((m) => {
    const { relative, absolute } = m.claim;
    return { ...m, claim: { ...m.claim, relative: number_of(relative), absolute: number_of(absolute) } };
  });
  const maps = report.maps.map((m) => ({ ...m, cells: m.cells.map((c): MapCell => ({ ...no_counts, ...c })) }));
  return { ...report, methods, buckets, findings, maps, cases: [] };
}

/** How a finding stands against earlier runs: as its bucket does, else as its group. */
export function standings(report: FullReport): (f: Finding) => Standing | null {
  const of_bucket = new Map(report.buckets.map((b) => [b.key, b.standing]));
  const key = (g: { method: string; kind: string; severity: string; family: string }) =>
    [g.method, g.kind, g.severity, g.family].join("\n");
  const of_group = new Map(report.history?.groups.map((g) => [key(g), g.standing]));
  return (f) => (f.bucket !== null ? of_bucket.get(f.bucket) : null) ?? of_group.get(key(f)) ?? null;
}

/** Causes by standing: as counted, else from the causes themselves; null where there is no earlier run. */
export function changes_of(report: FullReport): { counts: Map<Standing, number>; against: string[] } | null {
  const order: Standing[] = ["new", "back", "known", "rare", "gone"];
  const { changes, buckets } = report;
  if (changes) {
    if (changes.against.length === 0) return null;
    return { counts: new Map(order.map((s) => [s, changes[s] ?? 0])), against: changes.against };
  }
  if (!buckets.some((b) => b.standing)) return null;
  return { counts: new Map(order.map((s) => [s, buckets.filter((b) => b.standing === s).length])), against: [] };
}

/** The methods, each once, in the order of the run; those it did not ask last. */
export function in_run_order(report: Report, methods: string[]): string[] {
  const asked = report.methods.map((m) => m.name).filter((name) => methods.includes(name));
  return [...new Set([...asked, ...methods])];
}
