// SPDX-License-Identifier: MIT
// The robot in one of the kept configurations, to be turned: pairs as lines, a picked pair with its models.
import { useEffect, useLayoutEffect, useMemo, useRef, useState } from "preact/hooks";
import type { Vec } from "./data.ts";
import { add, cross, dot, scale, sub, unit, type Solid } from "./geometry.ts";
import { colour } from "./parts.tsx";
import { SolidsProjection } from "./projection.tsx";
import { ghost, line, mark, solid, the_stage, type View } from "./stage.ts";
import {
  extent_of,
  frame_of,
  middle_of,
  model_colour,
  most_exact,
  stand_in,
  type Frame,
  type Model,
  type Study,
} from "./study.ts";
import { in_order } from "./words.ts";

export interface Shown {
  study: Study;
  at: number; // of study.kept
  picked: number | null; // of study.pairs
  ghosts: ReadonlySet<Model>;
  close: boolean;
  passing: ReadonlySet<number>; // pairs that are drawn as lines
}

const faded = 0.07;
/** Lines are fainter the longer they are, as part of the drawing; those of pairs that need no more than spheres are
 * most, and of least interest. */
const line_opacity = (model: Model, length: number) =>
  (model === "sphere" ? 0.25 : 1) * Math.max(0.25, 1 - 1.5 * Math.max(0, length));
/** The nearest pairs are drawn as lines, so many; a picture of more is grey. */
const line_cap = 500;
/** Faces that would lie in those of the cylinder are drawn this much within. */
const within_faces = 0.98;

const up: Vec = [0, 0, 1]; // in most scenes
const eye: Vec = unit([1, -1.3, 0.75]);

/** Across a direction, from the usual side and a little from above; along it nothing would be seen of a gap. */
function eye_beside(along: Vec): Vec {
  const level = cross(along, up),
    wide = Math.sqrt(dot(level, level));
  if (wide < 0.1) return unit([eye[0], eye[1], 0.3]);
  const side = scale(level, Math.sign(dot(level, eye)) / wide || 1 / wide);
  return unit(add(side, [0, 0, 0.3]));
}

function view_of(solids: Solid[], pair: [Solid, Solid] | null, near: [Vec, Vec] | null): View {
  if (!pair) {
    const target = middle_of(solids);
    return { eye, up, target, radius: 1.04 * extent_of(solids, target) };
  }
  const middle = scale(add(pair[0].center, pair[1].center), 0.5);
  const apart = near ? sub(near[1], near[0]) : sub(pair[1].center, pair[0].center);
  const along = dot(apart, apart) > 1e-18 ? unit(apart) : unit(sub(pair[1].center, pair[0].center));
  return { eye: eye_beside(along), up, target: middle, radius: 1.15 * extent_of(pair, middle) };
}

function near_of(frame: Frame, { study, at, picked }: Shown): [Vec, Vec] | null {
  if (picked === null) return null;
  const seen = study.kept[at]!.pairs[picked]!;
  return [frame.to(seen.on_a), frame.to(seen.on_b)];
}

function objects_of(shown: Shown, frame: Frame, solids: Solid[], of_body: (Model | null)[]) {
  const { study, at, picked, ghosts, passing } = shown,
    extent = extent_of(solids);
  const two = picked === null ? null : study.pairs[picked]!.bodies;
  const objects = solids.map((s, i) => {
    const side = two === null ? -1 : two.indexOf(i),
      model = of_body[i];
    const paint =
      side >= 0 ? colour(side === 0 ? "--solid-a" : "--solid-b") : colour(model ? model_colour[model] : "--grey");
    const drawn = solid(s, paint, extent, two === null ? 1 : side < 0 ? faded : ghosts.has("inner capsule") ? 0.4 : 1);
    drawn.userData.is = { body: i };
    return drawn;
  });
  if (two === null) {
    const { pairs } = study.kept[at]!;
    for (const i of in_order([...passing], (x, y) => pairs[x]!.distance - pairs[y]!.distance).slice(0, line_cap)) {
      const seen = pairs[i]!,
        { needs: model } = study.pairs[i]!;
      const drawn = line([frame.to(seen.on_a), frame.to(seen.on_b)], colour(model_colour[model]), {
        opacity: line_opacity(model, seen.distance / frame.unit),
      });
      drawn.userData.is = { pair: i };
      objects.push(drawn as never);
    }
    return objects;
  }
  const near = near_of(frame, shown)!;
  const standing = [...ghosts]
    .flatMap((model) =>
      two.map((i) => {
        const capsule = stand_in(solids[i]!, model);
        return (
          capsule &&
          capsule.radius > 0 &&
          ghost(
            { ...capsule, radius: capsule.radius * (model === "outer capsule" ? within_faces : 1) },
            colour(model_colour[model]),
          )
        );
      }),
    )
    .filter((g) => g !== null && g !== false);
  return [
    ...objects,
    ...standing,
    line(near, colour("--fg"), { on_top: true }),
    mark(near[0], colour("--solid-a")),
    mark(near[1], colour("--solid-b")),
  ];
}

