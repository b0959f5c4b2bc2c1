// SPDX-License-Identifier: MIT
// Forward kinematics: where every solid and box of a robot is at given values of its joints, as in scenes/scene.cpp.
import type { Cylinder, Vec } from "../parts/data.ts";
import { add, cross, dot, scale } from "../parts/geometry.ts";

/** A frame in another: its origin, and the directions of its x, y and z. */
interface Pose {
  center: Vec;
  axes: [Vec, Vec, Vec];
}
export interface StudiedLink {
  name: string;
  motion: "fixed" | "held" | "turn" | "slide";
  origin: Pose;
  parent?: number; // comes before this link
  joint?: string;
  axis?: Vec;
  limits?: [number, number]; // of a joint that moves by itself: rad of a turn, the scene's length of a slide
  follows?: { link: number; multiplier: number; offset: number };
}
export interface StudiedBody {
  name: string;
  link: string;
  on: number; // its link
  solid: Cylinder; // in the link's frame
  holds?: { shape: string; size: Vec; pose: Pose };
}
export interface PlacedBox extends Pose {
  body: number;
}
export interface Placed {
  cylinders: Cylinder[];
  boxes: PlacedBox[];
}

const turned = ({ axes }: Pose, v: Vec): Vec =>
  add(add(scale(axes[0], v[0]), scale(axes[1], v[1])), scale(axes[2], v[2]));
const moved = (pose: Pose, x: Vec): Vec => add(pose.center, turned(pose, x));
const then = (pose: Pose, next: Pose): Pose => ({
  center: moved(pose, next.center),
  axes: next.axes.map((axis) => turned(pose, axis)) as Pose["axes"],
});

/** A vector turned about a unit axis (Rodrigues). */
function aboutAxis(axis: Vec, angle: number, v: Vec): Vec {
  const c = Math.cos(angle);
  return add(add(scale(v, c), scale(cross(axis, v), Math.sin(angle))), scale(axis, (1 - c) * dot(axis, v)));
}

function motionOf(link: StudiedLink, value: number): Pose {
  const still: Pose["axes"] = [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ];
  if (link.motion === "slide") return { center: scale(link.axis!, value), axes: still };
  const turn = (v: Vec) => (link.motion === "turn" ? aboutAxis(link.axis!, value, v) : v);
  return { center: [0, 0, 0], axes: still.map(turn) as Pose["axes"] };
}

/** The links whose joints move by themselves. */
export const freeJoints = (links: StudiedLink[]) => links.flatMap((link, i) => (link.limits ? [i] : []));

/** The value of every link's joint: of those named as told, of others 0 or the limit nearest to it; mimics follow. */
export function jointValues(links: StudiedLink[], told: Readonly<Record<string, number>>): number[] {
  const values = links.map(({ joint, limits }) =>
    limits ? (joint !== undefined && Object.hasOwn(told, joint) ? told[joint]! : clamped(0, limits)) : 0,
  );
  // A joint may follow one that follows: each round settles at least the next of a chain.
  for (let round = 0; round < links.length; ++round)
    links.forEach(({ follows }, i) => {
      if (follows) values[i] = follows.multiplier * values[follows.link]! + follows.offset;
    });
  return values;
}
const clamped = (x: number, [low, high]: readonly [number, number]) => Math.max(low, Math.min(x, high));

function linkPoses(links: StudiedLink[], values: readonly number[]): Pose[] {
  const poses: Pose[] = [];
  for (const [i, link] of links.entries()) {
    const own = then(link.origin, motionOf(link, values[i]!));
    poses.push(link.parent === undefined ? own : then(poses[link.parent]!, own));
  }
  return poses;
}

export function placed(links: StudiedLink[], bodies: StudiedBody[], values: readonly number[]): Placed {
  const poses = linkPoses(links, values);
  return {
    cylinders: bodies.map(({ solid, on }) => ({
      ...solid,
      center: moved(poses[on]!, solid.center),
      axis: turned(poses[on]!, solid.axis),
    })),
    boxes: bodies.flatMap(({ holds, on }, body) => (holds ? [{ body, ...then(poses[on]!, holds.pose) }] : [])),
  };
}
