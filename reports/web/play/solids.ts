// SPDX-License-Identifier: MIT
// The kinds of solids as people name them, and the pair in the address: #a=..&b=.., nine numbers each, without a
// rounding of 0.
import type { Cylinder, Pair, Vec } from "../parts/data.ts";

export const kinds = ["cylinder", "capsule", "sphere", "rounded cylinder"] as const;
export type Kind = (typeof kinds)[number];

export function kindOf({ radius, height, rounding = 0 }: Cylinder): Kind {
  if (rounding === 0) return "cylinder";
  return radius > 0 ? "rounded cylinder" : height > 0 ? "capsule" : "sphere";
}

export type Length = "radius" | "height" | "rounding";
/** The fields of a kind, with the names that people know. */
export const lengthsOf: Record<Kind, [Length, string][]> = {
  cylinder: [
    ["radius", "radius"],
    ["height", "height"],
  ],
  capsule: [
    ["rounding", "radius"],
    ["height", "length"],
  ],
  sphere: [["rounding", "radius"]],
  "rounded cylinder": [
    ["radius", "radius"],
    ["height", "height"],
    ["rounding", "rounding"],
  ],
};

/** About as wide and as long, as another kind. */
export function asKind(c: Cylinder, kind: Kind): Cylinder {
  const wide = c.radius + (c.rounding ?? 0) || 1,
    height = c.height || 2 * wide,
    { center, axis } = c;
  switch (kind) {
    case "cylinder":
      return { center, axis, radius: wide, height };
    case "capsule":
      return { center, axis, radius: 0, height, rounding: wide };
    case "sphere":
      return { center, axis, radius: 0, height: 0, rounding: wide };
    case "rounded cylinder":
      return { center, axis, radius: (wide * 3) / 4, height, rounding: wide / 4 };
  }
}

const numbersOf = ({ center, axis, radius, height, rounding = 0 }: Cylinder) =>
  [...center, ...axis, radius, height, ...(rounding === 0 ? [] : [rounding])].map((x) =>
    Object.is(x, -0) ? "-0" : String(x),
  );
export const addressOf = ({ a, b }: Pair) => `#a=${numbersOf(a).join(",")}&b=${numbersOf(b).join(",")}`;

function cylinderOf(text: string | null): Cylinder | null {
  const words = (text ?? "").split(",");
  const x = words.map((word) => (word.trim() === "" ? NaN : Number(word)));
  if ((x.length !== 8 && x.length !== 9) || !x.every(Number.isFinite)) return null;
  const solid: Cylinder = {
    center: x.slice(0, 3) as Vec,
    axis: x.slice(3, 6) as Vec,
    radius: x[6]!,
    height: x[7]!,
  };
  return x[8] ? { ...solid, rounding: x[8] } : solid;
}

/** null: the address holds no pair. */
export function pairOf(hash: string): Pair | null {
  const query = new URLSearchParams(hash.slice(1).replaceAll("+", "%2B")), // as of 1e+300
    a = cylinderOf(query.get("a")),
    b = cylinderOf(query.get("b"));
  return a && b && { a, b };
}

/** A length rounded to a decimal far below another, so that what is dragged has few digits. */
export function tidy(x: number, unit: number): number {
  const digits = 3 - Math.floor(Math.log10(unit));
  return digits > 100 || digits < -300 || !Number.isFinite(digits) ? x : Number(tidyText(x, digits));
}
const tidyText = (x: number, digits: number) =>
  digits >= 0 ? x.toFixed(digits) : String(Math.round(x / 10 ** -digits) * 10 ** -digits);
