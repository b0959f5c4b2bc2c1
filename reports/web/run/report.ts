// SPDX-License-Identifier: MIT
// The data of the page, put into the form of data.ts: every finding with its case, every row with its library. Causes
// and findings keep their order.
import { group, sort, sum } from "d3-array";
import type { Answer } from "../parts/data.ts";
import { shellQuoted, short } from "../parts/words.ts";
import type { Calibration, Cause, FailureMap, Finding, Method, Report, SpeedPoint } from "./data.ts";

/** JSON as it was written; the schema describes it. */
type Packed = any;

const ownNames = ["intersect", "decide", "distance", "exact"];
/** The library of a method; of one that the run did not ask, the name up to the first '-'. */
function libraryOf(methods: Method[]) {
  const known = new Map(methods.map((m) => [m.name, m.library]));
  return (method: string) =>
    known.get(method) ?? (ownNames.includes(method) ? "ours" : method.split("-", 1)[0]!);
}

/** JSON has no number beyond the doubles: "inf" and "-inf" stand for them. */
const numberOf = (x: Packed) => (x === "inf" ? Infinity : x === "-inf" ? -Infinity : Number(x));
function withEnds(of: Packed): Packed {
  const { truth, margin } = of;
  return {
    ...of,
    ...(truth?.distance && { truth: { ...truth, distance: truth.distance.map(numberOf) } }),
    margin: margin && margin.map(numberOf),
  };
}

/** Each different answer stands once, with who gave it. */
function caseOf({ said, ...rest }: Packed): Packed {
  const answers: Record<string, Answer> = Object.create(null);
  for (const [answer, who] of said) for (const name of who) answers[name] = answer;
  return { ...withEnds(rest), answers };
}

/** The bins of the angle: C++ numbers them by the sine near parallel and by the cosine near perpendicular. */
function inDegrees(map: FailureMap): FailureMap {
  if (map.plane !== "angle-margin") return map;
  const middle = map.x.labels.indexOf("oblique"),
    degrees = (label: string) => `${short((Math.asin(Number(label)) * 180) / Math.PI, 2)}\u00b0`;
  const labels = map.x.labels.map((label, i) =>
    Number.isNaN(Number(label)) || middle < 0 ? label : i < middle ? degrees(label) : `90\u2212${degrees(label)}`,
  );
  return { ...map, x: { title: "angle of the axes, from parallel to perpendicular", labels } };
}
const noCounts = {
  ...{ wrong_disjoint: 0, wrong_intersecting: 0, within_disjoint: 0, within_intersecting: 0 },
  ...{ failed: 0, undecided: 0, declined: 0 },
};

/** The rows of a map of angle and margin. Touching pairs are in the last decade. */
function calibrationOf({ method, library, y, cells }: FailureMap): Calibration {
  const decades = group(cells, (c) => Math.min(c.y, y.labels.length - 2));
  const bins = sort(decades, ([decade]) => decade).map(([decade, of]) => ({
    decade,
    asked: sum(of, (c) => c.asked),
    wrong_disjoint: sum(of, (c) => c.wrong_disjoint),
    wrong_intersecting: sum(of, (c) => c.wrong_intersecting),
    declined: sum(of, (c) => c.declined),
  }));
  return { method, library, bins };
}

export function expand({ cases, ...packed }: Packed): Report {
  const library = libraryOf(packed.methods),
    librariesOf = (of: string[]) => [...new Set(of.map(library))],
    withLibrary = (row: Packed) => ({ ...row, library: library(row.method) });
  const unpacked = cases.map(caseOf);
  const findings: Finding[] = packed.findings.map(({ case: at, ...f }: Packed) => ({
    ...unpacked[at],
    ...withLibrary(f),
    margin: f.margin && f.margin.map(numberOf),
    replay: `./daylight replay ${shellQuoted(`${packed.run.folder}:${f.id}`)}`,
  }));
  const causes: Cause[] = packed.causes.map((b: Packed) => ({
    ...withEnds(b),
    libraries: librariesOf(b.methods),
    libraries_of_kind: librariesOf(b.methods_of_kind),
    simplest: withEnds(b.simplest),
    worst: withEnds(b.worst ?? b.simplest), // no hang is worse than another
  }));
  const maps: FailureMap[] = packed.maps.map((m: Packed) =>
    inDegrees(withLibrary({ ...m, cells: m.cells.map((c: Packed) => ({ ...noCounts, ...c })) })),
  );
  return {
    ...packed,
    unreadable: packed.unreadable ?? 0,
    methods: packed.methods.map((m: Packed) => ({
      ...m,
      claim: { ...m.claim, relative: numberOf(m.claim.relative), absolute: numberOf(m.claim.absolute) },
    })),
    causes,
    findings,
    maps,
    tallies: packed.tallies.map(withLibrary),
    calibration: maps.filter((m) => m.plane === "angle-margin").map(calibrationOf),
    speed: packed.speed.filter((p: SpeedPoint) => p.family === "all").map(withLibrary),
  };
}

/** The accuracies that engines claim as a length, in digits of a size of 1, each library once. */
export function claimedDigits({ methods }: Report): number[] {
  const first = methods.filter((m, i) => methods.findIndex((n) => n.library === m.library) === i);
  return first
    .filter((m) => !m.own && m.claim.relative === 0 && m.claim.absolute > 0)
    .map((m) => -Math.log10(m.claim.absolute));
}
