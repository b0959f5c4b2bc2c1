// SPDX-License-Identifier: MIT
// The robot where it stands, to be turned, on a floor with the axes of the world: pairs within the clearance as
// lines, a picked pair with its models.
import { useEffect, useLayoutEffect, useMemo, useRef, useState } from "preact/hooks";
import type { Object3D } from "three";
import type { Vec } from "../parts/data.ts";
import { colour } from "../parts/elements.tsx";
import { add, cross, dot, scale, sub, unit, type Solid } from "../parts/geometry.ts";
import { SolidsProjection } from "../parts/projection.tsx";
import {
  arrow,
  box,
  ghost,
  grid,
  onPointer,
  mountStage,
  line,
  pointMark,
  solid,
  getStage,
  type View,
} from "../parts/stage.ts";
import { plural } from "../parts/words.ts";
import type { Posed } from "./pose.ts";
import {
  extentOf,
  frameOf,
  middleOf,
  modelColour,
  mostExact,
  standIn,
  type Model,
  type Proof,
  type SceneFrame,
  type Study,
} from "./study.ts";

export interface Shown {
  study: Study;
  at: number; // of study.kept
  posed: Posed;
  picked: number | null; // of study.pairs
  exempt: Proof | null; // a pair that is none of them, and was asked for
  ghosts: ReadonlySet<Model>;
  close: boolean;
  passing: ReadonlySet<number>; // pairs that the filter leaves
}

const faded = 0.07;
/** Faces that would lie in those of the cylinder are drawn this much within. */
const withinFaces = 0.98;

const up: Vec = [0, 0, 1]; // in most scenes
const eye: Vec = unit([1, -1.3, 0.75]);

/** Across a direction, from the usual side and a little from above; along it nothing would be seen of a gap. */
function eyeBeside(along: Vec): Vec {
  const level = cross(along, up),
    wide = Math.sqrt(dot(level, level));
  if (wide < 0.1) return unit([eye[0], eye[1], 0.3]);
  const side = scale(level, Math.sign(dot(level, eye)) / wide || 1 / wide);
  return unit(add(side, [0, 0, 0.3]));
}

function viewOf(solids: Solid[], pair: [Solid, Solid] | null, near: [Vec, Vec] | null): View {
  if (!pair) {
    const target = middleOf(solids);
    return { eye, up, target, radius: 1.04 * extentOf(solids, target) };
  }
  const middle = scale(add(pair[0].center, pair[1].center), 0.5);
  const apart = near ? sub(near[1], near[0]) : sub(pair[1].center, pair[0].center);
  const along = dot(apart, apart) > 1e-18 ? unit(apart) : unit(sub(pair[1].center, pair[0].center));
  return { eye: eyeBeside(along), up, target: middle, radius: 1.15 * extentOf(pair, middle) };
}

function nearOf(frame: SceneFrame, { posed, picked }: Shown): [Vec, Vec] | null {
  if (picked === null) return null;
  const seen = posed.gaps[picked]!;
  return [frame.to(seen.on_a), frame.to(seen.on_b)];
}

/** A round length: the floor has about ten squares across the scene. */
export function floorCell({ unit: u }: SceneFrame): number {
  const about = u / 5,
    decade = 10 ** Math.floor(Math.log10(about));
  return decade * ([5, 2].find((k) => k * decade <= about) ?? 1);
}

/** The floor lies under the lowest point of all configurations kept, its lines on round numbers of the world. */
function surroundings(frame: SceneFrame) {
  const cell = floorCell(frame) / frame.unit,
    origin = frame.to([0, 0, 0]),
    from = ([0, 1] as const).map((i) => origin[i] + Math.round(-origin[i] / cell) * cell) as [number, number];
  const size = 0.22,
    axis = (along: Vec, paint: string, name: string) => arrow(origin, add(origin, scale(along, size)), paint, name);
  return [
    grid([from[0], from[1], frame.floor], cell, 6, colour("--grey")),
    axis([1, 0, 0], colour("--axis-x"), "x"),
    axis([0, 1, 0], colour("--axis-y"), "y"),
    axis([0, 0, 1], colour("--axis-z"), "z"),
  ];
}

/** Which colour a body has, of those of style.css. */
function paintOf({ study, posed, picked, exempt }: Shown, ofBody: (Model | null)[]): (body: number) => string {
  const two = picked === null ? exempt?.bodies : study.pairs[picked]!.bodies;
  const near = new Set(posed.set ? study.pairs.flatMap(({ bodies }, i) => (posed.within[i] ? bodies : [])) : []);
  return (body) => {
    if (two?.includes(body)) return two[0] === body ? "--solid-a" : "--solid-b";
    if (near.has(body)) return "--within-reach";
    if (study.bodies[body]!.holds) return "--grey";
    const model = ofBody[body];
    return model ? modelColour[model] : "--grey";
  };
}

/** How clear a solid is that stands in for a box or mesh. */
const standInOpacity = 0.16;

