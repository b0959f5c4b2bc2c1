// SPDX-License-Identifier: MIT
// What stands on the stage for a pair, and from where it is seen.
import type { Vec } from "./data.ts";
import type { Drawing } from "./drawing.ts";
import { colour } from "./elements.tsx";
import { add, scale, squareTo } from "./geometry.ts";
import { line, plane, pointMark, solid, type View } from "./stage.ts";

/** Looking across the direction of the gap, a little from above; a lies left of b. */
export function viewOf(d: Drawing, close: boolean): View {
  const along: Vec = d.direction ?? [1, 0, 0],
    [u, v] = squareTo(along);
  const eye = add(add(scale(u, -0.85), scale(v, 0.4)), scale(along, 0.25));
  return { eye, up: v, target: close ? d.contact : [0, 0, 0], radius: close ? 0.25 * d.extent : 1.12 * d.extent };
}

export function objectsOf(d: Drawing) {
  const a = colour("--solid-a"),
    b = colour("--solid-b"),
    fg = colour("--fg");
  return [
    solid(d.a, a, d.extent),
    solid(d.b, b, d.extent),
    ...(d.plane && d.direction ? [plane(d.plane, d.direction, 1.5 * d.extent, colour("--grey"))] : []),
    ...(d.near
      ? [pointMark(d.near.a, a), pointMark(d.near.b, b), line([d.near.a, d.near.b], fg, { onTop: true })]
      : []),
    ...(d.point ? [pointMark(d.point, fg)] : []),
  ];
}
