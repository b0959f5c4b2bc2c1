// SPDX-License-Identifier: MIT
// The drawing of a pair as lines on paper: for print, and if the browser has no WebGL.
import type { Vec } from "./data.ts";
import { add, scale, squareTo } from "./geometry.ts";
import { flatten, Outline, path, Way } from "./projection.tsx";
import type { View } from "./stage.ts";
import type { Drawing } from "./drawing.ts";

export function Projection({ drawing: d, view, label }: { drawing: Drawing; view: View; label: string }) {
  const flat = flatten(view);
  const dotAt = (x: Vec, name: string) => {
    const [cx, cy] = flat(x);
    return <circle class={`mark-${name}`} cx={cx} cy={cy} r={0.014} />;
  };
  let trace = null;
  if (d.plane && d.direction) {
    // as the edge that it would show if one looked along it
    const [u, v] = squareTo(d.direction),
      side = 0.75 * d.extent;
    const corners = [
      [1, 1],
      [1, -1],
      [-1, -1],
      [-1, 1],
    ].map(([p, q]) => flat(add(d.plane!, add(scale(u, p! * side), scale(v, q! * side)))));
    trace = <path class="plane" d={path(corners)} />;
  }
  return (
    <svg class="projection" viewBox="-1.3 -1 2.6 2" role="img" aria-label={label} preserveAspectRatio="xMidYMid meet">
      {trace}
      <Outline of={d.a} flat={flat} view={view} class="solid-a" />
      <Outline of={d.b} flat={flat} view={view} class="solid-b" />
      {d.near && (
        <>
          <Way from={flat(d.near.a)} to={flat(d.near.b)} />
          {dotAt(d.near.a, "a")}
          {dotAt(d.near.b, "b")}
        </>
      )}
      {d.point && dotAt(d.point, "point")}
    </svg>
  );
}
