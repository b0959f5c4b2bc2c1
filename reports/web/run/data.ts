// SPDX-License-Identifier: MIT
// What the page is given: one JSON object, compressed (zlib) and in base64, in <script id="report-data">. C++ writes it
// (reports/run/report_data.*); numbers are shortest round-trip decimals, so that JSON.parse gives the doubles back,
// and "inf" or "-inf" of an open end of a distance, a margin or a claim (expand() makes numbers of them).
// Sections that a run has nothing for are null or empty: the page says so and how to get them.
import type { Answer, Pair, Truth, Vec, Verdict } from "../parts/data.ts";
import type { Columns } from "./columns.ts";

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
export interface Tally {
  method: string;
  family: string;
  asked: number;
  declined: number;
  failed: number;
  contract: number;
  resolution: number;
  undecided: number;
}
/** "rare": on so few pairs that its absence from the other runs may be chance. */
export type Standing = "new" | "known" | "gone" | "back" | "rare";

/** A pair with all that is known of it. */
export interface Case {
  pair: Pair;
  truth: Truth;
  margin: [number, number] | null; // |signed distance| / size, enclosed; a finding's own, see below
  direction?: Vec; // unit, from a to b, where the signed distance is attained
  nearest?: { a: Vec; b: Vec }; // nearest points (apart) or deepest (overlapping), where known
  answers: Record<string, Answer>;
  replay: string; // the command that asks again
  note?: string; // where the pair comes from, in words
}

type Severity = "contract" | "resolution" | "unresolved";
/** Its margin is its own: of "distance_outside" |error| / size, of others the pair's. */
export interface Finding extends Case {
  id: number;
  pair_margin: [number, number] | null;
  method: string;
  kind: string;
  severity: Severity;
  family: string;
  bucket: string | null;
  reason?: string;
}

/** What is written of a finding: the fields of Case are those of cases[case], its replay is of the run's folder and
 *  its id. */
interface PackedFinding extends Omit<Finding, keyof Case | "pair_margin"> {
  margin: [number, number] | null;
  case: number;
}
/** A pair of many findings, once: each different answer with who gave it, as indices into Report.names. Directions
 *  and points of answers are there only of the methods that have a finding on the pair. */
export interface PackedCase extends Omit<Case, "answers" | "replay"> {
  said: [Answer, number[]][];
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
  feature: string;
  coordinate: string;
  labels: string[]; // other causes that apply: "iteration cap", "absolute tolerance", ...
  merged: string[]; // keys that led to the same cause
  count: number; // findings, kept or not
  families: string[];
  first_seen: string;
  last_seen: string; // run ids
  standing: Standing | null;
  margin: [number, number] | null; // least and largest lower bound of the margins in it
  share: { wrong: number; asked: number } | null; // of the stratum it is in
  simplest: Case;
  worst: Case;
  suppressed: { reason: string; link: string; owner: string; expires: string } | null;
  findings: number[]; // ids of those kept
  cause: string; // in words
  methods: string[]; // all that it makes wrong; `method` is one of them
  methods_of_kind: string[]; // those that fail in the way that `kind` names
  nights: Night[]; // oldest first, this run last
  pairs: number; // on which one of its methods was wrong in this run
  first_version: string; // of its method's library, at first and last sight; may be empty
  last_version: string;
  simplified: boolean; // whether `simplest` is; else it is as found
  file: string; // JSON Lines, with its pair
}

/** How often a method was asked and wrong, by cell of a plane. Cells not listed were not visited. */
export interface FailureMap {
  method: string;
  plane: "angle-margin" | "aspect-margin" | "scale-offset";
  x: Axis;
  y: Axis;
  cells: MapCell[]; // a count that is missing is 0
}
export interface MapCell {
  x: number;
  y: number;
  asked: number;
  wrong_disjoint: number;
  wrong_intersecting: number;
  failed: number;
  undecided: number;
  declined?: number;
  within_disjoint?: number; // of wrong_disjoint, those that the claim allows
  within_intersecting?: number;
  finding?: number;
}
/** Bins are numbered from 0; labels[i] names bin i, its decade. */
interface Axis {
  title: string;
  labels: string[];
}

/** Share wrong against margin: bin d holds margins in (10^(-d-1), 10^-d]; the last all below. */
export interface Calibration {
  method: string;
  family: string | null;
  bins: {
    decade: number;
    asked: number;
    wrong_disjoint: number;
    wrong_intersecting: number;
    undecided: number;
    declined?: number;
  }[];
}

/** From `daylight bench`: speed against accuracy. `digits`: -log10 of the least margin from which on the method was
 * always right; `digits_low`: the same where at most that share is wrong with 95 % confidence. */
export interface SpeedPoint {
  method: string;
  curve: string;
  setting: string; // curve: methods that differ in a setting only share it; setting as a number or word
  family: string; // or "all"
  query: "verdict" | "batch" | "certificate" | "distance";
  ns: number;
  p99: number | null;
  max: number | null;
  asked: number;
  wrong_disjoint: number;
  wrong_intersecting: number;
  digits: number | null;
  digits_low: number | null;
}
/** Along a path of pairs through touching or through parallel axes. */
export interface PathStability {
  method: string;
  path: string;
  steps: number;
  flips: number;
  distance_jump: number | null;
  direction_jump_degrees: number | null;
  trace?: { at: number; verdict: Verdict; distance: number | null }[];
}
export interface Report {
  schema: 1;
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
  /** Causes by how they stand against the runs named. */
  changes: ({ [standing in Standing]: number } & { against: string[] }) | null;
  buckets: (Omit<Cause, "worst"> & { worst: Case | null })[];
  findings: PackedFinding[] | Columns;
  findings_total: number;
  cases: PackedCase[];
  names: string[];
  unreadable?: number; // findings whose records hold no pair, and are left out
  maps: (Omit<FailureMap, "cells"> & { cells: MapCell[] | Columns })[];
  honesty: Calibration[];
  speed: SpeedPoint[];
  speed_on?: string; // the machine, compiler and date of these times
  paths: PathStability[];
}
