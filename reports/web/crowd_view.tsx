// SPDX-License-Identifier: MIT
// Many cylinders in 3D, to be turned: those of a close pair have a colour; a solid or a pair that is picked is seen
// close up, with its neighbours faint.
import { useEffect, useLayoutEffect, useMemo, useRef, useState } from "preact/hooks";
import { cylinder_of, name_of, near_pair, type Crowd } from "./crowd.ts";
import type { Vec } from "./data.ts";
import { add, cross, dot, first_hit, scale, sub, unit, type Solid } from "./geometry.ts";
import { colour } from "./parts.tsx";
import { SolidsProjection } from "./projection.tsx";
import { hear_pointer, keep_painted, line, many, mark, the_stage, type View } from "./stage.ts";
import { extent_of, frame_around, middle_of, type Frame } from "./study.ts";
import { in_order, plural } from "./words.ts";

export type Showing = "all" | "close" | "nearest";
export type Picked = { solid: number } | { pair: readonly [number, number] } | null;

export interface Shown {
  crowd: Crowd;
  partners: ReadonlyMap<number, number[]>;
  showing: Showing;
  picked: Picked;
  fitted: number; // counts how often somebody asked for the first view again
}

/** So many solids beside what is picked are drawn, faint; more would hide it. */
const neighbour_cap = 150;
const faint = 0.13;
/** Pixels by which a solid is missed and still hit. */
const hit_slack = 1.5;

const up: Vec = [0, 0, 1];
const eye: Vec = unit([1, -1.3, 0.75]);
const least_half = 1e-3;
/** Behind the middle what is shown fades, so that one sees what is in front. */
const haze_depth = 1.7;

const ball = (s: Solid) => Math.hypot(s.radius, s.half) + s.rounding;

/** All of them as large as they fit: their middle on the screen, and how far they reach from it. */
function fit(solids: readonly Solid[]): View {
  const forward = unit(scale(eye, -1)),
    right = unit(cross(forward, up)),
    above = cross(right, forward);
  let target: Vec = [0, 0, 0];
  const half = [right, above].map((axis) => {
    let low = Infinity,
      high = -Infinity;
    for (const s of solids) {
      const at = dot(s.center, axis),
        reach = ball(s);
      low = Math.min(low, at - reach);
      high = Math.max(high, at + reach);
    }
    if (!(low <= high)) return least_half;
    target = add(target, scale(axis, (low + high) / 2));
    return Math.max(least_half, 0.515 * (high - low)); // and a little room
  }) as [number, number];
  return { eye, up, target, radius: Math.max(...half), half };
}

interface Scene {
  frame: Frame;
  solids: Solid[];
}

/** What stands in the middle of the picture: the solid with its partners, or the pair. */
function chosen_of({ partners, picked }: Shown): number[] {
  if (picked === null) return [];
  return "pair" in picked ? [...picked.pair] : [picked.solid, ...(partners.get(picked.solid) ?? [])];
}

/** The nearest points of the picked pair, where they were written. */
function near_of({ crowd, picked }: Shown, { frame }: Scene): [Vec, Vec] | null {
  const pair = picked !== null && "pair" in picked ? near_pair(crowd, picked.pair) : undefined;
  if (!pair || !picked || !("pair" in picked)) return null;
  const ends: [Vec, Vec] = [frame.to(pair.on_a), frame.to(pair.on_b)];
  return pair.a === picked.pair[0] ? ends : [ends[1], ends[0]];
}

/** A pair is looked at where it is nearest, as large as the smaller of both asks for. */
function view_of(shown: Shown, scene: Scene, near: [Vec, Vec] | null): View {
  const chosen = chosen_of(shown).map((i) => scene.solids[i]!);
  if (chosen.length === 0) return fit(visible(shown).map((i) => scene.solids[i]!));
  const [first, second] = chosen;
  if (shown.picked && "solid" in shown.picked) return { eye, up, target: first!.center, radius: 1.6 * ball(first!) };
  const middle = near ? scale(add(near[0], near[1]), 0.5) : middle_of(chosen);
  const gap = near ? Math.sqrt(dot(sub(near[1], near[0]), sub(near[1], near[0]))) : 0;
  const least = Math.min(ball(first!), ball(second!));
  return { eye, up, target: middle, radius: Math.min(1.1 * extent_of(chosen, middle), 2.2 * least + gap) };
}

function visible({ crowd, partners, showing }: Shown): number[] {
  if (showing === "all") return crowd.solids.map((_, i) => i);
  if (showing === "close") return in_order([...partners.keys()], (x, y) => x - y);
  return [...new Set(crowd.nearest.flatMap(({ a, b }) => [a, b]))];
}

