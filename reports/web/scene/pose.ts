// SPDX-License-Identifier: MIT
// What is shown of a robot: one of the kept configurations as it was measured, or its joints as the reader sets them.
import { gap, gapsOf, type Gap } from "./gap.ts";
import { freeJoints, jointValues, placed, type Placed } from "./kinematics.ts";
import type { Study } from "./study.ts";

export interface Posed extends Placed {
  set: boolean; // by the reader: gaps are computed in the page
  joints: Record<string, number>;
  values: number[]; // by link, mimics too
  gaps: (Gap | null)[]; // by pair; null: beyond the clearance, and not computed
  within: boolean[];
}

/** So many gaps are computed, and as many more as are needed to know all within the clearance. */
const mostGaps = 400;

/** `joints`: the values of those that move by themselves, in their order; null: as kept. */
export function posed(study: Study, at: number, joints: number[] | null, picked: number | null): Posed {
  const kept = study.kept[at]!;
  const free = freeJoints(study.links);
  const named = joints
    ? Object.fromEntries(free.map((link, i) => [study.links[link]!.joint!, joints[i]!]))
    : kept.joints;
  const values = jointValues(study.links, named);
  if (!joints)
    return {
      ...kept,
      set: false,
      values,
      gaps: kept.pairs,
      within: kept.pairs.map(({ within }) => within),
    };
  const { cylinders, boxes } = placed(study.links, study.bodies, values);
  const pairs = study.pairs.map(({ bodies }) => bodies);
  const gaps = gapsOf(cylinders, pairs, study.clearance, mostGaps);
  if (picked !== null) gaps[picked] ??= gap(cylinders[pairs[picked]![0]]!, cylinders[pairs[picked]![1]]!);
  return {
    cylinders,
    boxes,
    set: true,
    joints: named,
    values,
    gaps,
    within: gaps.map((found) => found !== null && found.distance <= study.clearance),
  };
}

/** Pairs by their gap, the nearest first; those that were computed. */
export const nearestFirst = ({ gaps }: Posed): number[] =>
  gaps
    .flatMap((found, i) => (found ? [i] : []))
    .sort((i, j) => gaps[i]!.distance - gaps[j]!.distance);
