// SPDX-License-Identifier: MIT
// The fields of the data that the page reads, as expand() of report.ts gives them. C++ writes the data as
// reports/schemas/report_data.json describes them (reports/run/report_data.*).
// Sections that a run has nothing for are null or empty: the page says so and how to get them.
import type { Answer, Shown, Verdict } from "../parts/data.ts";

/** Who did it. expand() adds the library. */
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
  share: number;
}
export interface Tally extends Doer {
  family: string;
  asked: number;
  declined: number;
  failed: number;
  contract: number;
  resolution: number;
  undecided: number;
}
/** "rare": on so few pairs that its absence from the other runs may be chance. */
export type Standing = "new" | "back" | "rare" | "known" | "gone";

/** A pair with all that is known of it. */
export interface Case extends Shown {
  margin: [number, number] | null; // |signed distance| / size, enclosed; of "distance_outside" |error| / size
  answers: Record<string, Answer>;
  replay: string; // the command that asks again
  note?: string; // where the pair comes from, in words
}

export interface Finding extends Case, Doer {
  id: number;
  kind: string;
  severity: string;
  family: string;
  bucket: string | null;
  reason?: string;
}

/** On how many pairs a cause was seen in one run; the rate is of a million pairs, with its bounds. */
export interface Night {
  run: string;
  started: string;
  count: number;
  asked: number;
  per_million: [number, number, number]; // rate, low, high
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
  standing: Standing | null;
  margin: [number, number] | null; // least and largest lower bound of the margins in it
  simplest: Case;
  worst: Case;
  suppressed: { reason: string; link: string; owner: string; expires: string } | null;
  findings: number[]; // ids of those kept
  cause: string; // in words
  methods: string[]; // all that it makes wrong; `method` is one of them
  methods_of_kind: string[]; // those that fail in the way that `kind` names
  libraries: string[]; // of these methods; expand() adds them
  libraries_of_kind: string[];
  nights: Night[]; // oldest first, this run last
  pairs: number; // on which one of its methods was wrong in this run
  first_version: string; // of its method's library, at first and last sight; may be empty
  last_version: string;
  simplified: boolean; // whether `simplest` is; else it is as found
}

/** How often a method was asked and wrong, by cell of a plane. Cells not listed were not visited. */
export interface FailureMap extends Doer {
  plane: string;
  x: Axis;
  y: Axis;
  cells: MapCell[];
}
export interface MapCell {
  x: number;
  y: number;
  asked: number;
  wrong_disjoint: number;
  wrong_intersecting: number;
  failed: number;
  undecided: number;
  declined: number;
  within_disjoint: number; // of wrong_disjoint, those that the claim allows
  within_intersecting: number;
  finding?: number;
}
/** Bins are numbered from 0; labels[i] names bin i, its decade. */
interface Axis {
  title: string;
  labels: string[];
}

/** Share wrong against margin: bin d holds margins in (10^(-d-1), 10^-d]; the last all below. */
export interface Calibration extends Doer {
  family: string | null;
  bins: { decade: number; asked: number; wrong_disjoint: number; wrong_intersecting: number; declined?: number }[];
}

/** From `daylight bench`: speed against accuracy. `digits`: -log10 of the least margin from which on the method was
 * always right; `digits_low`: the same where at most that share is wrong with 95 % confidence. */
export interface SpeedPoint extends Doer {
  curve: string;
  setting: string; // curve: methods that differ in a setting only share it; setting as a number or word
  family: string; // or "all"
  query: string;
  ns: number;
  p99: number | null;
  asked: number;
  wrong_disjoint: number;
  wrong_intersecting: number;
  digits: number | null;
  digits_low: number | null;
}
/** Along a path of pairs through touching or through parallel axes. */
export interface PathStability extends Doer {
  path: string;
  steps: number;
  flips: number;
  distance_jump: number | null;
  direction_jump_degrees: number | null;
  trace?: { at: number; verdict: Verdict; distance: number | null }[];
}
export interface Report {
  run: {
    id: string;
    seed: string;
    pairs: number;
    started: string;
    status: string;
    seconds: number;
    build: string;
    command: string;
    folder: string;
  };
  methods: Method[];
  families: { name: string; summary: string }[];
  tallies: Tally[];
  against: string[]; // the earlier runs that the causes were compared with
  buckets: Cause[];
  findings: Finding[];
  findings_total: number;
  unreadable: number; // findings whose records hold no pair, and are left out
  maps: FailureMap[];
  honesty: Calibration[];
  speed: SpeedPoint[];
  speed_on?: string; // the machine, compiler and date of these times
  paths: PathStability[];
}
