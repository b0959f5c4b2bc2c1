// SPDX-License-Identifier: MIT
// Checks a certificate in exact arithmetic, in integers only: no double is rounded on the way, and the source of the
// certificate is not trusted.
//
//   direction D   f(D) = sum over both of  r |w x D|/|w| + h/2 |w.D|/|w|  -  |D.(c_b - c_a)|  < 0
//   point X       |(X - c).w| <= h/2 |w|  and  |(X - c) x w| <= r |w|  of both, squared
//   points P, Q   P in a, Q in b, |P - Q| <= R, squared
//   half-space    D is its outward normal, times a positive number; X is behind the plane: n.(X - p) <= 0
//   near X, D     X in both after each was grown by 2^-200 of the size, D apart after each was shrunk by as much
//
// A point may come with hulls: the axes and middle planes of flat solids. It stands for the point of the hulls that is
// nearest to it, which is rational too. Each of two points moves into the hull of its own solid.
//
// A solid with a rounding is its core grown by a ball. The tests above are of the cores, R is the sum of both
// roundings, and f has the additional term R |D|.
//
// f is a rational minus four square roots of rationals. Each root is enclosed between whole multiples of 2^-k, and k
// doubles until the sign shows. If f(D) = 0 exactly, no k shows it: at bitsCap the answer is "not decided".
import { isHalfSpace, type Coordinate, type Hull, type Pair, type Solid as Given, type Truth } from "./data.ts";
import {
  abs, add, cross, decimal, div, dot, equal, exact, half, isZero, less, minus, moved, mul, neg, one, rational, reduced,
  root, square, sub, turned, zero, type Rational, type Vector,
} from "./rational.ts";

interface Solid {
  plane: boolean; // a half-space: the center is a point of its plane, the axis its normal, and the lengths are 0
  center: Vector;
  axis: Vector;
  radius: Rational;
  height: Rational;
  rounding: Rational;
}

export interface Proof {
  /** null: not decided, or nothing to be proved. */
  holds: boolean | null;
  text: string;
  /** The numbers it rests on, rounded for reading. */
  steps: string[];
}

/** Binary digits behind the point of a root, of the largest such number. */
const bitsFirst = 128,
  bitsCap = 16384;
/** `near` is proved to this part of the size, as the power of two. */
const nearBits = 200n;

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

function vector(v: Coordinate[] | undefined, what: string): Vector {
  if (!Array.isArray(v) || v.length !== 3) throw new Error(`${what} does not have three coordinates`);
  return [coordinate(v[0]!), coordinate(v[1]!), coordinate(v[2]!)];
}

function solid(c: Given): Solid {
  if (isHalfSpace(c)) {
    const axis = vector(c.normal, "a normal");
    if (isZero(axis)) throw new Error("a normal is zero");
    return { plane: true, center: vector(c.point, "a point"), axis, radius: zero, height: zero, rounding: zero };
  }
  const read = {
    plane: false,
    center: vector(c.center, "a centre"),
    axis: vector(c.axis, "an axis"),
    radius: exact(c.radius),
    height: exact(c.height),
    rounding: exact(c.rounding ?? 0),
  };
  if (isZero(read.axis)) throw new Error("an axis is zero");
  if ([read.radius, read.height, read.rounding].some((x) => x.n < 0n)) throw new Error("a length is negative");
  return read;
}

interface Side {
  sign: -1 | 0 | 1;
  steps: string[];
  bits: number;
}

