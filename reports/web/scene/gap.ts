// SPDX-License-Identifier: MIT
// The distance of two rounded solids, in doubles and without proof: a convex search (Gilbert, Johnson, Keerthi) between
// their cores, and where the cores overlap the least way that parts them.
import type { Cylinder, Vec } from "../parts/data.ts";
import { add, cross, dot, scale, squareTo, sub, unit } from "../parts/geometry.ts";

export interface Gap {
  distance: number; // negative: the depth
  on_a: Vec; // nearest points, or those that part last
  on_b: Vec;
}

const length = (v: Vec) => Math.sqrt(dot(v, v));

/** A vector without its part along an axis. A second step takes away what rounding left: much, of a short one. */
function squarePart(v: Vec, axis: Vec): Vec {
  const once = sub(v, scale(axis, dot(v, axis)));
  return sub(once, scale(axis, dot(once, axis)));
}

/** The point of a core that is farthest in a direction. */
function farthest(c: Cylinder, axis: Vec, d: Vec): Vec {
  const along = dot(d, axis),
    across = squarePart(d, axis),
    wide = length(across);
  const end = add(c.center, scale(axis, (Math.sign(along) * c.height) / 2));
  return wide > 1e-15 * length(d) ? add(end, scale(across, c.radius / wide)) : end;
}

/** A point of the difference of two cores, and the points that it is the difference of. */
interface Corner {
  w: Vec;
  a: Vec;
  b: Vec;
}

/** The weights of the point nearest to the origin of the plane through some points; null where they lie in less. */
function weights(points: Vec[]): number[] | null {
  const [first, ...others] = points as [Vec, ...Vec[]],
    sides = others.map((p) => sub(p, first)),
    n = sides.length;
  const rows = sides.map((u) => [...sides.map((v) => dot(u, v)), -dot(u, first)]);
  for (let k = 0; k < n; ++k) {
    let best = k;
    for (let i = k + 1; i < n; ++i) if (Math.abs(rows[i]![k]!) > Math.abs(rows[best]![k]!)) best = i;
    [rows[k], rows[best]] = [rows[best]!, rows[k]!];
    const head = rows[k]!;
    if (!(Math.abs(head[k]!) > 1e-300)) return null;
    for (let i = 0; i < n; ++i)
      if (i !== k) {
        const by = rows[i]![k]! / head[k]!;
        for (let j = k; j <= n; ++j) rows[i]![j]! -= by * head[j]!;
      }
  }
  const rest = rows.map((row, k) => row[n]! / row[k]!);
  return [1 - rest.reduce((s, x) => s + x, 0), ...rest];
}

const mixed = (points: Vec[], share: number[]) =>
  points.reduce<Vec>((sum, p, i) => add(sum, scale(p, share[i]!)), [0, 0, 0]);

/** The part of a simplex whose inside holds its point nearest to the origin. */
function nearest(simplex: Corner[]): { kept: Corner[]; share: number[]; v: Vec } {
  let best: { kept: Corner[]; share: number[]; v: Vec } | null = null;
  for (let set = 1; set < 1 << simplex.length; ++set) {
    const kept = simplex.filter((_, i) => set & (1 << i)),
      points = kept.map(({ w }) => w),
      share = weights(points);
    if (!share || share.some((x) => !(x >= 0))) continue;
    const v = mixed(points, share);
    if (!best || dot(v, v) < dot(best.v, best.v)) best = { kept, share, v };
  }
  return best!;
}

/** Relative to the lengths that go into it: what the search leaves open. */
const closeEnough = 1e-10;
const mostSteps = 200;

/** null where the cores meet, or are as good as touching. */
function betweenCores(a: Cylinder, b: Cylinder, u: Vec, v: Vec, size: number): { a: Vec; b: Vec } | null {
  const corner = (d: Vec): Corner => {
    const on_a = farthest(a, u, scale(d, -1)),
      on_b = farthest(b, v, d);
    return { w: sub(on_a, on_b), a: on_a, b: on_b };
  };
  const away = sub(a.center, b.center);
  let simplex = [corner(dot(away, away) > 0 ? away : [1, 0, 0])];
  let at = nearest(simplex);
  for (let step = 0; step < mostSteps; ++step) {
    const far = length(at.v);
    if (far <= 1e-12 * size || at.kept.length === 4) return null;
    const next = corner(at.v);
    if (far - dot(at.v, next.w) / far <= closeEnough * size) break;
    simplex = [...at.kept, next];
    const then = nearest(simplex);
    if (!(dot(then.v, then.v) < far * far)) break;
    at = then;
  }
  const points = (side: "a" | "b") => mixed(at.kept.map((c) => c[side]), at.share);
  return { a: points("a"), b: points("b") };
}

