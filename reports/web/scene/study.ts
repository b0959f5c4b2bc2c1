// SPDX-License-Identifier: MIT
// What the page of a scene is given: what `daylight scene --json` writes (reports/scene/scene_json.cpp, described by
// reports/schemas/scene.json), as far as the page uses it.
import type { Cylinder, Vec } from "../parts/data.ts";
import { add, dot, scale, sub, unit, type Capsule, type Solid } from "../parts/geometry.ts";
import { capital, short } from "../parts/words.ts";
import type { PlacedBox, StudiedBody, StudiedLink } from "./kinematics.ts";

/** Cheapest first; each but "inner capsule" may be the one that a pair needs. */
export const models = ["sphere", "outer capsule", "inner capsule", "cylinder", "distance", "certified"] as const;
export type Model = (typeof models)[number];
export const modelColour: Record<Model, string> = {
  sphere: "--model-sphere",
  "outer capsule": "--model-outer",
  "inner capsule": "--model-inner",
  cylinder: "--model-cylinder",
  distance: "--model-distance",
  certified: "--model-certified",
};

interface ModelOfPair {
  model: Model;
  decides: number;
  wrong: number;
  false_alarm: number;
  missed: number;
}
export interface StudiedPair {
  a: string;
  b: string;
  bodies: [number, number];
  samples: number;
  known: boolean; // not, where a solid that only holds a box or mesh came within the clearance
  within: number;
  within_rate: [number, number];
  least_distance: number;
  greatest_distance: number;
  models: ModelOfPair[];
  needs: Model; // the simplest that alone answers every sample right
  recommended: Model[]; // the cheapest: asked one after the other; the last is accepted
  recommended_wrong: number;
}
interface Reason {
  why: "drawn first" | "closest call" | "false alarm" | "missed";
  pair?: number;
  model?: Model;
  length?: number;
}
interface SampledPair {
  distance: number;
  within: boolean;
  wrong: Model[];
  on_a: Vec;
  on_b: Vec;
}
export interface Shown {
  configuration: number;
  reasons: Reason[];
  joints: Record<string, number>;
  cylinders: Cylinder[];
  boxes: PlacedBox[];
  pairs: SampledPair[];
}
/** What is proved of two bodies over all motions. */
export interface Proof {
  a: string;
  b: string;
  bodies: [number, number];
  verdict: "refuted" | "within" | "open" | "never";
  bound: number; // above 0: they stay farther apart than this
  least_seen: number;
  joints: Record<string, number>; // where that was
  boxes: number;
  open_share: number;
}
/** What the SRDF says of two links, and whether it is so. */
export interface ProvedExemption {
  link1: string;
  link2: string;
  verdict: Proof["verdict"];
  not_looked_at: boolean;
  pairs: Proof[];
}

export interface Study {
  file: string;
  seed: string;
  clearance: number;
  tolerated: number;
  configurations: number;
  cylinders: number;
  left_out: string[];
  notes: string[];
  asked_referee: number;
  undecided: number;
  ns_per_configuration: {
    kinematics: number;
    models: number;
    recommended: number;
    alone: Record<Model, number>;
  };
  words: Record<
    | "counts"
    | "pairs"
    | "configurations"
    | "enough"
    | "recommended"
    | "cost"
    | "forgiven"
    | "capsules"
    | "closest"
    | "verified"
    | "motions",
    string
  > & { left_out: string[]; remarks: string[]; rounding: string[] };
  models: {
    model: Model;
    decides: number;
    suffices: number;
    wrong: number;
    wrong_pairs: number;
    false_alarm: number;
    missed: number;
  }[];
  links: StudiedLink[];
  bodies: StudiedBody[];
  pairs: StudiedPair[];
  kept: Shown[];
  motions?: Proof[]; // with --prove
  exemptions?: ProvedExemption[];
  srdf?: string;
}

export const rank = (model: Model) => models.indexOf(model);

/** The most exact model that a pair of each body needs; null where none is checked. */
export function mostExact(study: Study): (Model | null)[] {
  const of = study.bodies.map((): Model | null => null);
  for (const pair of study.pairs)
    for (const body of pair.bodies) if (of[body] === null || rank(of[body]!) < rank(pair.needs)) of[body] = pair.needs;
  return of;
}

// The solids, in a frame for drawing that is the same for all configurations that were kept
// ---------------------------------------------------------------------------------------

export interface SceneFrame {
  unit: number;
  to: (x: Vec) => Vec;
  solid: (c: Cylinder) => Solid;
  floor: number; // the lowest point of all, as drawn
}

/** How low a configuration reaches: of a solid that stands in for a box, the box. */
function lowest({ cylinders, boxes }: Shown, { bodies }: Study): number {
  const ofSolid = (c: Cylinder) => {
    const up = unit(c.axis)[2];
    const half = c.radius * Math.sqrt(Math.max(0, 1 - up * up)) + (c.height / 2) * Math.abs(up);
    return c.center[2] - half - (c.rounding ?? 0);
  };
  const ofBox = ({ body, center, axes }: PlacedBox) =>
    center[2] - axes.reduce((sum, axis, k) => sum + (Math.abs(axis[2]) * bodies[body]!.holds!.size[k]!) / 2, 0);
  const own = cylinders.flatMap((c, i) => (bodies[i]!.holds ? [] : [ofSolid(c)]));
  return Math.min(...own, ...boxes.map(ofBox));
}