/** The sign of f(D), or 0 if it did not show. */
function signOfF(a: Solid, b: Solid, d: Vector): Side {
  const planes = [...(a.plane ? [a.axis] : []), ...(b.plane ? [turned(b.axis)] : [])];
  if (planes.some((n) => !isZero(cross(d, n)) || dot(d, n).n < 0n))
    return { sign: 1, bits: 0, steps: ["D is not along the normal of the half-space, which has no end there"] };
  const terms = [a, b].flatMap((s, i) => {
    const ww = dot(s.axis, s.axis);
    const across = cross(d, s.axis),
      along = dot(d, s.axis),
      name = i === 0 ? "a" : "b";
    return [
      { what: `radius ${name}: r |P D|`, q: mul(square(s.radius), div(dot(across, across), ww)) },
      { what: `height ${name}: h/2 |D.w|`, q: mul(square(div(s.height, rational(2n))), div(square(along), ww)) },
    ];
  });
  const contactDistance = add(a.rounding, b.rounding);
  if (contactDistance.n !== 0n) terms.push({ what: "roundings: R |D|", q: mul(square(contactDistance), dot(d, d)) });
  const between = dot(d, minus(b.center, a.center)),
    apart = planes.length > 0 ? between : abs(between);
  // Roots far below 1 need their own digits: count from the size of the projection.
  const length = (x: bigint) => x.toString(16).length * 4;
  const small = BigInt(Math.max(0, length(apart.d) - length(abs(apart).n)));
  for (let bits = bitsFirst; ; bits *= 2) {
    const roots = terms.map((t) => root(t.q, BigInt(bits) + small));
    const low = roots.reduce((sum, r) => add(sum, r[0]), zero),
      high = roots.reduce((sum, r) => add(sum, r[1]), zero);
    const shown = less(high, apart) || less(apart, low);
    if (!shown && bits < bitsCap) continue;
    const sign = less(high, apart) ? -1 : less(apart, low) ? 1 : 0;
    return {
      sign,
      bits,
      steps: [
        ...terms.map((t, i) => `${t.what} = ${decimal(roots[i]![0])}`),
        `their sum = ${decimal(low)}`,
        `centres: |D.(c_b \u2212 c_a)| = ${decimal(apart)}`,
        `f(D) = ${sign === 0 ? "0 within 2^-" + bits : decimal(sub(low, apart))}`,
      ],
    };
  }
}

/** Two numbers and which is larger. */
function comparison(what: string, value: Rational, limit: Rational): string {
  const sign = less(limit, value) ? ">" : less(value, limit) ? "<" : "=";
  return `${what}: ${decimal(value)} ${sign} ${decimal(limit)}${sign === "=" ? " exactly" : ""}`;
}

