// SPDX-License-Identifier: MIT
// What the page of many cylinders is given: what `daylight scene --json` writes of them
// (reports/scene/crowd_report.cpp, described by reports/schemas/close_pairs.json), and what is made of it.
import type { Cylinder, Vec } from "./data.ts";
import { csv_cell } from "./save.ts";
import { safe, shell_quoted } from "./words.ts";

export interface Times {
  prepare: number;
  tree: number;
  ladder: number;
}
export interface GrowthRow {
  cylinders: number;
  candidates: number;
  within: number;
  cpu_ms: Times;
}
export type Certificate = "direction" | "point" | "points" | "none";
export interface NearPair {
  a: number;
  b: number;
  distance: number; // negative: minus the depth
  error: number;
  within: boolean;
  certificate: Certificate;
  on_a: Vec;
  on_b: Vec;
}
export interface Crowd {
  cylinders: number;
  file?: string;
  generated?: string;
  seed?: string;
  clearance: number;
  candidates: number;
  decided: Record<string, number>;
  undecided: number;
  cpu_ms: Times;
  verification?: { asked: number; wrong: number; undecided: number; cpu_ms: number };
  certificates?: { checked: number; failed: number; undecided: number; cpu_ms: number };
  growth?: GrowthRow[];
  nearest: NearPair[];
  within: [number, number][];
  names?: string[];
  solids: number[][];
}

/** Text of a file made safe; the numbers are most of the data, and are left alone. */
export const safe_crowd = (crowd: Crowd): Crowd => ({
  ...crowd,
  ...(crowd.file === undefined ? {} : { file: safe(crowd.file) }),
  ...(crowd.names === undefined ? {} : { names: crowd.names.map(safe) }),
});

export const total_ms = (t: Times) => t.prepare + t.tree + t.ladder;
export const source_of = (crowd: Crowd) => crowd.file ?? `generated ${crowd.generated}`;
/** Names of a file; else the number that the JSON has. */
export const name_of = (crowd: Crowd, solid: number) => crowd.names?.[solid] ?? `cylinder ${solid}`;

export function command_of(crowd: Crowd): string {
  const of =
    crowd.file === undefined
      ? `--generate ${crowd.generated} --count ${crowd.cylinders} --seed ${crowd.seed}`
      : shell_quoted(crowd.file);
  return `./daylight scene ${of}${crowd.clearance > 0 ? ` --clearance ${crowd.clearance}` : ""}`;
}

export function cylinder_of(numbers: number[]): Cylinder {
  const [x, y, z, u, v, w, radius, height, rounding] = numbers as [
    number,
    number,
    number,
    number,
    number,
    number,
    number,
    number,
    number?,
  ];
  return { center: [x, y, z], axis: [u, v, w], radius, height, ...(rounding === undefined ? {} : { rounding }) };
}

/** By solid, the others that are within the clearance of it, in order. */
export function partners_of(crowd: Crowd): Map<number, number[]> {
  const partners = new Map<number, number[]>();
  const add = (solid: number, other: number) => {
    const known = partners.get(solid);
    if (known) known.push(other);
    else partners.set(solid, [other]);
  };
  for (const [a, b] of crowd.within) {
    add(a, b);
    add(b, a);
  }
  return partners;
}

/** The pair among the nearest ones, where it is. */
export const near_pair = (crowd: Crowd, [a, b]: readonly [number, number]) =>
  crowd.nearest.find((pair) => (pair.a === a && pair.b === b) || (pair.a === b && pair.b === a));

/** The slope of the line of least squares through the logarithms, and the factor before the power; null of fewer than
 *  two sizes. */
export function power_law(points: readonly (readonly [number, number])[]): { exponent: number; factor: number } | null {
  const logs = points.filter(([n, t]) => n > 0 && t > 0).map(([n, t]) => [Math.log(n), Math.log(t)] as const);
  const mean = (of: (p: readonly [number, number]) => number) => logs.reduce((sum, p) => sum + of(p), 0) / logs.length;
  const x = mean((p) => p[0]),
    y = mean((p) => p[1]);
  const spread = mean((p) => (p[0] - x) ** 2);
  if (!(spread > 0)) return null;
  const exponent = mean((p) => (p[0] - x) * (p[1] - y)) / spread;
  return { exponent, factor: Math.exp(y - exponent * x) };
}

export const columns = ["rank", "pair", "distance", "answer", "certificate"] as const;
export type Column = (typeof columns)[number];
export interface Order {
  column: Column;
  down: boolean;
}
const value: Record<Column, (crowd: Crowd, i: number) => number | string> = {
  rank: (_, i) => i,
  pair: (crowd, i) => crowd.nearest[i]!.a,
  distance: (crowd, i) => crowd.nearest[i]!.distance,
  answer: (crowd, i) => Number(!crowd.nearest[i]!.within),
  certificate: (crowd, i) => crowd.nearest[i]!.certificate,
};

/** Indices of crowd.nearest whose names have all words of a text. */
export function rows_of(crowd: Crowd, text: string, order: Order): number[] {
  const words = text.toLowerCase().split(/\s+/).filter(Boolean);
  const rows = crowd.nearest.flatMap(({ a, b }, i) => {
    const names = [a, b].map((solid) => name_of(crowd, solid).toLowerCase());
    return words.every((word) => names.some((name) => name.includes(word))) ? [i] : [];
  });
  const of = value[order.column],
    sign = order.down ? -1 : 1;
  return rows.sort((i, j) => {
    const x = of(crowd, i),
      y = of(crowd, j);
    return x < y ? -sign : x > y ? sign : i - j;
  });
}

/** The nearest pairs for a spreadsheet (RFC 4180). */
export function csv_of_pairs(crowd: Crowd, rows: number[]): string {
  const point = (name: string) => ["x", "y", "z"].map((axis) => `${name}_${axis}`);
  const head = [
    ...["a", "b", "name_a", "name_b", "distance", "error", "answer", "certificate"],
    ...point("on_a"),
    ...point("on_b"),
  ];
  const lines = rows.map((i) => {
    const { a, b, distance, error, within, certificate, on_a, on_b } = crowd.nearest[i]!;
    const names = [name_of(crowd, a), name_of(crowd, b)];
    return [a, b, ...names, distance, error, within ? "within" : "apart", certificate, ...on_a, ...on_b];
  });
  return [head, ...lines].map((cells) => `${cells.map(csv_cell).join(",")}\r\n`).join("");
}
