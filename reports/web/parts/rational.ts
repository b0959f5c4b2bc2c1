// SPDX-License-Identifier: MIT
// Exact arithmetic in rational numbers, which are pairs of integers.

/** n/d, d > 0; not reduced. */
export interface Rational {
  n: bigint;
  d: bigint;
}
export type Vector = [Rational, Rational, Rational];

export const rational = (n: bigint, d = 1n): Rational => (d < 0n ? { n: -n, d: -d } : { n, d });
export const zero = rational(0n),
  one = rational(1n);
export const add = (x: Rational, y: Rational): Rational =>
  x.d === y.d ? { n: x.n + y.n, d: x.d } : { n: x.n * y.d + y.n * x.d, d: x.d * y.d };
export const neg = (x: Rational): Rational => ({ n: -x.n, d: x.d });
export const sub = (x: Rational, y: Rational) => add(x, neg(y));
export const mul = (x: Rational, y: Rational): Rational => ({ n: x.n * y.n, d: x.d * y.d });
export const div = (x: Rational, y: Rational): Rational => rational(x.n * y.d, x.d * y.n);
export const abs = (x: Rational) => (x.n < 0n ? neg(x) : x);
export const less = (x: Rational, y: Rational) => x.n * y.d < y.n * x.d;
export const square = (x: Rational) => mul(x, x);
export const dot = (u: Vector, v: Vector) => add(add(mul(u[0], v[0]), mul(u[1], v[1])), mul(u[2], v[2]));
export const isZero = (d: Vector) => d.every((x) => x.n === 0n);
export const minus = (u: Vector, v: Vector): Vector => [sub(u[0], v[0]), sub(u[1], v[1]), sub(u[2], v[2])];
export const cross = (u: Vector, v: Vector): Vector => [
  sub(mul(u[1], v[2]), mul(u[2], v[1])),
  sub(mul(u[2], v[0]), mul(u[0], v[2])),
  sub(mul(u[0], v[1]), mul(u[1], v[0])),
];

/** A double as the dyadic rational that it is. */
export function exact(x: number): Rational {
  if (!Number.isFinite(x)) throw new Error("a number is not finite");
  const bits = new BigUint64Array(new Float64Array([x]).buffer)[0]!;
  const field = Number((bits >> 52n) & 0x7ffn);
  const fraction = bits & 0xfffffffffffffn;
  const mantissa = field === 0 ? fraction : fraction | 0x10000000000000n;
  const power = Math.max(field, 1) - 1075;
  const n = bits >> 63n ? -mantissa : mantissa;
  return power >= 0 ? { n: n << BigInt(power), d: 1n } : { n, d: 1n << BigInt(-power) };
}

/** The largest whole number whose square is at most n. */
export function floorSqrt(n: bigint): bigint {
  if (n < 2n) return n;
  let x = 1n << BigInt((n.toString(16).length * 4 + 1) >> 1); // not below the root
  for (;;) {
    const next = (x + n / x) >> 1n;
    if (next >= x) return x;
    x = next;
  }
}

/** sqrt(q) between two multiples of 2^-bits that are neighbours. */
export function root(q: Rational, bits: bigint): [Rational, Rational] {
  if (q.n === 0n) return [zero, zero];
  const low = floorSqrt((q.n << (2n * bits)) / q.d);
  return [
    { n: low, d: 1n << bits },
    { n: low + 1n, d: 1n << bits },
  ];
}

/** A rational for reading: 12 digits, any exponent. */
export function decimal(x: Rational): string {
  if (x.n === 0n) return "0";
  const n = x.n < 0n ? -x.n : x.n;
  let exponent = n.toString().length - x.d.toString().length;
  const digits = (e: number) => {
    const scale = 12 - e;
    return scale >= 0 ? (n * 10n ** BigInt(scale)) / x.d : n / (x.d * 10n ** BigInt(-scale));
  };
  let d = digits(exponent);
  if (d < 10n ** 12n) d = digits(--exponent);
  const text = d.toString();
  const mantissa = (text[0] + "." + text.slice(1)).replace(/\.?0+$/, "");
  const sign = x.n < 0n ? "\u2212" : "";
  if (exponent >= -4 && exponent < 12) return sign + Number(`${mantissa}e${exponent}`).toString();
  return `${sign}${mantissa}e${exponent}`;
}

/** In lowest terms. Without this, numbers would double their digits at each of several steps. */
export function reduced({ n, d }: Rational): Rational {
  let [x, y] = [n < 0n ? -n : n, d];
  while (y !== 0n) [x, y] = [y, x % y];
  return { n: n / x, d: d / x };
}
/** u + k v */
export const moved = (u: Vector, k: Rational, v: Vector): Vector => [
  reduced(add(u[0], mul(k, v[0]))),
  reduced(add(u[1], mul(k, v[1]))),
  reduced(add(u[2], mul(k, v[2]))),
];

export const equal = (x: Rational, y: Rational) => !less(x, y) && !less(y, x);
export const turned = (v: Vector): Vector => [neg(v[0]), neg(v[1]), neg(v[2])];
export const half = (x: Rational) => div(x, rational(2n));