/** The least of a function near x, which stands for a direction or an angle: the steps around it get shorter. */
function descended<X>(x: X, of: (x: X) => number, around: (x: X, step: number) => X[], from: number): X {
  let best = of(x);
  for (let step = from; step > 1e-7; ) {
    const tried = around(x, step).map((y) => [of(y), y] as const);
    const least = tried.reduce((p, q) => (q[0] < p[0] ? q : p));
    if (least[0] < best) [best, x] = least;
    else step /= 2;
  }
  return x;
}

/** The direction in which b leaves a on the shortest way. The way has bends where a direction is along or square to an
 * axis: those are looked at by themselves. */
function wayOut(a: Cylinder, b: Cylinder, u: Vec, v: Vec): { n: Vec; depth: number } {
  const apart = sub(b.center, a.center);
  const reach = (c: Cylinder, axis: Vec, n: Vec) => {
    const along = dot(n, axis);
    return c.radius * length(sub(n, scale(axis, along))) + (c.height / 2) * Math.abs(along);
  };
  const depth = (n: Vec) => reach(a, u, n) + reach(b, v, n) - dot(n, apart);
  const bestOf = (all: Vec[], count: number) => [...all].sort((m, n) => depth(m) - depth(n)).slice(0, count);
  const found: Vec[] = [u, v, cross(u, v), apart]
    .filter((n) => dot(n, n) > 1e-20)
    .flatMap((n) => [unit(n), scale(unit(n), -1)]);
  const ball = Array.from({ length: 200 }, (_, i): Vec => {
    const z = (2 * i + 1) / 200 - 1,
      wide = Math.sqrt(1 - z * z),
      t = i * Math.PI * (3 - Math.sqrt(5));
    return [wide * Math.cos(t), wide * Math.sin(t), z];
  });
  for (const start of bestOf([...ball, ...found], 6))
    found.push(
      descended(
        start,
        depth,
        (n, step) => {
          const [p, q] = squareTo(n);
          return Array.from({ length: 8 }, (_, i) => (i * Math.PI) / 4).map((t) =>
            unit(add(n, add(scale(p, step * Math.cos(t)), scale(q, step * Math.sin(t))))),
          );
        },
        0.1,
      ),
    );
  for (const axis of [u, v]) {
    const [p, q] = squareTo(axis),
      at = (t: number) => add(scale(p, Math.cos(t)), scale(q, Math.sin(t)));
    const of = (t: number) => depth(at(t)),
      turns = Array.from({ length: 48 }, (_, i) => (i * Math.PI) / 24).sort((s, t) => of(s) - of(t));
    for (const t of turns.slice(0, 4)) found.push(at(descended(t, of, (s, step) => [s - step, s + step], 0.1)));
  }
  const [n] = bestOf(found, 1) as [Vec];
  return { n, depth: depth(n) };
}

export function gap(a: Cylinder, b: Cylinder): Gap {
  const u = unit(a.axis),
    v = unit(b.axis),
    softA = a.rounding ?? 0,
    softB = b.rounding ?? 0;
  const size = a.radius + a.height + b.radius + b.height + length(sub(b.center, a.center));
  const cores = betweenCores(a, b, u, v, size);
  if (cores) {
    const way = sub(cores.b, cores.a),
      far = length(way),
      n = unit(way);
    return {
      distance: far - softA - softB,
      on_a: add(cores.a, scale(n, softA)),
      on_b: sub(cores.b, scale(n, softB)),
    };
  }
  const { n, depth } = wayOut(a, b, u, v),
    on_a = add(farthest(a, u, n), scale(n, softA));
  return { distance: -depth - softA - softB, on_a, on_b: sub(on_a, scale(n, depth + softA + softB)) };
}

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
