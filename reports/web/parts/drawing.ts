// SPDX-License-Identifier: MIT
// The drawing of a case, in a frame of its own. The origin is the middle of the centres. The larger of the pair's
// extent and the way between its centres is about 1. It uses doubles, for a drawing proves nothing.
import {
  isBox, isHalfSpace, type Box, type Coordinate, type Cylinder, type Shown, type Solid as Given, type Vec,
} from "./data.ts";
import { add, coreReach, dot, scale, sub, turnedAxes, unit, type Solid } from "./geometry.ts";

export interface Drawing {
  a: Solid;
  b: Solid;
  unit: number; // length of the scene that is drawn as 1
  extent: number; // radius of a ball around the origin that holds both
  near: { a: Vec; b: Vec } | null;
  direction: Vec | null; // from a to b
  plane: Vec | null; // a point of the separating plane
  point: Vec | null; // a common point
  gap: number | null; // signed, in the unit
  widened: number; // how many times as wide as it is the gap is drawn
}

/** The double nearest to an exact coordinate, for drawing. */
function coordinateValue(x: Coordinate): number {
  if (typeof x === "number") return x;
  if (typeof x !== "string") return x.reduce((sum, term) => sum + term, 0);
  const [n, d = "1"] = x.split("/");
  const digits = Math.max(n!.length, d.length) - 300; // beyond the range of doubles: the leading ones
  const value = (text: string) =>
    digits > 0 ? Number(text.slice(0, Math.max(1, text.length - digits))) : Number(text);
  return value(n!) / value(d);
}

/** The extent of a solid along n. */
export const reach = (s: Solid, n: Vec) => {
  const along = Math.min(1, Math.abs(dot(s.axis, n)));
  const ofEdges = s.edges.reduce((sum, e) => sum + Math.abs(dot(e, n)), 0);
  return s.radius * Math.sqrt(Math.max(0, 1 - along * along)) + s.half * along + ofEdges + s.rounding;
};

type Bounded = Cylinder | Box;
/** Halves of its lengths, without the rounding. */
const halvesOf = (s: Bounded): number[] => (isBox(s) ? s.edges.map((e) => e / 2) : [s.radius, s.height / 2]);

/** A half-space is drawn as a disk of its plane, below the other solid. */
function drawable(s: Given, other: Given): Bounded {
  if (!isHalfSpace(s)) return s;
  const of = isHalfSpace(other) ? { center: s.point, axis: s.normal, radius: 1, height: 0 } : other,
    n = unit(s.normal),
    above = dot(n, sub(of.center, s.point));
  const radius = 1.6 * (Math.hypot(...halvesOf(of)) + (of.rounding ?? 0));
  return { center: sub(of.center, scale(n, above)), axis: n, radius, height: 0 };
}

function unitOf(pair: { a: Bounded; b: Bounded }): number {
  const apart = sub(scale(pair.b.center, 0.5), scale(pair.a.center, 0.5));
  const lengths = [pair.a, pair.b].flatMap((c) => [...halvesOf(c), c.rounding ?? 0]);
  const longest = Math.max(...lengths, ...apart.map(Math.abs));
  return longest > 0 && Number.isFinite(longest) ? longest : 1;
}

/** The point of the solid that is farthest along n, or the middle of its face if a whole face is. */
function support(s: Solid, n: Vec): Vec {
  const along = dot(s.axis, n);
  const radial = sub(n, scale(s.axis, along)),
    length = Math.sqrt(dot(radial, radial));
  const rim = length > 1e-9 ? scale(radial, s.radius / length) : ([0, 0, 0] as Vec);
  const end = (v: Vec, part: number) => scale(v, Math.abs(part) > 1e-9 ? Math.sign(part) : 0);
  const core = add(add(s.center, scale(end(s.axis, along), s.half)), rim);
  const corner = s.edges.reduce((at, e) => add(at, end(e, dot(e, n))), core);
  return add(corner, scale(n, s.rounding));
}

const finite = (x: Vec | null) => (x?.every(Number.isFinite) ? x : null);

/** A gap or an overlap narrower than this part of the drawing cannot be seen. */
const visibleShare = 0.06;

