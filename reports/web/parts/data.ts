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
export interface Pair {
  a: Cylinder;
  b: Cylinder;
}