type Hit = { body?: number; pair?: number } | undefined;

export function StudyView({
  shown,
  pick_pair,
  pick_body,
}: {
  shown: Shown;
  pick_pair: (pair: number | null) => void;
  pick_body: (body: number) => void;
}) {
  const { study, at, picked, close } = shown;
  const place = useRef<HTMLDivElement>(null);
  const [under, point] = useState("");
  const frame = useMemo(() => frame_of(study), [study]);
  const of_body = useMemo(() => most_exact(study), [study]);
  const solids = useMemo(() => study.kept[at]!.cylinders.map(frame.solid), [frame, at]);
  const two = picked === null ? null : study.pairs[picked]!.bodies;
  const near = near_of(frame, shown);
  const view = useMemo(
    () => view_of(solids, close && two ? [solids[two[0]]!, solids[two[1]]!] : null, near),
    [solids, close, picked],
  );
  const stage = the_stage();

  useLayoutEffect(() => {
    if (!stage || !place.current) return;
    place.current.append(stage.canvas);
    const paint = () => {
      stage.show(objects_of(shown, frame, solids, of_body));
      stage.draw();
    };
    paint();
    const observer = new ResizeObserver(() => stage.draw());
    observer.observe(place.current);
    const scheme = matchMedia("(prefers-color-scheme: dark)");
    scheme.addEventListener("change", paint);
    return () => {
      observer.disconnect();
      scheme.removeEventListener("change", paint);
    };
  }, [study, at, picked, shown.ghosts, shown.passing]);
  // A whole scene is looked at from where the reader has turned to, whichever configuration.
  useLayoutEffect(() => stage?.look(view), [close, close ? view : null]);

  useEffect(() => {
    if (!stage) return;
    let from: [number, number] | null = null;
    const hit = (event: PointerEvent) => stage.hit(event.offsetX, event.offsetY) as Hit;
    const down = (event: PointerEvent) => {
      from = [event.offsetX, event.offsetY];
    };
    const up = (event: PointerEvent) => {
      if (!from || Math.hypot(event.offsetX - from[0], event.offsetY - from[1]) > 4) return; // it was turned
      const found = hit(event);
      if (found?.pair !== undefined) pick_pair(found.pair);
      else if (found?.body !== undefined) pick_body(found.body);
      else pick_pair(null);
    };
    const move = (event: PointerEvent) => {
      if (event.buttons !== 0) return;
      const found = hit(event);
      const pair = found?.pair === undefined ? null : study.pairs[found.pair]!;
      point(pair ? `${pair.a} \u2013 ${pair.b}` : found?.body === undefined ? "" : study.bodies[found.body]!.name);
      stage.canvas.style.cursor = found ? "pointer" : "grab";
    };
    const leave = () => point("");
    const { canvas } = stage;
    canvas.addEventListener("pointerdown", down);
    canvas.addEventListener("pointerup", up);
    canvas.addEventListener("pointermove", move);
    canvas.addEventListener("pointerleave", leave);
    return () => {
      canvas.removeEventListener("pointerdown", down);
      canvas.removeEventListener("pointerup", up);
      canvas.removeEventListener("pointermove", move);
      canvas.removeEventListener("pointerleave", leave);
    };
  }, [study, pick_pair, pick_body]);

  const pair = picked === null ? null : study.pairs[picked]!;
  const label = `${study.cylinders} cylinders${pair === null ? "" : `, ${pair.a} and ${pair.b} picked`}`;
  useLayoutEffect(() => stage?.tell(label), [label]);
  const painted = solids.map((s, i) => ({
    solid: s,
    colour:
      two?.[0] === i ? "--solid-a" : two?.[1] === i ? "--solid-b" : of_body[i] ? model_colour[of_body[i]!] : "--grey",
    faint: two !== null && !two.includes(i),
  }));
  return (
    <div class={`stage ${stage ? "" : "flat"}`} ref={place}>
      <SolidsProjection solids={painted} view={view} near={near} label={label} />
      {under && <span class="under">{under}</span>}
    </div>
  );
}