/** The solids, moved apart (or into each other) about their contact along the direction, until the gap is seen. */
function widened(d: Drawing): Drawing {
  if (!d.gap || !d.direction) return d;
  const times = (visibleShare * d.extent) / Math.abs(d.gap);
  if (times <= 1 || !Number.isFinite(times)) return d;
  const move = scale(d.direction, ((times - 1) * d.gap) / 2),
    back = scale(move, -1);
  return {
    ...d,
    a: { ...d.a, center: add(d.a.center, back) },
    b: { ...d.b, center: add(d.b.center, move) },
    near: d.near && { a: add(d.near.a, back), b: add(d.near.b, move) },
    widened: times,
  };
}

export function drawingOf(c: Shown): Drawing {
  const a = drawable(c.pair.a, c.pair.b),
    b = drawable(c.pair.b, c.pair.a),
    u = unitOf({ a, b });
  // Halves first: the sum of two doubles may overflow, and centres far out lose nothing but their common offset.
  const halfWay = scale(sub(scale(b.center, 1 / u), scale(a.center, 1 / u)), 0.5);
  const exactWay: Vec = [0, 1, 2].map((i) => (b.center[i]! / 2 - a.center[i]! / 2) / u) as Vec;
  const way = exactWay.every(Number.isFinite) ? exactWay : halfWay;
  const solid = (s: typeof a, center: Vec): Solid => ({
    center,
    axis: isBox(s) ? [0, 0, 1] : unit(s.axis),
    radius: isBox(s) ? 0 : s.radius / u,
    half: isBox(s) ? 0 : s.height / 2 / u,
    edges: isBox(s) ? turnedAxes(s.quaternion ?? [1, 0, 0, 0]).map((e, i) => scale(e, s.edges[i]! / 2 / u)) : [],
    rounding: (s.rounding ?? 0) / u,
  });
  const drawnA = solid(a, scale(way, -1)),
    drawnB = solid(b, way);
  const local = (x: Vec): Vec => add(drawnA.center, [0, 1, 2].map((i) => (x[i]! - a.center[i]!) / u) as Vec);

  const certificate = c.truth.direction ?? c.truth.near?.direction;
  const given = c.direction ?? (certificate?.map(coordinateValue) as Vec | undefined) ?? null;
  let direction = given && finite(given) && unit(given);
  const delta = sub(drawnB.center, drawnA.center);
  if (direction && dot(direction, delta) < 0) direction = scale(direction, -1);
  const certified = c.truth.point ?? c.truth.near?.point,
    two = (c.truth.points ?? c.truth.near?.points)?.map((x) => local(x.map(coordinateValue) as Vec)),
    share = drawnA.rounding / (drawnA.rounding + drawnB.rounding);
  const point = certified
    ? local(certified.map(coordinateValue) as Vec)
    : two
      ? add(two[0]!, scale(sub(two[1]!, two[0]!), share)) // of the way from core to core, that much lies in a
      : null;
  const near = c.nearest
    ? { a: local(c.nearest.a), b: local(c.nearest.b) }
    : direction
      ? { a: support(drawnA, direction), b: support(drawnB, scale(direction, -1)) }
      : null;
  const middle = finite(near && scale(add(near.a, near.b), 0.5)) ?? [0, 0, 0];

  // A plane square to the direction of the certificate itself, in the middle of the space that it leaves free.
  let plane: Vec | null = null;
  const normal = certificate && unit(certificate.map(coordinateValue) as Vec); // none beyond the range of doubles
  if (c.truth.verdict === "disjoint" && normal?.every(Number.isFinite)) {
    const n = dot(normal, delta) < 0 ? scale(normal, -1) : normal;
    const low = dot(n, drawnA.center) + reach(drawnA, n),
      high = dot(n, drawnB.center) - reach(drawnB, n);
    plane = add(middle, scale(n, (low + high) / 2 - dot(n, middle)));
    direction ??= n;
  }
  const distance = c.truth.distance;
  const gap = distance ? (distance[0] + (distance[1] - distance[0]) / 2) / u : null;
  const ball = (s: Solid) => Math.sqrt(dot(s.center, s.center)) + coreReach(s) + s.rounding;
  return widened({
    a: drawnA,
    b: drawnB,
    unit: u,
    extent: Math.max(ball(drawnA), ball(drawnB), 1e-3),
    near: near && finite(near.a) && finite(near.b) && near,
    direction,
    plane: finite(plane),
    point: finite(point),
    gap: gap !== null && Number.isFinite(gap) ? gap : null,
    widened: 1,
  });
}
