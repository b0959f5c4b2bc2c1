// SPDX-License-Identifier: MIT
// The pair in 3D with handles that move, turn and resize a solid: buttons over the picture, for the pointer and for the
// arrow keys.
import { useLayoutEffect, useMemo, useRef, useState } from "preact/hooks";
import type { Cylinder, Pair, Vec } from "../parts/data.ts";
import { add, cross, dot, scale, squareTo, unit as unitVector, type Solid } from "../parts/geometry.ts";
import { objectsOf, viewOf } from "../parts/pair_objects.ts";
import { Projection } from "../parts/pair_projection.tsx";
import { flatten } from "../parts/projection.tsx";
import { getStage, mountStage, type View } from "../parts/stage.ts";
import type { Solved } from "../parts/solver.ts";
import { drawnIn, frameOf, isOff, shownOf, type Frame } from "./frame.ts";
import { kindOf, tidy } from "./solids.ts";

type Side = "a" | "b";
type Does = "move" | "turn" | "resize";
interface Handle {
  side: Side;
  does: Does;
  at: Vec; // as drawn
}
interface Fit {
  version: number;
  frame: Frame;
  view: View;
}
/** How the reader sees the scene: where a point is on the picture, and the way in the scene of a way on it. */
interface Sight {
  at: (x: Vec) => [number, number];
  way: (right: number, down: number) => Vec;
}

/** The handle that resizes lies beside the axis, where it is first seen from the side. */
function besideOf(s: Solid, eye: Vec): Vec {
  const out = cross(s.axis, eye);
  return dot(out, out) > 1e-6 ? unitVector(out) : squareTo(s.axis)[0];
}

function handlesOf(side: Side, s: Solid, kind: string, eye: Vec): Handle[] {
  const wide = s.radius + s.rounding;
  return [
    { side, does: "move", at: s.center },
    ...(kind === "sphere"
      ? []
      : [{ side, does: "turn" as const, at: add(s.center, scale(s.axis, s.half + s.rounding)) }]),
    { side, does: "resize", at: add(s.center, scale(besideOf(s, eye), wide)) },
  ];
}

/** The solid after a handle went some way, in the scene's lengths. */
function pulled(c: Cylinder, s: Solid, does: Does, way: Vec, { frame, view }: Fit): Cylinder {
  const lengths = (v: Vec): Vec => scale(v, frame.unit);
  if (does === "move")
    return { ...c, center: add(c.center, lengths(way)).map((x) => tidy(x, frame.unit)) as Vec };
  if (does === "turn") {
    const end = add(scale(s.axis, s.half + s.rounding), way);
    return dot(end, end) > 0 ? { ...c, axis: unitVector(end).map((x) => tidy(x, 1)) as Vec } : c;
  }
  const by = dot(way, besideOf(s, view.eye)) * frame.unit,
    key = c.radius > 0 || !(c.rounding! > 0) ? "radius" : "rounding";
  return { ...c, [key]: Math.max(0, tidy((c[key] ?? 0) + by, frame.unit)) };
}

function flatSight(view: View, place: HTMLElement): Sight {
  const flat = flatten(view),
    { clientWidth: width, clientHeight: height } = place,
    scaled = Math.min(width / 2.6, height / 2); // the box of the projection
  const forward = unitVector(scale(view.eye, -1)),
    right = unitVector(cross(forward, view.up)),
    up = cross(right, forward);
  return {
    at: (x) => {
      const [u, v] = flat(x);
      return [width / 2 + u * scaled, height / 2 + v * scaled];
    },
    way: (u, v) => add(scale(right, (u * view.radius) / scaled), scale(up, (-v * view.radius) / scaled)),
  };
}

const arrows: Record<string, [number, number]> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};
/** Pixels that an arrow key pulls a handle, and with Shift. */
const stride = 10,
  fine = 1;

const names: Record<Does, string> = { move: "Move", turn: "Turn", resize: "Resize" };

