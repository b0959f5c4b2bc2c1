// SPDX-License-Identifier: MIT
// The data of the page, put back to the form of data.ts: every finding with its case.
import { shellQuoted, short } from "../parts/words.ts";
import type { Answer, Truth } from "../parts/data.ts";
import { objectsOf, type Columns } from "./columns.ts";
import type { Cause, Case, FailureMap, Finding, MapCell } from "./data.ts";
import type { PackedCase, Report, Standing } from "./data.ts";
import { library, nameLibraries } from "./words.ts";

export interface FullReport extends Omit<Report, "findings" | "buckets" | "cases" | "names" | "maps"> {
  findings: Finding[];
  maps: FailureMap[];
  buckets: Cause[];
}

type Ends = [number, number];
/** JSON has no number beyond the doubles: "inf" and "-inf" stand for them. */
const numberOf = (x: unknown) => (x === "inf" ? Infinity : x === "-inf" ? -Infinity : Number(x));
const endsOf = (ends: Ends): Ends => [numberOf(ends[0]), numberOf(ends[1])];
const withEnds = <T extends { truth: Truth; margin: Ends | null }>(of: T): T => ({
  ...of,
  truth: of.truth.distance ? { ...of.truth, distance: endsOf(of.truth.distance) } : of.truth,
  margin: of.margin && endsOf(of.margin),
});

function unpack(packed: PackedCase, names: string[]): Omit<Case, "replay"> {
  const { said, ...rest } = withEnds(packed);
  const answers: Record<string, Answer> = Object.create(null);
  for (const [answer, who] of said) for (const index of who) answers[names[index]!] = answer;
  return { ...rest, answers };
}

const noCounts = { wrong_disjoint: 0, wrong_intersecting: 0, failed: 0, undecided: 0 };

/** The bins of the angle: C++ numbers them by the sine near parallel and by the cosine near perpendicular. */
function inDegrees(map: FailureMap): FailureMap {
  if (map.plane !== "angle-margin") return map;
  const middle = map.x.labels.indexOf("oblique"),
    degrees = (label: string) => short((Math.asin(Number(label)) * 180) / Math.PI, 2);
  const labels = map.x.labels.map((label, i) =>
    Number.isNaN(Number(label)) || middle < 0
      ? label
      : i < middle
        ? `${degrees(label)}\u00b0`
        : `90\u2212${degrees(label)}\u00b0`,
  );
  return { ...map, x: { title: "angle of the axes, from parallel to perpendicular", labels } };
}

function findingsOf({ names, run, ...report }: Report): Finding[] {
  const cases = report.cases.map((packed) => unpack(packed, names));
  return objectsOf(report.findings).map(({ case: at, ...rest }) => {
    const of = cases[at]!;
    return {
      ...of,
      ...rest,
      margin: rest.margin && endsOf(rest.margin),
      pair_margin: of.margin,
      replay: `./daylight replay ${shellQuoted(`${run.folder}:${rest.id}`)}`,
    };
  });
}

export function expand(report: Report): FullReport {
  const buckets = report.buckets.map((b) => ({
    ...b,
    margin: b.margin && endsOf(b.margin),
    simplest: withEnds(b.simplest),
    worst: withEnds(b.worst ?? b.simplest), // a hang is not searched for a worse one
  }));
  nameLibraries(report.methods);
  const methods = report.methods.map((m) => {
    const { relative, absolute } = m.claim;
    return { ...m, claim: { ...m.claim, relative: numberOf(relative), absolute: numberOf(absolute) } };
  });
  const cellsOf = (cells: MapCell[] | Columns) => objectsOf(cells).map((c): MapCell => ({ ...noCounts, ...c }));
  return {
    ...report,
    methods,
    buckets,
    findings: findingsOf(report),
    maps: report.maps.map((m) => inDegrees({ ...m, cells: cellsOf(m.cells) })),
  };
}

/** How a finding stands against earlier runs: as its cause does. */
export function standingOf(report: FullReport): (f: Finding) => Standing | null {
  const ofCause = new Map(report.buckets.map((b) => [b.key, b.standing]));
  return (f) => (f.bucket === null ? null : (ofCause.get(f.bucket) ?? null));
}

/** Causes by standing; null if there is no earlier run. */
export function changesOf({ changes }: FullReport): { counts: [Standing, number][]; against: string[] } | null {
  if (!changes || changes.against.length === 0) return null;
  const order: Standing[] = ["new", "back", "rare", "known", "gone"];
  return { counts: order.map((s) => [s, changes[s]]), against: changes.against };
}

/** The methods of some rows, each once, in the order of the run; those that it did not ask last. */
export function inRunOrder(report: Pick<Report, "methods">, rows: { method: string }[]): string[] {
  const methods = rows.map((row) => row.method),
    asked = report.methods.map((m) => m.name).filter((name) => methods.includes(name));
  return [...new Set([...asked, ...methods])];
}

/** The accuracies that engines claim as a length, in digits of a size of 1, each library once. */
export function claimedDigits({ methods }: Pick<Report, "methods">): number[] {
  const first = methods.filter((m, i) => methods.findIndex((n) => library(n.name) === library(m.name)) === i);
  return first
    .filter((m) => !m.own && m.claim.relative === 0 && m.claim.absolute > 0)
    .map((m) => -Math.log10(m.claim.absolute));
}
