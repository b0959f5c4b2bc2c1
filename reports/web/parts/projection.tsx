// SPDX-License-Identifier: MIT
// Solids as lines on paper: for print, and if the browser has no WebGL.
import type { Vec } from "./data.ts";
import { add, cross, dot, scale, squareTo, sub, unit, type Solid } from "./geometry.ts";
import type { View } from "./stage.ts";

type Flat = [number, number];

function rim(s: Solid, end: 1 | -1): Vec[] {
  const [u, v] = squareTo(s.axis),
    middle = add(s.center, scale(s.axis, end * s.half));
  return Array.from({ length: 72 }, (_, i) => {
    const t = (i * Math.PI) / 36;
    return add(middle, add(scale(u, s.radius * Math.cos(t)), scale(v, s.radius * Math.sin(t))));
  });
}

/** The convex hull, counter-clockwise (Andrew). */
function hull(points: Flat[]): Flat[] {
  const sorted = [...points].sort((p, q) => p[0] - q[0] || p[1] - q[1]);
  const half = (ps: Flat[]) => {
    const kept: Flat[] = [];
    for (const p of ps) {
      while (kept.length > 1) {
        const [o, q] = [kept[kept.length - 2]!, kept[kept.length - 1]!];
        if ((q[0] - o[0]) * (p[1] - o[1]) - (q[1] - o[1]) * (p[0] - o[0]) > 0) break;
        kept.pop();
      }
      kept.push(p);
    }
    return kept.slice(0, -1);
  };
  return [...half(sorted), ...half(sorted.reverse())];
}

type Flatten = (x: Vec) => Flat;

/** To the unit of the picture: x right, y down. */
export function flatten(view: View): Flatten {
  const forward = unit(scale(view.eye, -1)),
    right = unit(cross(forward, view.up)),
    up = cross(right, forward);
  return (x) => {
    const from = sub(x, view.target);
    return [dot(from, right) / view.radius, -dot(from, up) / view.radius];
  };
}

export const path = (points: Flat[]) =>
  points.map(([x, y], i) => `${i === 0 ? "M" : "L"}${x.toFixed(4)} ${y.toFixed(4)}`).join("") + "Z";

/** Points around each, as far away as the outline of a ball. */
const swollen = (points: Flat[], by: number): Flat[] =>
  by === 0
    ? points
    : points.flatMap(([x, y]) =>
        Array.from({ length: 24 }, (_, i): Flat => {
          const t = (i * Math.PI) / 12;
          return [x + by * Math.cos(t), y + by * Math.sin(t)];
        }),
      );

export function Outline({
  of,
  flat,
  view,
  class: name,
}: {
  of: Solid;
  flat: Flatten;
  view: View;
  class: string;
}) {
  const ends = [rim(of, 1), rim(of, -1)].map((points) => points.map(flat)),
    outline = hull(swollen(ends.flat(), of.rounding / view.radius));
  return (
    <g class={name}>
      <path class="body" d={path(outline)} />
      {(of.rounding > 0 ? [outline] : ends).map((points, i) => (
        <path class="rim" d={path(points)} key={i} />
      ))}
    </g>
  );
}

export function Way({ from, to }: { from: Flat; to: Flat }) {
  return <line class="gap" x1={from[0]} y1={from[1]} x2={to[0]} y2={to[1]} />;
}