export function PlayView({
  pair,
  solved,
  version,
  change,
}: {
  pair: Pair;
  solved: Solved;
  version: number; // another pair was chosen: look at it anew
  change: (pair: Pair) => void;
}) {
  const place = useRef<HTMLDivElement>(null),
    over = useRef<HTMLDivElement>(null);
  const stage = getStage();
  const shown = useMemo(() => shownOf(pair, solved), [pair, solved]);
  const [fitted, fit] = useState<Fit | null>(null);
  const [pull, begin] = useState<{ from: [number, number]; handle: Handle; solid: Solid; was: Cylinder } | null>(null);
  const fresh = () => {
    const frame = frameOf(shown);
    return { version, frame, view: viewOf(drawnIn(frame, shown), false) };
  };
  let now = fitted;
  if (!now || now.version !== version || (!pull && isOff(drawnIn(now.frame, shown), now.view.radius))) {
    now = fresh();
    fit(now);
  }
  const { frame, view } = now;
  const drawing = useMemo(() => drawnIn(frame, shown), [frame, shown]);
  const handles = (["a", "b"] as const).flatMap((side) => handlesOf(side, drawing[side], kindOf(pair[side]), view.eye));

  const sight = (): Sight => stage ?? flatSight(view, place.current!);
  const setAside = () => {
    if (!over.current || !place.current) return;
    const seen = sight(),
      { clientWidth: width, clientHeight: height } = place.current;
    [...over.current.children].forEach((button, i) => {
      const [x, y] = handles[i] ? seen.at(handles[i].at) : [NaN, NaN],
        isSeen = x >= 0 && x <= width && y >= 0 && y <= height;
      Object.assign((button as HTMLElement).style, {
        left: `${isSeen ? x : 0}px`,
        top: `${isSeen ? y : 0}px`,
        visibility: isSeen ? "visible" : "hidden",
      });
    });
  };
  useLayoutEffect(() => {
    if (!stage || !place.current) return;
    return mountStage(stage, place.current, () => stage.show(objectsOf(drawing)));
  }, [drawing]);
  useLayoutEffect(() => stage?.look(view), [view]);
  useLayoutEffect(() => {
    if (stage) stage.drawn = setAside;
    setAside();
  });

  const label = `Solid a and solid b, ${solved.truth.verdict}`;
  useLayoutEffect(() => stage?.setAriaLabel(label), [label]);

  const put = (side: Side, solid: Cylinder) => change({ ...pair, [side]: solid });
  const grab = (event: PointerEvent, handle: Handle) => {
    (event.currentTarget as HTMLElement).setPointerCapture(event.pointerId);
    begin({
      from: [event.clientX, event.clientY],
      handle,
      solid: drawing[handle.side],
      was: pair[handle.side],
    });
  };
  const drag = (event: PointerEvent) => {
    if (!pull) return;
    const { from, handle, solid, was } = pull;
    const way = sight().way(event.clientX - from[0], event.clientY - from[1]);
    put(handle.side, pulled(was, solid, handle.does, way, now));
  };
  const step = (event: KeyboardEvent, { side, does }: Handle) => {
    const arrow = arrows[event.key];
    if (!arrow) return;
    event.preventDefault();
    const by = event.shiftKey ? fine : stride;
    let [right, down] = [arrow[0] * by, arrow[1] * by];
    if (does === "resize") {
      // Up and right make it larger, wherever the handle is drawn.
      const seen = sight(),
        { center } = drawing[side],
        [x0, y0] = seen.at(center),
        [x1, y1] = seen.at(add(center, besideOf(drawing[side], view.eye))),
        share = (right - down) / (Math.hypot(x1 - x0, y1 - y0) || 1);
      [right, down] = [(x1 - x0) * share, (y1 - y0) * share];
    }
    put(side, pulled(pair[side], drawing[side], does, sight().way(right, down), now));
  };

  return (
    <figure class="pair-view">
      <div class="stage-tools">
        <button type="button" onClick={() => fit(fresh())}>
          Whole pair
        </button>
        <span class="swatches">
          <i class="a" /> a <i class="b" /> b
          {drawing.plane && (
            <>
              <i class="plane" /> plane between
            </>
          )}
          {drawing.point && (
            <>
              <i class="point" /> common point
            </>
          )}
        </span>
      </div>
      <div class={`stage ${stage ? "" : "flat"}`} ref={place}>
        <Projection drawing={drawing} view={view} label={label} />
        <div class="handles" ref={over} role="group" aria-label="Handles">
          {handles.map((handle) => (
            <button
              type="button"
              class={`handle ${handle.side} ${handle.does}`}
              key={handle.side + handle.does}
              aria-label={`${names[handle.does]} ${handle.side}`}
              title={`${names[handle.does]} ${handle.side}: drag, or press arrow keys`}
              onPointerDown={(event) => grab(event, handle)}
              onPointerMove={drag}
              onPointerUp={() => begin(null)}
              onPointerCancel={() => begin(null)}
              onKeyDown={(event) => step(event, handle)}
            />
          ))}
        </div>
      </div>
      <figcaption>
        Drag a handle, or select one and press arrow keys (with Shift in small steps). A disc moves the solid, a ring
        turns it, a square resizes it. {stage ? "Drag beside them to turn the view, wheel to zoom." : ""} To scale.
      </figcaption>
    </figure>
  );
}