function reach(name: string, s: Solid, x: Vector): { inside: boolean; steps: string[] } {
  const ww = dot(s.axis, s.axis);
  const from = minus(x, s.center),
    along = dot(from, s.axis),
    across = cross(from, s.axis);
  if (s.plane)
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

/** A point of each core, no farther apart than both roundings and the slack. */
function comeNear(a: Solid, b: Solid, x: Vector, y: Vector, slack = zero): { inside: boolean; steps: string[] } {
  const parts = [reach("a", a, x), reach("b", b, y)],
    between = minus(y, x),
    way = dot(between, between),
    most = square(add(add(a.rounding, b.rounding), slack));
  return {
    inside: parts.every((p) => p.inside) && !less(most, way),
    steps: [
      ...parts.flatMap((p) => p.steps),
      comparison("between them, |q\u2212p|\u00b2 against R\u00b2", way, most),
    ],
  };
}

/** A plane: x.normal = offset. */
interface Plane {
  normal: Vector;
  offset: Rational;
}
/** Two directions that are square to the axis and to each other. */
function acrossAxis({ axis }: Solid): [Vector, Vector] {
  // Any coordinate vector that is not along the axis gives the first.
  const beside = cross(axis, axis[1].n === 0n && axis[2].n === 0n ? [zero, one, zero] : [one, zero, zero]);
  return [beside, cross(axis, beside)];
}

/** The planes that a hull lies in: one for a plane, two for a line, three for a centre. */
function planesOf(s: Solid, hull: Hull): Plane[] {
  if (s.plane) return [];
  const through = (normal: Vector): Plane => ({ normal, offset: dot(normal, s.center) }),
    level = hull === "plane" || hull === "center" || s.height.n === 0n,
    thin = hull === "line" || hull === "center" || s.radius.n === 0n;
  return [...(level ? [through(s.axis)] : []), ...(thin ? acrossAxis(s).map(through) : [])];
}

/** The point in all planes that is nearest to x; null if no point is in all. */
function nearestInPlanes(x: Vector, planes: Plane[]): Vector | null {
  const square: Plane[] = []; // to each other
  for (let { normal, offset } of planes) {
    for (const p of square) {
      const share = reduced(div(dot(normal, p.normal), dot(p.normal, p.normal)));
      normal = moved(normal, neg(share), p.normal);
      offset = reduced(sub(offset, mul(share, p.offset)));
    }
    if (dot(normal, normal).n !== 0n) square.push({ normal, offset });
    else if (offset.n !== 0n) return null;
  }
  return square.reduce(
    (at, { normal, offset }) => moved(at, reduced(div(sub(offset, dot(normal, at)), dot(normal, normal))), normal),
    x,
  );
}

function inHulls(x: Vector, solids: Solid[], hulls: Hull[]): Vector {
  const at = nearestInPlanes(
    x,
    solids.flatMap((s, i) => planesOf(s, hulls[i]!)),
  );
  if (!at) throw new Error("the hulls have no common point");
  return at;
}

function inBoth(a: Solid, b: Solid, x: Vector): { inside: boolean; steps: string[] } {
  const parts = [reach("a", a, x), reach("b", b, x)];
  return { inside: parts.every((p) => p.inside), steps: parts.flatMap((p) => p.steps) };
}

function grown(s: Solid, by: Rational): Solid {
  if (s.plane) {
    const share = div(by, root(dot(s.axis, s.axis), BigInt(bitsFirst))[0]); // the plane moves by a little more
    return { ...s, center: moved(s.center, share, s.axis) };
  }
  const atLeastZero = (x: Rational) => (x.n < 0n ? zero : x);
  return {
    ...s,
    radius: atLeastZero(add(s.radius, by)),
    height: atLeastZero(add(s.height, mul(rational(2n), by))),
  };
}

function proveDirection(a: Solid, b: Solid, d: Vector): Proof {
  if (isZero(d)) return { holds: false, text: "Refuted: the direction is zero.", steps: [] };
  const { sign, bits, steps } = signOfF(a, b, d);
  if (sign < 0)
    return { holds: true, steps, text: "Proved: f(D) < 0 exactly. A plane perpendicular to D separates the solids." };
  if (sign > 0)
    return { holds: false, text: "Refuted: f(D) > 0 exactly. No plane perpendicular to D separates them.", steps };
  return { holds: null, text: `Not decided with ${bits} binary digits: f(D) is 0, or nearer to it than that.`, steps };
}

/** A point of a core as seen from its centre, and the part of it that is square to the axis. */
function seen(s: Solid, x: Vector) {
  const out = minus(x, s.center),
    along = dot(out, s.axis),
    ww = dot(s.axis, s.axis);
  return { out, along, ww, across: moved(out, neg(div(along, ww)), s.axis) };
}

/** Vectors that span the cone of the outward normals of a core at its point x, and the normal of their plane, if they
 *  lie in one. Inner points have none. */
function normals(s: Solid, x: Vector): { spans: Vector[]; plane: Vector | null } {
  if (s.plane) return { spans: dot(minus(x, s.center), s.axis).n === 0n ? [s.axis] : [], plane: null };
  const { along, ww, across } = seen(s, x),
    onCap = equal(square(along), mul(square(half(s.height)), ww)),
    onWall = equal(dot(across, across), square(s.radius)),
    flat = s.height.n === 0n,
    up = flat || along.n > 0n ? [s.axis] : [],
    down = flat || along.n < 0n ? [turned(s.axis)] : [],
    ends = onCap ? [...up, ...down] : [];
  if (!onWall) return { spans: ends, plane: null };
  if (s.radius.n > 0n) return { spans: [...ends, across], plane: ends.length > 0 ? cross(s.axis, across) : null };
  const sides = acrossAxis(s);
  return { spans: [...ends, ...sides, ...sides.map(turned)], plane: s.axis };
}

/** Whether no point of the core lies farther along n than its point x. */
function supports(s: Solid, x: Vector, n: Vector): boolean {
  if (s.plane)
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

/** Whether solids that meet share no inner point. Either x and y, points of the cores, are nearest to each other and as
 *  far apart as both roundings. Or they are one point in which the cores have opposite normals. */
function touchAt(a: Solid, b: Solid, x: Vector, y: Vector): boolean {
  const between = minus(y, x),
    contactDistance = add(a.rounding, b.rounding);
  if (!isZero(between) || contactDistance.n !== 0n)
    return (
      equal(dot(between, between), square(contactDistance)) &&
        supports(a, x, between) &&
        supports(b, y, turned(between))
    );
  const of = [normals(a, x), normals(b, x)] as const,
    shared = of[0].plane && of[1].plane ? cross(of[0].plane, of[1].plane) : null,
    tried = [...of[0].spans, ...of[1].spans.map(turned), ...(shared ? [shared, turned(shared)] : [])];
  return tried.some((n) => !isZero(n) && supports(a, x, n) && supports(b, x, turned(n)));
}

/** The proof of solids that meet at x and y, points of the cores. */
function proveTouch(a: Solid, b: Solid, x: Vector, y: Vector, steps: string[]): Proof {
  return touchAt(a, b, x, y)
    ? { holds: true, steps, text: "Proved: they meet there, and a plane through the point has one solid on each side." }
    : { holds: false, steps, text: "Refuted: they meet there, but no plane through the point separates them." };
}

function provePoint(a: Solid, b: Solid, point: Vector, touching: boolean, hulls?: [Hull, Hull]): Proof {
  const x = hulls ? inHulls(point, [a, b], hulls) : point,
    { inside, steps } = inBoth(a, b, x);
  if (!inside) return { holds: false, text: "Refuted: the point is not in both solids.", steps };
  if (touching) return proveTouch(a, b, x, x, steps);
  return { holds: true, steps, text: "Proved: the point lies in both solids." };
}

function two(points: Truth["points"], what: string): [Vector, Vector] {
  if (!Array.isArray(points) || points.length !== 2) throw new Error(`${what} are not two points`);
  return [vector(points[0], "the point of a"), vector(points[1], "the point of b")];
}

function provePoints(a: Solid, b: Solid, { points, hulls }: Truth, touching: boolean): Proof {
  const [x, y] = two(points, "the points"),
    [p, q] = hulls ? [inHulls(x, [a], [hulls[0]]), inHulls(y, [b], [hulls[1]])] : [x, y];
  const { inside, steps } = comeNear(a, b, p, q);
  if (!inside)
    return { holds: false, steps, text: "Refuted: a point is not in its core, or they are too far apart." };
  if (touching) return proveTouch(a, b, p, q, steps);
  return {
    holds: true,
    steps,
    text: "Proved: the points lie in the cores, and their distance is at most the sum of the roundings.",
  };
}

function proveNear(a: Solid, b: Solid, near: NonNullable<Truth["near"]>): Proof {
  const d = vector(near.direction, "the direction");
  const size = [a.radius, a.height, a.rounding, b.radius, b.height, b.rounding].reduce(add);
  const slack = div(size, rational(1n << nearBits)),
    wideA = grown(a, slack),
    wideB = grown(b, slack);
  const met = near.points
    ? comeNear(wideA, wideB, ...two(near.points, "the points"), slack)
    : inBoth(wideA, wideB, vector(near.point, "the point"));
  if (!met.inside)
    return {
      holds: false,
      steps: met.steps,
      text: "Refuted: the point is farther than 2^-200 times the size from a solid.",
    };
  if (isZero(d)) return { holds: false, text: "Refuted: the direction is zero.", steps: [] };
  const lessRounded = (s: Solid): Solid => (s.rounding.n === 0n ? s : { ...s, rounding: sub(s.rounding, slack) });
  const apart = signOfF(lessRounded(grown(a, neg(slack))), lessRounded(grown(b, neg(slack))), d);
  const steps = [...met.steps, ...apart.steps];
  if (apart.sign < 0) return { holds: true, text: "Proved: the solids touch, up to 2^-200 times the size.", steps };
  if (apart.sign > 0)
    return {
      holds: false,
      steps,
      text: "Refuted: along that direction, the solids overlap by more than 2^-200 times the size.",
    };
  return { holds: null, steps, text: `Not decided with ${apart.bits} binary digits.` };
}

/** The parts of a truth that each prove its verdict alone. */
const proofs = ["direction", "point", "points", "near"] as const,
  proofsOf: Record<string, readonly string[]> = {
    disjoint: ["direction"],
    intersecting: ["point", "points"],
    touching: ["point", "points", "near"],
  };

/** Never throws. A truth that cannot be read, or has a part that does not belong to its verdict, proves nothing. */
export function prove(pair: Pair, truth: Truth): Proof {
  try {
    const given = proofs.filter((part) => truth[part] !== undefined),
      odd = given.filter((part, i) => i > 0 || !(proofsOf[truth.verdict] ?? []).includes(part));
    if (odd.length > 0) throw new Error(`the ${odd[0]} does not belong to the verdict`);
    const a = solid(pair.a),
      b = solid(pair.b);
    switch (truth.verdict) {
      case "disjoint":
        return proveDirection(a, b, vector(truth.direction, "the direction"));
      case "intersecting":
        return truth.points
          ? provePoints(a, b, truth, false)
          : provePoint(a, b, vector(truth.point, "the point"), false, truth.hulls);
      case "touching":
        if (truth.points) return provePoints(a, b, truth, true);
        if (truth.near) return proveNear(a, b, truth.near);
        return provePoint(a, b, vector(truth.point, "the point"), true, truth.hulls);
      default:
        return { holds: null, text: "No truth is proved for this pair.", steps: [] };
    }
  } catch (error) {
    return { holds: false, text: `Refuted: ${error instanceof Error ? error.message : String(error)}.`, steps: [] };
  }
}
