// SPDX-License-Identifier: MIT
// Checks a certificate in exact arithmetic, in integers only: no double is rounded on the way, and the source of the
// certificate is not trusted.
//
//   direction D   f(D) = sum over both of  r |w x D|/|w| + h/2 |w.D|/|w|  -  |D.(c_b - c_a)|  < 0
//   point X       |(X - c).w| <= h/2 |w|  and  |(X - c) x w| <= r |w|  of both, squared
//   points P, Q   P in a, Q in b, |P - Q| <= R, squared
//   box           sum of e/2 |D.u| instead of the terms of r and h;  |(X - c).u| <= e/2 for its three edges
//   half-space    D is its outward normal, times a positive number; X is behind the plane: n.(X - p) <= 0
//   near X, D     X in both after each was grown by 2^-200 of the size, D apart after each was shrunk by as much
//
// A point may come with hulls: the axes and planes in which flat solids lie. It stands for the point of the hulls that
// is nearest to it, which is rational too. Each of two points moves into the hull of its own solid. A flat box always
// has the hull of its edges that are not 0.
//
// A solid with a rounding is its core grown by a ball. The tests above are of the cores, R is the sum of both
// roundings, and f has the additional term R |D|.
//
// f is a rational minus square roots of rationals, two of each cylinder. Each root is enclosed between whole multiples
// of 2^-k, and k doubles until the sign shows. If f(D) = 0 exactly, no k shows it: at bitsCap the answer is "not
// decided". Without roots, f is known.
import type { Hull, Pair, Truth } from "./data.ts";
import {
  abs, add, cross, decimal, div, dot, equal, isZero, less, minus, moved, mul, neg, rational, reduced, root, square, sub,
  turned, zero, type Vector,
} from "./rational.ts";
import {
  bitsFirst, comparison, grown, normals, planesOf, reach, sizeOf, solid, supports, supportTerms, vector, type Plane,
  type Solid, type Term,
} from "./solid.ts";

export interface Proof {
  /** null: not decided, or nothing to be proved. */
  holds: boolean | null;
  text: string;
  /** The numbers it rests on, rounded for reading. */
  steps: string[];
}

const bitsCap = 16384;
/** `near` is proved to this part of the size, as the power of two. */
const nearBits = 200n;

interface Side {
  sign: -1 | 0 | 1;
  steps: string[];
  bits: number;
}

/** The sign of f(D), 1 also for an exact 0 without roots. It is 0 if it did not show. */
function signOfF(a: Solid, b: Solid, d: Vector): Side {
  const planes = [a, b].flatMap((s, i) => (s.shape === "half_space" ? [i === 0 ? s.axis : turned(s.axis)] : []));
  if (planes.some((n) => !isZero(cross(d, n)) || dot(d, n).n < 0n))
    return { sign: 1, bits: 0, steps: ["D is not along the normal of the half-space, which has no end there"] };
  const terms: Term[] = [...supportTerms(a, d, "a"), ...supportTerms(b, d, "b")],
    contactDistance = add(a.rounding, b.rounding);
  if (contactDistance.n !== 0n)
    terms.push({ what: "roundings: R |D|", squared: mul(square(contactDistance), dot(d, d)) });
  const between = dot(d, minus(b.center, a.center)),
    apart = planes.length > 0 ? between : abs(between);
  // Roots far below 1 need their own digits: count from the size of the projection.
  const length = (x: bigint) => x.toString(16).length * 4;
  const small = BigInt(Math.max(0, length(apart.d) - length(abs(apart).n)));
  for (let bits = bitsFirst; ; bits *= 2) {
    const parts = terms.map((t) => (t.value ? ([t.value, t.value] as const) : root(t.squared!, BigInt(bits) + small)));
    const low = parts.reduce((sum, r) => add(sum, r[0]), zero),
      high = parts.reduce((sum, r) => add(sum, r[1]), zero);
    const rational = parts.every(([from, to]) => from === to);
    const sign = less(high, apart) ? -1 : less(apart, low) || rational ? 1 : 0;
    if (sign === 0 && bits < bitsCap) continue;
    return {
      sign,
      bits,
      steps: [
        ...terms.map((t, i) => `${t.what} = ${decimal(parts[i]![0])}`),
        `their sum = ${decimal(low)}`,
        `centres: |D.(c_b \u2212 c_a)| = ${decimal(apart)}`,
        `f(D) = ${sign === 0 ? "0 within 2^-" + bits : decimal(sub(low, apart))}`,
      ],
    };
  }
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

function inHulls(x: Vector, solids: Solid[], hulls: (Hull | undefined)[]): Vector {
  const at = nearestInPlanes(
    x,
    solids.flatMap((s, i) => planesOf(s, hulls[i])),
  );
  if (!at) throw new Error("the hulls have no common point");
  return at;
}

function inBoth(a: Solid, b: Solid, x: Vector): { inside: boolean; steps: string[] } {
  const parts = [reach("a", a, x), reach("b", b, x)];
  return { inside: parts.every((p) => p.inside), steps: parts.flatMap((p) => p.steps) };
}

function proveDirection(a: Solid, b: Solid, d: Vector): Proof {
  if (isZero(d)) return { holds: false, text: "Refuted: the direction is zero.", steps: [] };
  const { sign, bits, steps } = signOfF(a, b, d);
  if (sign < 0)
    return { holds: true, steps, text: "Proved: f(D) < 0 exactly. A plane perpendicular to D separates the solids." };
  if (sign > 0)
    return { holds: false, text: "Refuted: f(D) is not below 0. No plane perpendicular to D separates them.", steps };
  return { holds: null, text: `Not decided with ${bits} binary digits: f(D) is 0, or nearer to it than that.`, steps };
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
    shared = of[0].planes.flatMap((p) => of[1].planes.map((q) => cross(p, q))),
    tried = [...of[0].spans, ...of[1].spans.map(turned), ...shared, ...shared.map(turned)];
  return tried.some((n) => !isZero(n) && supports(a, x, n) && supports(b, x, turned(n)));
}

/** The proof of solids that meet at x and y, points of the cores. */
function proveTouch(a: Solid, b: Solid, x: Vector, y: Vector, steps: string[]): Proof {
  return touchAt(a, b, x, y)
    ? { holds: true, steps, text: "Proved: they meet there, and a plane through the point has one solid on each side." }
    : { holds: false, steps, text: "Refuted: they meet there, but no plane through the point separates them." };
}

function provePoint(a: Solid, b: Solid, point: Vector, touching: boolean, hulls?: [Hull, Hull]): Proof {
  const x = inHulls(point, [a, b], hulls ?? []),
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
    [p, q] = [inHulls(x, [a], [hulls?.[0]]), inHulls(y, [b], [hulls?.[1]])];
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
  const slack = div(add(sizeOf(a), sizeOf(b)), rational(1n << nearBits)),
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
