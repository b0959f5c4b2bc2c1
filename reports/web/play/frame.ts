// SPDX-License-Identifier: MIT
// The frame of the drawing. It stays while a solid is dragged, or the picture would move under the hand.
import type { Pair, Shown, Vec } from "../parts/data.ts";
import { drawingOf, type Drawing } from "../parts/drawing.ts";
import { add, scale, sub, type Solid } from "../parts/geometry.ts";
import type { Solved } from "../parts/solver.ts";

export interface Frame {
  origin: Vec; // of the scene, drawn as 0
  unit: number; // of the scene, drawn as 1
}

const middleOf = ({ a, b }: Pair): Vec => add(scale(a.center, 0.5), scale(b.center, 0.5));

export function shownOf(pair: Pair, { truth, distance }: Solved): Shown {
  const { value, error, direction, on_a, on_b } = distance,
    isMeasured = truth.verdict !== "invalid";
  if (!isMeasured) return { pair, truth };
  return {
    pair,
    truth: { ...truth, distance: [value - error, value + error] },
    direction,
    nearest: { a: add(pair.a.center, on_a), b: add(pair.b.center, on_b) },
  };
}

/** The frame that drawingOf() chooses for a pair. */
export const frameOf = (shown: Shown): Frame => ({ origin: middleOf(shown.pair), unit: drawingOf(shown).unit });

/** The drawing of a pair in a frame that another pair may have chosen. */
export function drawnIn(frame: Frame, shown: Shown): Drawing {
  const d = drawingOf(shown),
    k = d.unit / frame.unit,
    shift = scale(sub(middleOf(shown.pair), frame.origin), 1 / frame.unit);
  const at = (x: Vec): Vec => add(scale(x, k), shift);
  const resized = (s: Solid): Solid => ({
    ...s,
    center: at(s.center),
    radius: k * s.radius,
    half: k * s.half,
    rounding: k * s.rounding,
  });
  return {
    ...d,
    a: resized(d.a),
    b: resized(d.b),
    unit: frame.unit,
    extent: k * d.extent,
    contact: at(d.contact),
    near: d.near && { a: at(d.near.a), b: at(d.near.b) },
    plane: d.plane && at(d.plane),
    point: d.point && at(d.point),
    gap: d.gap && k * d.gap,
  };
}

/** Whether a drawing has outgrown what is seen, or shrunk to a dot in it. */
export function isOff(d: Drawing, seen: number): boolean {
  const far = Math.max(...[d.a, d.b].map((s) => Math.hypot(...s.center) + Math.hypot(s.radius, s.half) + s.rounding));
  return !(far < 1.5 * seen && d.extent > 0.25 * seen);
}
