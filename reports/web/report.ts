// SPDX-License-Identifier: MIT
// The data of the page, put back to the form of data.ts: every finding with its case.
import type { Answer, Bucket, Case, Finding, PackedCase, Report, Standing } from "./data.ts";
import { shell_quoted } from "./words.ts";

export interface FullReport extends Report {
  findings: Finding[];
}

function unpack(packed: PackedCase, names: string[]): Omit<Case, "replay"> {
  const { said, ...rest } = packed;
  const answers: Record<string, Answer> = Object.create(null);
  for (const [answer, who] of said) for (const index of who) answers[names[index]!] = answer;
  return { ...rest, answers };
}

export function expand(report: Report): FullReport {
  const names = report.names ?? [];
  const cases = (report.cases ?? []).map((packed) => unpack(packed, names));
  const folder = report.run.folder ?? report.run.id;
  const findings = report.findings.map((f) => {
    if (!("case" in f)) return { ...f, pair_margin: f.margin };
    const { case: at, ...rest } = f,
      of = cases[at]!;
    return {
      ...of,
      ...rest,
      margin: f.margin === undefined ? of.margin : f.margin,
      pair_margin: of.margin,
      replay: `./daylight replay ${shell_quoted(`${folder}:${f.id}`)}`,
    };
  });
  const buckets = report.buckets.map((b): Bucket => {
    const { first_version: first, last_version: last } = b;
    return first && !b.versions ? { ...b, versions: { first, last: last || first } } : b;
  });
  return { ...report, buckets, findings, cases: [] };
}

/** From the element that the C++ side fills; a template that nobody filled has none. */
export function data_of(document: Document): unknown {
  const text = document.getElementById("report-data")?.textContent ?? "";
  return text.startsWith("{") ? JSON.parse(text) : null;
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
