// SPDX-License-Identifier: MIT
// The fields of the data that the page reads, as expand() of report.ts gives them. C++ writes the data as
// reports/schemas/report_data.json describes them (reports/run/report_data.*).
// Sections without data are empty. The page names the commands that add them.
import type { Answer, Shown } from "../parts/data.ts";

/** A method. expand() adds its library. */
export interface Doer {
  method: string;
  library: string;
}
export interface Claim {
  relative: number;
  absolute: number;
  source: string;
  stated: boolean; // by the library, source being its line; else assumed by us
}
export interface Method {
  name: string;
  library: string;
  version: string;
  claim: Claim;
  own: boolean;
}
type Counts<Key extends string> = Record<Key, number>;
export interface Tally
  extends Doer, Counts<"asked" | "declined" | "failed" | "contract" | "resolution" | "undecided"> {
  family: string;
}
export type Status = "new" | "known" | "gone";

/** A pair with its truth and all answers. */
export interface Case extends Shown {
  margin: [number, number] | null; // |signed distance| / size, enclosed; of "distance_outside" |error| / size
  answers: Record<string, Answer>;
  replay: string; // the command that asks again
  note?: string; // the origin of the pair, in words
}

export interface Finding extends Case, Doer {
  id: number;
  kind: string;
  severity: string;
  family: string;
  cause: string | null;
  reason?: string;
}

export interface Cause {
  key: string; // "fcl-libccd/wrong_disjoint/side-rim/angle"
  method: string;
  kind: string;
  severity: string;
  labels: string[]; // other causes that apply: "iteration cap", "absolute tolerance", ...
  count: number; // findings, kept or not
  families: string[];
  first_seen: string;
  last_seen: string; // run ids
  status: Status | null;
  asked_before: boolean; // an earlier run tested its method on its families; else it may not be really new
  margin: [number, number] | null; // least and largest lower bound of the margins in it
  simplest: Case;
  worst: Case;
  cause: string; // in words
  methods: string[]; // all that it makes wrong; `method` is one of them
  methods_of_kind: string[]; // those that fail in the way that `kind` names
  libraries: string[]; // of these methods; expand() adds them
  libraries_of_kind: string[];
  first_version: string; // of its method's library, at first and last sight; may be empty
  last_version: string;
  simplified: boolean; // whether `simplest` is; else it is as found
}

/** How often a method was asked and wrong, by cell of a plane. Cells not listed were not visited. */
export interface FailureMap extends Doer {
  plane: string;
  x: { title: string; labels: string[] }; // of bin i its decade
  y: { title: string; labels: string[] };
  cells: MapCell[];
}
/** within_... counts the wrong answers that the claim allows. */
export interface MapCell
  extends
    Counts<"x" | "y" | "asked" | "failed" | "undecided" | "declined">,
    Counts<"wrong_disjoint" | "wrong_intersecting" | "within_disjoint" | "within_intersecting"> {
  finding?: number;
}
/** Share wrong against margin: the rows of a map of angle and margin. Bin d holds margins in (10^(-d-1), 10^-d], and
 *  the last one all below. */
export interface Calibration extends Doer {
  bins: { decade: number; asked: number; wrong_disjoint: number; wrong_intersecting: number; declined: number }[];
}

/** Speed against accuracy, from `daylight bench`. `digits` is -log10 of the least margin from which on the method was
 *  always right. `digits_low` is the part that the number of pairs shows with 95 % confidence. */
export interface SpeedPoint extends Doer, Counts<"ns" | "asked" | "wrong_disjoint" | "wrong_intersecting"> {
  curve: string; // methods that differ in a setting only share it
  setting: string;
  family: string; // or "all"
  query: string;
  p99: number | null;
  digits: number | null;
  digits_low: number | null;
}
/** Along a path of pairs through touching or through a special position of the axes, the worst of two seeds. */
export interface PathStability extends Counts<"steps" | "flips"> {
  method: string;
  path: string;
  distance_jump: number | null;
  direction_jump_degrees: number | null;
}
export interface Report {
  run: Record<"id" | "seed" | "started" | "status" | "build" | "folder", string> &
    Counts<"pairs" | "seconds">;
  methods: Method[];
  families: { name: string; summary: string }[];
  tallies: Tally[];
  causes: Cause[];
  findings: Finding[];
  findings_total: number;
  unreadable: number; // findings whose records hold no pair, and are left out
  maps: FailureMap[];
  calibration: Calibration[];
  speed: SpeedPoint[];
  paths: PathStability[];
  speed_on?: string; // the machine, compiler and date of these times
}
