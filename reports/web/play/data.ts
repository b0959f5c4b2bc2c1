// SPDX-License-Identifier: MIT
// What the page to play with is given (cli/play.cpp): pairs that somebody gets wrong.
import type { Answer, Pair, Truth } from "../parts/data.ts";

/** What a method says of an example, and what is wrong with that, if anything. */
export interface Said extends Answer {
  method: string;
  version: string;
  recorded?: string; // the date; else asked when the page was written
  wrong?: { kind: string; severity: "contract" | "resolution" | "unresolved" };
}

export interface Example {
  group: "reported" | "rounded" | "engines" | "errata";
  id: string;
  source: string;
  note: string;
  pair: Pair;
  truth: Truth;
  answers: Said[];
}

export interface Play {
  examples: Example[];
}
