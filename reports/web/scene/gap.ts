// SPDX-License-Identifier: MIT
// The distances of a robot's solids as the reader sets its joints. The solver computes them, as in the executable.
import type { Cylinder, Vec } from "../parts/data.ts";
import { add, dot, sub } from "../parts/geometry.ts";
import { solve } from "../parts/solver.ts";

export interface Gap {
  distance: number; // negative: the depth
  on_a: Vec; // nearest points, or those that part last
  on_b: Vec;
}

export function gap(a: Cylinder, b: Cylinder): Gap {
  const { value, on_a, on_b } = solve({ a, b }).distance;
  return { distance: value, on_a: add(a.center, on_a), on_b: add(b.center, on_b) };
}

const length = (v: Vec) => Math.sqrt(dot(v, v));

/** No more than the distance: that of the balls around both. */
const leastPossible = (a: Cylinder, b: Cylinder) =>
  length(sub(b.center, a.center)) -
  [a, b].reduce((sum, c) => sum + Math.hypot(c.radius, c.height / 2) + (c.rounding ?? 0), 0);

/** The gap of every pair that may be within a clearance, of as many others as are wanted, the nearest by the balls
 * around them first, and of the nearest of all; null of the rest. */
export function gapsOf(
  cylinders: Cylinder[],
  pairs: readonly (readonly [number, number])[],
  clearance: number,
  wanted: number,
): (Gap | null)[] {
  const low = pairs.map(([i, j]) => leastPossible(cylinders[i]!, cylinders[j]!));
  const order = pairs.map((_, k) => k).sort((p, q) => low[p]! - low[q]!);
  const gaps: (Gap | null)[] = pairs.map(() => null);
  let least = Infinity;
  for (const [rank, k] of order.entries()) {
    if (rank >= wanted && low[k]! > Math.max(clearance, least)) break;
    const [i, j] = pairs[k]!;
    gaps[k] = gap(cylinders[i]!, cylinders[j]!);
    least = Math.min(least, gaps[k].distance);
  }
  return gaps;
}