function objectsOf(shown: Shown, frame: SceneFrame, solids: Solid[], ofBody: (Model | null)[]) {
  const { study, posed, picked, ghosts, passing } = shown,
    extent = extentOf(solids);
  const two = picked === null ? null : study.pairs[picked]!.bodies;
  const paint = paintOf(shown, ofBody);
  const objects: Object3D[] = solids.map((s, i) => {
    const side = two === null ? -1 : two.indexOf(i),
      held = study.bodies[i]!.holds !== undefined;
    const opacity =
      two !== null && side < 0 ? faded : held ? standInOpacity : side >= 0 && ghosts.has("inner capsule") ? 0.4 : 1;
    const drawn = solid(s, colour(paint(i)), extent, opacity);
    drawn.userData.is = { body: i };
    return drawn;
  });
  for (const { body, center, axes } of posed.boxes) {
    const { size } = study.bodies[body]!.holds!;
    const sides = axes.map((axis, k) => scale(axis, size[k]! / frame.unit)) as [Vec, Vec, Vec];
    const drawn = box(frame.to(center), sides, colour("--grey"), two === null || two.includes(body) ? 0.45 : faded);
    drawn.userData.is = { body };
    objects.push(drawn);
  }
  objects.push(...surroundings(frame));
  if (two === null) {
    for (const i of passing) {
      const seen = posed.gaps[i];
      if (!seen || !posed.set || !posed.within[i]) continue;
      const drawn = line([frame.to(seen.on_a), frame.to(seen.on_b)], colour("--within-reach"), { onTop: true });
      drawn.userData.is = { pair: i };
      objects.push(drawn);
    }
    return objects;
  }
  const near = nearOf(frame, shown)!;
  const standing = [...ghosts]
    .flatMap((model) =>
      two.map((i) => {
        const capsule = standIn(solids[i]!, model);
        return (
          capsule &&
          capsule.radius > 0 &&
          ghost(
            { ...capsule, radius: capsule.radius * (model === "outer capsule" ? withinFaces : 1) },
            colour(modelColour[model]),
          )
        );
      }),
    )
    .filter((g) => g !== null && g !== false);
  return [
    ...objects,
    ...standing,
    line(near, colour("--fg"), { onTop: true }),
    pointMark(near[0], colour("--solid-a")),
    pointMark(near[1], colour("--solid-b")),
  ];
}

type Hit = { body?: number; pair?: number };

export function StudyView({
  shown,
  pickPair,
  pickBody,
}: {
  shown: Shown;
  pickPair: (pair: number | null) => void;
  pickBody: (body: number) => void;
}) {
  const { study, at, posed, picked, close } = shown;
  const place = useRef<HTMLDivElement>(null);
  const [under, point] = useState("");
  const frame = useMemo(() => frameOf(study), [study]);
  const ofBody = useMemo(() => mostExact(study), [study]);
  const solids = useMemo(() => posed.cylinders.map(frame.solid), [frame, posed]);
  const two = picked === null ? null : study.pairs[picked]!.bodies;
  const near = nearOf(frame, shown);
  const view = useMemo(
    () => viewOf(solids, close && two ? [solids[two[0]]!, solids[two[1]]!] : null, near),
    // Sliders move the robot, not the reader.
    [frame, at, close, picked],
  );
  const stage = getStage();

  useLayoutEffect(() => {
    if (!stage || !place.current) return;
    return mountStage(stage, place.current, () => stage.show(objectsOf(shown, frame, solids, ofBody)));
  }, [study, posed, picked, shown.exempt, shown.ghosts, shown.passing]);
  // A whole scene is looked at from where the reader has turned to, whichever configuration.
  useLayoutEffect(() => stage?.look(view), [close, close ? view : null]);

  useEffect(() => {
    if (!stage) return;
    return onPointer(
      stage,
      (x, y) => (stage.hit(x, y) as Hit | undefined) ?? null,
      (found) => {
        if (found?.pair !== undefined) pickPair(found.pair);
        else if (found?.body !== undefined) pickBody(found.body);
        else pickPair(null);
      },
      (found) => {
        const pair = found?.pair === undefined ? null : study.pairs[found.pair]!;
        point(pair ? `${pair.a} \u2013 ${pair.b}` : found?.body === undefined ? "" : study.bodies[found.body]!.name);
      },
    );
  }, [study, pickPair, pickBody]);

  const pair = picked === null ? null : study.pairs[picked]!;
  const who = pair === null ? "" : `, ${pair.a} and ${pair.b} picked`,
    label = `The robot: ${plural(study.bodies.length, "solid")}${who}`;
  useLayoutEffect(() => stage?.setAriaLabel(label), [label]);
  const paint = paintOf(shown, ofBody);
  const painted = solids.map((s, i) => ({
    solid: s,
    colour: paint(i),
    faint: (two !== null && !two.includes(i)) || study.bodies[i]!.holds !== undefined,
  }));
  return (
    <div class={`stage ${stage ? "" : "flat"}`} ref={place}>
      <SolidsProjection solids={painted} view={view} near={near} label={label} />
      {under && <span class="under">{under}</span>}
    </div>
  );
}