/** The solids that come nearest to the middle of what is picked, the nearest first. */
function neighbours(chosen: number[], target: Vec, { solids }: Scene): number[] {
  const taken = new Set(chosen);
  const ways = solids.flatMap((s, i) => {
    const way = sub(s.center, target);
    return taken.has(i) ? [] : [[Math.sqrt(dot(way, way)) - ball(s), i] as const];
  });
  return in_order(ways, (x, y) => x[0] - y[0])
    .slice(0, neighbour_cap)
    .map(([, i]) => i);
}

/** Which solids are drawn, each in the colour of style.css of its part. */
function painted_of(shown: Shown, scene: Scene, view: View) {
  const { partners, picked } = shown,
    chosen = chosen_of(shown);
  if (picked === null)
    return visible(shown).map((i) => {
      return { i, colour: partners.has(i) ? "--crowd-close" : "--crowd-apart", faint: false };
    });
  return [
    ...chosen.map((i, k) => ({ i, colour: k === 0 ? "--solid-a" : "--solid-b", faint: false })),
    ...neighbours(chosen, view.target, scene).map((i) => ({ i, colour: "--grey", faint: true })),
  ];
}

export function CrowdView({ shown, pick }: { shown: Shown; pick: (solid: number | null) => void }) {
  const { crowd, picked } = shown;
  const place = useRef<HTMLDivElement>(null);
  const [under, point] = useState("");
  const scene = useMemo((): Scene => {
    const cylinders = crowd.solids.map(cylinder_of),
      frame = frame_around(cylinders);
    return { frame, solids: cylinders.map(frame.solid) };
  }, [crowd]);
  const near = useMemo(() => near_of(shown, scene), [scene, picked]);
  const view = useMemo(() => view_of(shown, scene, near), [scene, picked, shown.showing]);
  const painted = useMemo(() => painted_of(shown, scene, view), [scene, picked, shown.showing]);
  const stage = the_stage();

  useLayoutEffect(() => {
    if (!stage || !place.current) return;
    const show = () => {
      const paints = new Map([...new Set(painted.map((p) => p.colour))].map((name) => [name, colour(name)]));
      const of = (is_faint: boolean, opacity: number) => {
        const some = painted.filter((p) => p.faint === is_faint);
        const solids = some.map(({ i }) => scene.solids[i]!),
          colours = some.map((p) => paints.get(p.colour)!);
        return some.length === 0 ? [] : [many(solids, colours, view.radius, opacity)];
      };
      const marks = near
        ? [
            line(near, colour("--fg"), { on_top: true }),
            mark(near[0], colour("--solid-a")),
            mark(near[1], colour("--solid-b")),
          ]
        : [];
      const haze = { colour: colour("--panel"), near: view.radius, far: haze_depth * view.radius };
      stage.show([...of(false, 1), ...of(true, faint), ...marks], picked === null ? haze : null);
    };
    return keep_painted(stage, place.current, show);
  }, [painted]);
  useLayoutEffect(() => stage?.look(view), [view, shown.fitted]);

  useEffect(() => {
    if (!stage) return;
    const solids = painted.map(({ i }) => scene.solids[i]!);
    return hear_pointer(
      stage,
      (x, y) => {
        const { from, along, pixel } = stage.ray(x, y);
        const found = first_hit(from, along, solids, hit_slack * pixel);
        return found < 0 ? null : painted[found]!.i;
      },
      pick,
      (found) => point(found === null ? "" : name_of(crowd, found)),
    );
  }, [painted, pick]);

  const chosen = chosen_of(shown).map((i) => name_of(crowd, i));
  const label = `${plural(crowd.cylinders, "cylinder")}${chosen.length > 0 ? `, ${chosen.join(" and ")} picked` : ""}`;
  useLayoutEffect(() => stage?.tell(label), [label]);
  // On paper, and without WebGL, what is picked is drawn as lines.
  const flat = painted.filter((p) => !p.faint && picked !== null);
  return (
    <div class={`stage crowd ${stage ? "" : "flat"}`} ref={place}>
      {picked !== null && (
        <SolidsProjection
          solids={flat.map((p) => ({ solid: scene.solids[p.i]!, colour: p.colour, faint: false }))}
          view={view}
          near={near}
          label={label}
        />
      )}
      {!stage && picked === null && (
        <p class="missing">
          This browser has no WebGL, which the picture of {plural(crowd.cylinders, "cylinder")} needs. A pair or a
          cylinder that is picked is drawn as lines; all else on this page is here.
        </p>
      )}
      {under && <span class="under">{under}</span>}
    </div>
  );
}