export function frameOf(study: Study): SceneFrame {
  const low: Vec = [Infinity, Infinity, Infinity],
    high: Vec = [-Infinity, -Infinity, -Infinity];
  for (const c of study.kept.flatMap(({ cylinders }) => cylinders)) {
    const reach = Math.hypot(c.radius, c.height / 2) + (c.rounding ?? 0);
    for (const i of [0, 1, 2] as const) {
      low[i] = Math.min(low[i], c.center[i] - reach);
      high[i] = Math.max(high[i], c.center[i] + reach);
    }
  }
  const middle = scale(add(low, high), 0.5),
    wide = Math.hypot(...sub(high, low)) / 2,
    unitLength = wide > 0 && Number.isFinite(wide) ? wide : 1;
  const to = (x: Vec) => scale(sub(x, middle), 1 / unitLength);
  const floor = Math.min(...study.kept.map((kept) => lowest(kept, study)));
  return {
    unit: unitLength,
    to,
    floor: to([0, 0, floor])[2],
    solid: (c) => ({
      center: to(c.center),
      axis: unit(c.axis),
      radius: c.radius / unitLength,
      half: c.height / 2 / unitLength,
      rounding: (c.rounding ?? 0) / unitLength,
    }),
  };
}

/** The model that stands for a cylinder, where it is a solid of its own (scenes/near/model_hierarchy.cpp). */
export function standIn(s: Solid, model: Model): Capsule | null {
  const { center, axis } = s;
  switch (model) {
    case "sphere":
      return { center, axis, half: 0, radius: Math.hypot(s.radius, s.half) + s.rounding };
    case "outer capsule":
      return { center, axis, half: s.half, radius: s.radius + s.rounding };
    case "inner capsule": {
      const radius = Math.min(s.radius, s.half);
      return { center, axis, half: s.half - radius, radius: radius + s.rounding };
    }
    default:
      return null;
  }
}
export const hasStandIn = (model: Model) => rank(model) < 3;

/** The middle of a box around the balls around all. */
export function middleOf(solids: Solid[]): Vec {
  const ball = (s: Solid) => Math.hypot(s.radius, s.half) + s.rounding;
  const ends = (i: 0 | 1 | 2) => solids.flatMap((s) => [s.center[i] - ball(s), s.center[i] + ball(s)]);
  return ([0, 1, 2] as const).map((i) => (Math.min(...ends(i)) + Math.max(...ends(i))) / 2) as Vec;
}

/** The radius of a ball around a point that holds all. */
export const extentOf = (solids: Solid[], from: Vec = [0, 0, 0]) =>
  Math.max(
    1e-3,
    ...solids.map((s) => {
      const way = sub(s.center, from);
      return Math.sqrt(dot(way, way)) + Math.hypot(s.radius, s.half) + s.rounding;
    }),
  );

// Words
// -----

export const aModel = (model: Model) =>
  model === "certified"
    ? "a proof"
    : model === "distance"
      ? "the distance"
      : `${/^[aeiou]/.test(model) ? "an" : "a"} ${model}`;
/** A text of `daylight scene` as a sentence of the page. */
export const asSentence = (text: string) =>
  capital(text.replace(/(\d) us\b/g, "$1 \u00b5s").replaceAll(" - ", " \u2013 "));

/** Some formats are in metres; other formats do not state their unit. */
export const unitOf = (study: Study) => (/\.(urdf|xacro|xml|mjcf)$/i.test(study.file) ? "m" : "");
/** A length with its unit, where that is known. */
export const formatLength = (x: number, unit: string) =>
  (unit && Number.isFinite(x) ? `${short(x)} ${unit}` : short(x));

export function formatGap(distance: number, clearance: number, unit = ""): string {
  if (distance < 0) return `overlap by ${formatLength(-distance, unit)}`;
  return distance === 0
    ? "touch"
    : `are ${formatLength(distance, unit)} apart` +
        (clearance > 0 ? ` (clearance ${formatLength(clearance, unit)})` : "");
}

/** Whether a pair is measured from a solid that only holds a box or mesh. */
export const standsIn = (study: Study, pair: number) =>
  study.pairs[pair]!.bodies.some((body) => study.bodies[body]!.holds !== undefined);

const pairName = (study: Study, pair: number) => `${study.pairs[pair]!.a} \u2013 ${study.pairs[pair]!.b}`;

export function formatReason(study: Study, kept: Shown, reason: Reason): string {
  const of = reason.pair === undefined ? "" : `: ${pairName(study, reason.pair)}`;
  const length = short(Math.abs(reason.length ?? 0));
  switch (reason.why) {
    case "drawn first":
      return study.configurations === 1 ? "the only configuration" : `configuration ${kept.configuration}, as sampled`;
    case "closest call":
      return `closest call${of}, ${length} ${reason.length! > 0 ? "beyond" : "below"} the clearance`;
    case "false alarm":
      return `worst false alarm of the ${reason.model}${of}, ${length} beyond the clearance`;
    case "missed":
      return `largest miss of the ${reason.model}${of}, ${length} below the clearance`;
  }
}
