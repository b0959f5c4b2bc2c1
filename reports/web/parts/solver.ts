// SPDX-License-Identifier: MIT
// The solver itself, compiled to WebAssembly (reports/web/wasm): its answers are those of the program bit for bit.
import type { Coordinate, Cylinder, Hull, Pair, Truth, Vec, Verdict } from "./data.ts";

const questionSize = 18,
  answersSize = 29; // as in wasm/answers.hpp
const verdicts: Verdict[] = ["disjoint", "intersecting", "touching", "undecided", "invalid"],
  proofs = ["none", "direction", "point", "points"] as const,
  hulls: Hull[] = ["space", "plane", "line", "center"];

export interface Solved {
  /** Of decide(): with its certificate, of which nothing is trusted until prove() has checked it. */
  truth: Truth;
  /** Of distance(). */
  distance: {
    value: number; // negative: the depth
    error: number;
    least: boolean; // overlapping: no direction is shallower
    direction: Vec;
    on_a: Vec; // from the centre of a
    on_b: Vec; // from the centre of b
  };
}

const numbersOf = (c: Cylinder) => [...c.center, ...c.axis, c.radius, c.height, c.rounding ?? 0];

/** The exact sum of a point and an offset. */
const plus = (from: readonly number[], offset: readonly number[]): Coordinate[] =>
  from.map((x, i) => (offset[i] === 0 ? x : [x, offset[i]!]));

function truthOf(pair: Pair, row: number[]): Truth {
  const verdict = verdicts[row[1]!]!,
    proof = proofs[row[2]!]!,
    flat = [hulls[row[3]!]!, hulls[row[4]!]!] as [Hull, Hull],
    direction = row.slice(6, 9),
    head = row.slice(9, 12),
    tail = row.slice(12, 15);
  const inHulls = flat.some((hull) => hull !== "space") ? { hulls: flat } : {};
  switch (proof) {
    case "direction":
      return { verdict, direction };
    case "point":
      return { verdict, point: plus(head, tail), ...inHulls };
    case "points":
      return { verdict, points: [plus(pair.a.center, head), plus(pair.b.center, tail)], ...inHulls };
    default:
      return { verdict };
  }
}

type Solver = (pair: Pair) => Solved;

let loaded: Solver | null = null;

/** What the solver says of a pair, once it was brought. */
export const solve: Solver = (pair) => {
  if (!loaded) throw new Error("this page holds no solver");
  return loaded(pair);
};

/** Makes solve() ask this WebAssembly module. */
export async function bringSolver(module: BufferSource) {
  const { instance } = await WebAssembly.instantiate(module);
  const { memory, question, answers, answer } = instance.exports as unknown as {
    memory: WebAssembly.Memory;
    question: () => number;
    answers: () => number;
    answer: () => void;
  };
  loaded = (pair) => {
    new Float64Array(memory.buffer, question(), questionSize).set([...numbersOf(pair.a), ...numbersOf(pair.b)]);
    answer();
    const row = [...new Float64Array(memory.buffer, answers(), answersSize)];
    const vec = (at: number) => row.slice(at, at + 3) as Vec;
    return {
      truth: truthOf(pair, row),
      distance: {
        value: row[16]!,
        error: row[17]!,
        least: row[18] === 1,
        direction: vec(20),
        on_a: vec(23),
        on_b: vec(26),
      },
    };
  };
}
