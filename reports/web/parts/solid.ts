// SPDX-License-Identifier: MIT
// Solids in exact arithmetic: the support, the points, the outward normals and the hull of each.
import { isBox, isHalfSpace, type Coordinate, type Hull, type Solid as Given } from "./data.ts";
import {
  abs, add, cross, decimal, div, dot, equal, exact, half, isZero, less, minus, moved, mul, neg, one, rational, root,
  square, turned, zero, type Rational, type Vector,
} from "./rational.ts";

/** An edge of a box: its unit direction, which is rational, and half its length. */
interface Edge {
  along: Vector;
  half: Rational;
}
/** Lengths that a shape does not have are 0. */
export interface Solid {
  shape: "cylinder" | "half_space" | "box";
  center: Vector; // of a half-space a point of its plane
  axis: Vector; // of a half-space its outward normal; a box has none
  radius: Rational;
  height: Rational;
  edges: Edge[];
  rounding: Rational;
}

/** Binary digits behind the point of a root, of the largest such number. */
export const bitsFirst = 128;

function coordinate(x: Coordinate): Rational {
  if (typeof x === "number") return exact(x);
  if (Array.isArray(x)) {
    if (!x.every((term) => typeof term === "number")) throw new Error("a sum has a term that is not a number");
    return x.map(exact).reduce(add, zero);
  }
  const parts = typeof x === "string" ? /^\s*(-?\d+)(?:\/(\d+))?\s*$/.exec(x) : null;
  if (!parts) throw new Error(`${JSON.stringify(x)} is not a coordinate`);
  const d = BigInt(parts[2] ?? "1");
  if (d === 0n) throw new Error(`${x} divides by zero`);
  return rational(BigInt(parts[1]!), d);
}

export function vector(v: Coordinate[] | undefined, what: string): Vector {
  if (!Array.isArray(v) || v.length !== 3) throw new Error(`${what} does not have three coordinates`);
  return [coordinate(v[0]!), coordinate(v[1]!), coordinate(v[2]!)];
}

/** The columns of the rotation, e + 2 (w v x e + v x (v x e)) / (w^2 + v.v) for the quaternion (w, v). */
function edgesOf(lengths: readonly number[], quaternion: readonly number[]): Edge[] {
  if (lengths.length !== 3 || quaternion.length !== 4) throw new Error("a box does not have its seven numbers");
  const [w, x, y, z] = quaternion.map(exact) as [Rational, Rational, Rational, Rational],
    v: Vector = [x, y, z],
    whole = add(square(w), dot(v, v));
  if (whole.n === 0n) throw new Error("a quaternion is zero");
  return lengths.map((length, i) => {
    const e = [0, 1, 2].map((j) => (i === j ? one : zero)) as Vector,
      once = cross(v, e),
      share = div(rational(2n), whole);
    return { along: moved(moved(e, mul(share, w), once), share, cross(v, once)), half: half(exact(length)) };
  });
}

export function solid(c: Given): Solid {
  const lengths = { radius: zero, height: zero, rounding: zero },
    upright: Vector = [zero, zero, one];
  if (isHalfSpace(c)) {
    const axis = vector(c.normal, "a normal");
    if (isZero(axis)) throw new Error("a normal is zero");
    return { shape: "half_space", center: vector(c.point, "a point"), axis, edges: [], ...lengths };
  }
  const center = vector(c.center, "a centre"),
    read: Solid = isBox(c)
      ? { shape: "box", center, axis: upright, edges: edgesOf(c.edges, c.quaternion ?? [1, 0, 0, 0]), ...lengths }
      : { shape: "cylinder", center, axis: vector(c.axis, "an axis"), edges: [], ...lengths };
  read.rounding = exact(c.rounding ?? 0);
  if (!isBox(c)) [read.radius, read.height] = [exact(c.radius), exact(c.height)];
  if (isZero(read.axis)) throw new Error("an axis is zero");
  const given = [read.radius, read.height, read.rounding, ...read.edges.map((e) => e.half)];
  if (given.some((x) => x.n < 0n)) throw new Error("a length is negative");
  return read;
}

