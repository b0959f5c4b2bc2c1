// SPDX-License-Identifier: MIT
// Vectors and the solids that are drawn.
import type { Vec } from "./data.ts";

export const add = (u: Vec, v: Vec): Vec => [u[0] + v[0], u[1] + v[1], u[2] + v[2]];
export const sub = (u: Vec, v: Vec): Vec => [u[0] - v[0], u[1] - v[1], u[2] - v[2]];
export const scale = (u: Vec, k: number): Vec => [u[0] * k, u[1] * k, u[2] * k];
export const dot = (u: Vec, v: Vec) => u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
export const cross = (u: Vec, v: Vec): Vec => [
  u[1] * v[2] - u[2] * v[1],
  u[2] * v[0] - u[0] * v[2],
  u[0] * v[1] - u[1] * v[0],
];

/** The unit vector along one of any finite length, huge or tiny. */
export function unit(v: Vec): Vec {
  const largest = Math.max(Math.abs(v[0]), Math.abs(v[1]), Math.abs(v[2]));
  if (!(largest > 0)) return [0, 0, 1];
  const u: Vec = [v[0] / largest, v[1] / largest, v[2] / largest];
  return scale(u, 1 / Math.sqrt(dot(u, u)));
}

/** Two unit vectors square to n and to each other. */
export function squareTo(n: Vec): [Vec, Vec] {
  const sizes = n.map(Math.abs),
    least = sizes.indexOf(Math.min(...sizes)),
    other = [0, 1, 2].map((i) => Number(i === least)) as Vec;
  const u = unit(cross(n, other));
  return [u, cross(n, u)];
}

/** The unit vectors along the edges of a box. */
export function turnedAxes(quaternion: readonly number[]): Vec[] {
  const largest = Math.max(...quaternion.map(Math.abs)),
    [w, x, y, z] = quaternion.map((c) => c / largest) as [number, number, number, number],
    v: Vec = [x, y, z],
    share = 2 / (w * w + dot(v, v));
  return [0, 1, 2].map((i) => {
    const e = [0, 1, 2].map((j) => Number(i === j)) as Vec,
      once = cross(v, e);
    return add(e, scale(add(scale(once, w), cross(v, once)), share));
  });
}

export interface Solid {
  center: Vec;
  axis: Vec;
  radius: number;
  half: number;
  edges: Vec[]; // of a box: half of each
  rounding: number;
}
/** The length of the longest way from the centre within the core. */
export const coreReach = (s: Solid) => Math.hypot(s.radius, s.half, ...s.edges.flat());
