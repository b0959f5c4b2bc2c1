// SPDX-License-Identifier: MIT
// The drawing of a pair: both solids as lines, with the points and the plane that are known.
import { polygonHull } from "d3-polygon";
import type { Vec } from "./data.ts";
import type { Drawing } from "./drawing.ts";
import { add, cross, dot, scale, squareTo, sub, unit, type Solid } from "./geometry.ts";

type Flat = [number, number];

function rim(s: Solid, end: 1 | -1): Vec[] {
  const [u, v] = squareTo(s.axis),
    middle = add(s.center, scale(s.axis, end * s.half));
  return Array.from({ length: 72 }, (_, i) => {
    const t = (i * Math.PI) / 36;
    return add(middle, add(scale(u, s.radius * Math.cos(t)), scale(v, s.radius * Math.sin(t))));
  });
}

type Flatten = (x: Vec) => Flat;

/** The radius of the part that is in the picture. */
const radiusOf = (d: Drawing) => 1.12 * d.extent;

/** To the unit of the picture: x right, y down. One looks across the direction of the gap, a little from above; a lies
 *  left of b. */
function flatten(d: Drawing): Flatten {
  const along: Vec = d.direction ?? [1, 0, 0],
    [u, v] = squareTo(along),
    forward = unit(add(add(scale(u, 0.85), scale(v, -0.4)), scale(along, -0.25))),
    right = unit(cross(forward, v)),
    up = cross(right, forward),
    radius = radiusOf(d);
  return (x) => [dot(x, right) / radius, -dot(x, up) / radius];
}

const path = (points: Flat[]) =>
  points.map(([x, y], i) => `${i === 0 ? "M" : "L"}${x.toFixed(4)} ${y.toFixed(4)}`).join("") + "Z";

/** Points around each, as far away as the outline of a ball. */
const swollen = (points: Flat[], by: number): Flat[] =>
  points.flatMap(([x, y]) =>
    Array.from({ length: by === 0 ? 1 : 24 }, (_, i): Flat => {
      const t = (i * Math.PI) / 12;
      return [x + by * Math.cos(t), y + by * Math.sin(t)];
    }),
  );

/** Four faces of a box, which have all of its edges. */
function facesOf({ center, edges: [u, v, w] }: Solid): Vec[][] {
  const face = (out: Vec, along: Vec, up: Vec) =>
    ([[1, 1], [-1, 1], [-1, -1], [1, -1]] as const).map(([i, j]) =>
      add(add(center, out), add(scale(along, i), scale(up, j))),
    );
  return [face(u!, v!, w!), face(scale(u!, -1), v!, w!), face(v!, u!, w!), face(scale(v!, -1), u!, w!)];
}

function outline(of: Solid, flat: Flatten, radius: number, name: string) {
  const isBox = of.edges.length > 0,
    faces = (isBox ? facesOf(of) : [rim(of, 1), rim(of, -1)]).map((points) => points.map(flat)),
    around = polygonHull(swollen(faces.flat(), of.rounding / radius)) ?? [];
  const lines = of.rounding > 0 || (!isBox && of.radius === 0) ? [around, ...(isBox ? faces : [])] : faces;
  return (
    <g class={name}>
      <path class="body" d={path(around)} />
      {lines.map((points, i) => (
        <path class="rim" d={path(points)} key={i} />
      ))}
    </g>
  );
}

export function Projection({ drawing: d, label }: { drawing: Drawing; label: string }) {
  const flat = flatten(d);
  const dotAt = (x: Vec, name: string) => {
    const [cx, cy] = flat(x);
    return <circle class={`mark-${name}`} cx={cx} cy={cy} r={0.014} />;
  };
  let trace = null;
  if (d.plane && d.direction) {
    // as the edge that it would show if one looked along it
    const [u, v] = squareTo(d.direction),
      side = 0.75 * d.extent;
    const corners = [add(u, v), sub(u, v), scale(add(u, v), -1), sub(v, u)];
    trace = <path class="plane" d={path(corners.map((c) => flat(add(d.plane!, scale(c, side)))))} />;
  }
  return (
    <svg class="projection" viewBox="-1.3 -1 2.6 2" role="img" aria-label={label} preserveAspectRatio="xMidYMid meet">
      {trace}
      {outline(d.a, flat, radiusOf(d), "solid-a")}
      {outline(d.b, flat, radiusOf(d), "solid-b")}
      {d.near && (
        <>
          <path class="gap" d={path([flat(d.near.a), flat(d.near.b)])} />
          {dotAt(d.near.a, "a")}
          {dotAt(d.near.b, "b")}
        </>
      )}
      {d.point && dotAt(d.point, "point")}
    </svg>
  );
}