/** The sum of its lengths. */
export const sizeOf = (s: Solid): Rational =>
  [s.radius, s.height, s.rounding, ...s.edges.flatMap((e) => [e.half, e.half])].reduce(add);

/** A part of a support: a rational number, or the root of one. */
export interface Term {
  what: string;
  value?: Rational;
  squared?: Rational;
}
const extent = ({ edges }: Solid, d: Vector) => edges.map((e) => mul(e.half, abs(dot(d, e.along)))).reduce(add, zero);

/** The parts of the support of the core in the direction d, about its centre. */
export function supportTerms(s: Solid, d: Vector, name: string): Term[] {
  if (s.shape === "box") return [{ what: `edges ${name}: sum of e/2 |D.u|`, value: extent(s, d) }];
  const ww = dot(s.axis, s.axis),
    across = cross(d, s.axis),
    along = dot(d, s.axis);
  return [
    { what: `radius ${name}: r |P D|`, squared: mul(square(s.radius), div(dot(across, across), ww)) },
    { what: `height ${name}: h/2 |D.w|`, squared: mul(square(half(s.height)), div(square(along), ww)) },
  ];
}

/** Two numbers and which is larger. */
export function comparison(what: string, value: Rational, limit: Rational): string {
  const sign = less(limit, value) ? ">" : less(value, limit) ? "<" : "=";
  return `${what}: ${decimal(value)} ${sign} ${decimal(limit)}${sign === "=" ? " exactly" : ""}`;
}

/** Whether the point x lies in the core. */
export function reach(name: string, s: Solid, x: Vector): { inside: boolean; steps: string[] } {
  const ww = dot(s.axis, s.axis);
  const from = minus(x, s.center),
    along = dot(from, s.axis),
    across = cross(from, s.axis);
  if (s.shape === "box") {
    const by = s.edges.map((e) => abs(dot(from, e.along))),
      what = (i: number) => `${name}, along its edge ${i + 1}, |(x\u2212c).u| against e/2`;
    return {
      inside: s.edges.every((e, i) => !less(e.half, by[i]!)),
      steps: s.edges.map((e, i) => comparison(what(i), by[i]!, e.half)),
    };
  }
  if (s.shape === "half_space")
    return { inside: along.n <= 0n, steps: [`${name}, beyond its plane, n.(x\u2212p): ${decimal(along)} against 0`] };
  const axial = [mul(rational(4n), square(along)), mul(square(s.height), ww)] as const;
  const radial = [dot(across, across), mul(square(s.radius), ww)] as const;
  return {
    inside: !less(axial[1], axial[0]) && !less(radial[1], radial[0]),
    steps: [
      comparison(`${name}, along the axis, 4((x\u2212c).w)\u00b2 against h\u00b2 w\u00b2`, ...axial),
      comparison(`${name}, across it, |(x\u2212c)\u00d7w|\u00b2 against r\u00b2 w\u00b2`, ...radial),
    ],
  };
}

/** A plane: x.normal = offset. */
export interface Plane {
  normal: Vector;
  offset: Rational;
}
/** Two directions that are square to the axis and to each other. */
function acrossAxis({ axis }: Solid): [Vector, Vector] {
  // Any coordinate vector that is not along the axis gives the first.
  const beside = cross(axis, axis[1].n === 0n && axis[2].n === 0n ? [zero, one, zero] : [one, zero, zero]);
  return [beside, cross(axis, beside)];
}

/** The planes that a hull lies in: one for a plane, two for a line, three for a centre. A flat box is always in
 *  those of its edges of length 0. */
