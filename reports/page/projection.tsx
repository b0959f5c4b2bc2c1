// SPDX-License-Identifier: MIT
// The same drawing as lines on paper: for print, and where there is no WebGL.
import type { Vec } from "./data.ts";
import { add, cross, dot, scale, square_to, sub, unit, type Drawing, type Solid } from "./geometry.ts";
import type { View } from "./scene.ts";

type Flat = [number, number];

function rim(s: Solid, end: 1 | -1): Vec[] {
  const [u, v] = square_to(s.axis), middle = add(s.center, scale(s.axis, end * s.half));
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

export function Projection({ drawing: d, view, label }: { drawing: Drawing; view: View; label: string }) {
  const forward = unit(scale(view.eye, -1)), right = unit(cross(forward, view.up)), up = cross(right, forward);
  const flat = (x: Vec): Flat => { const from = sub(x, view.target); return [dot(from, right) / view.radius, -dot(from, up) / view.radius]; };
  const path = (points: Flat[]) => points.map(([x, y], i) => `${i === 0 ? "M" : "L"}${x.toFixed(4)} ${y.toFixed(4)}`).join("") + "Z";
  const solid = (s: Solid, name: string) => {
    const ends = [rim(s, 1), rim(s, -1)].map((points) => points.map(flat));
    return <g class={`solid-${name}`}><path class="body" d={path(hull(ends.flat()))} />{ends.map((points, i) => <path class="rim" d={path(points)} key={i} />)}</g>;
  };
  const dot_at = (x: Vec, name: string) => { const [cx, cy] = flat(x); return <circle class={`mark-${name}`} cx={cx} cy={cy} r={0.014} />; };
  let trace = null;
  if (d.plane && d.direction) {  // as the edge that it would show if one looked along it
    const [u, v] = square_to(d.direction), side = 0.75 * d.extent;
    const corners = [[1, 1], [1, -1], [-1, -1], [-1, 1]].map(([p, q]) => flat(add(d.plane!, add(scale(u, p! * side), scale(v, q! * side)))));
    trace = <path class="plane" d={path(corners)} />;
  }
  return (
    <svg class="projection" viewBox="-1.3 -1 2.6 2" role="img" aria-label={label} preserveAspectRatio="xMidYMid meet">
      {trace}{solid(d.a, "a")}{solid(d.b, "b")}
      {d.near && <><line class="gap" x1={flat(d.near.a)[0]} y1={flat(d.near.a)[1]} x2={flat(d.near.b)[0]} y2={flat(d.near.b)[1]} />{dot_at(d.near.a, "a")}{dot_at(d.near.b, "b")}</>}
      {d.point && dot_at(d.point, "point")}
    </svg>
  );
}
