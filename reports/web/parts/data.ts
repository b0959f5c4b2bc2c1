// SPDX-License-Identifier: MIT
// Numbers, solids and pairs, as C++ writes them. Numbers are shortest round-trip decimals: JSON.parse returns the same
// doubles.

export type Verdict = "disjoint" | "intersecting" | "touching" | "undecided" | "invalid";
export type Vec = [number, number, number];
/** An exact coordinate: a double, doubles that stand for their exact sum, or a rational "n/d". */
export type Coordinate = number | number[] | string;

export interface Cylinder {
  center: Vec;
  axis: Vec;
  radius: number;
  height: number;
  rounding?: number; // all points within this of the cylinder, which is its core
}
/** All points behind a plane; the normal points outward and has any length. */
export interface HalfSpace {
  shape: "half_space";
  point: Vec;
  normal: Vec;
}
/** The quaternion [w, x, y, z] turns it. It has any length, and is 1, 0, 0, 0 by default. */
export interface Box {
  shape: "box";
  center: Vec;
  edges: Vec; // full lengths
  quaternion?: [number, number, number, number];
  rounding?: number;
}
export type Solid = Cylinder | HalfSpace | Box;
export const isHalfSpace = (s: Solid): s is HalfSpace => "shape" in s && s.shape === "half_space";
export const isBox = (s: Solid): s is Box => "shape" in s && s.shape === "box";
/** At most one is a half-space. */
export interface Pair {
  a: Solid;
  b: Solid;
}

/** The plane, line or point in which a flat solid lies. It places a point more exactly than doubles can. */
export type Hull = "space" | "plane" | "line" | "center";

/** As one line of `daylight check --distance`. */
export interface Truth {
  verdict: Verdict;
  direction?: Coordinate[];
  point?: Coordinate[];
  points?: [Coordinate[], Coordinate[]]; // one of a's core, one of b's
  near?: { point?: Coordinate[]; points?: [Coordinate[], Coordinate[]]; direction: Coordinate[] };
  hulls?: [Hull, Hull]; // of a and b; `point` stands for the nearest point in both, `points` for those in their own
  distance?: [number, number];
  stage?: "filter" | "wide" | "exact";
}

/** The answer of a method, as in a run's store. */
export interface Answer {
  verdict?: Verdict;
  distance?: number;
  direction?: number[];
  point?: Coordinate[];
  points?: [Coordinate[], Coordinate[]];
  declined?: string;
  failed?: string;
  reason?: string;
}

/** A pair with the data that its drawing needs. */
export interface Shown {
  pair: Pair;
  truth: Truth;
  direction?: Vec; // unit, from a to b, along which the signed distance is attained
  nearest?: { a: Vec; b: Vec }; // nearest points (apart) or deepest (overlapping), if known
}