export function planesOf(s: Solid, hull?: Hull): Plane[] {
  const through = (normal: Vector): Plane => ({ normal, offset: dot(normal, s.center) });
  if (s.shape === "box") return s.edges.filter((e) => e.half.n === 0n).map((e) => through(e.along));
  if (s.shape === "half_space" || !hull) return [];
  const level = hull === "plane" || hull === "center" || s.height.n === 0n,
    thin = hull === "line" || hull === "center" || s.radius.n === 0n;
  return [...(level ? [through(s.axis)] : []), ...(thin ? acrossAxis(s).map(through) : [])];
}

/** Larger by a length, or smaller, on each side. */
export function grown(s: Solid, by: Rational): Solid {
  if (s.shape === "half_space") {
    const share = div(by, root(dot(s.axis, s.axis), BigInt(bitsFirst))[0]); // the plane moves by a little more
    return { ...s, center: moved(s.center, share, s.axis) };
  }
  const atLeastZero = (x: Rational) => (x.n < 0n ? zero : x);
  return {
    ...s,
    radius: atLeastZero(add(s.radius, by)),
    height: atLeastZero(add(s.height, mul(rational(2n), by))),
    edges: s.edges.map((e) => ({ ...e, half: atLeastZero(add(e.half, by)) })),
  };
}

/** A point of a core as seen from its centre, and the part of it that is square to the axis. */
function seen(s: Solid, x: Vector) {
  const out = minus(x, s.center),
    along = dot(out, s.axis),
    ww = dot(s.axis, s.axis);
  return { out, along, ww, across: moved(out, neg(div(along, ww)), s.axis) };
}

/** Vectors that span the cone of the outward normals of a core at its point x, and the normals of the planes of the
 *  cone's faces. Inner points have none. */
export function normals(s: Solid, x: Vector): { spans: Vector[]; planes: Vector[] } {
  if (s.shape === "half_space") return { spans: dot(minus(x, s.center), s.axis).n === 0n ? [s.axis] : [], planes: [] };
  if (s.shape === "box") {
    const out = minus(x, s.center),
      ends = s.edges.map((e) => [e.along, turned(e.along)].filter((u) => equal(dot(out, u), e.half)));
    const isFace = (i: number) => ends.every((of, j) => i === j || of.length > 0);
    return { spans: ends.flat(), planes: s.edges.filter((_, i) => isFace(i)).map((e) => e.along) };
  }
  const { along, ww, across } = seen(s, x),
    onCap = equal(square(along), mul(square(half(s.height)), ww)),
    onWall = equal(dot(across, across), square(s.radius)),
    flat = s.height.n === 0n,
    up = flat || along.n > 0n ? [s.axis] : [],
    down = flat || along.n < 0n ? [turned(s.axis)] : [],
    ends = onCap ? [...up, ...down] : [];
  if (!onWall) return { spans: ends, planes: [] };
  if (s.radius.n > 0n) return { spans: [...ends, across], planes: ends.length > 0 ? [cross(s.axis, across)] : [] };
  const sides = acrossAxis(s);
  return { spans: [...ends, ...sides, ...sides.map(turned)], planes: [s.axis] };
}

/** Whether no point of the core lies farther along n than its point x. */
export function supports(s: Solid, x: Vector, n: Vector): boolean {
  if (s.shape === "box") return equal(dot(n, minus(x, s.center)), extent(s, n));
  if (s.shape === "half_space")
    return dot(minus(x, s.center), s.axis).n === 0n && isZero(cross(n, s.axis)) && dot(n, s.axis).n > 0n;
  const { out, ww, along } = seen(s, x),
    nw = dot(n, s.axis),
    across = moved(n, neg(div(nw, ww)), s.axis),
    beside = dot(across, out),
    axial = mul(nw, along);
  return (
    axial.n >= 0n &&
    equal(square(axial), mul(square(mul(nw, half(s.height))), ww)) &&
    beside.n >= 0n &&
    equal(square(beside), mul(dot(across, across), square(s.radius)))
  );
}
