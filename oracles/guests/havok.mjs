// SPDX-License-Identifier: MIT
// Havok's proximity of a shape and a body that is the other solid: a signed distance.
import { readFileSync } from 'node:fs';
import initHavok from '@babylonjs/havok';
import { serve } from './lines.mjs';

const folder = new URL('node_modules/@babylonjs/havok/', import.meta.url);
const Havok = await initHavok({ wasmBinary: readFileSync(new URL('lib/esm/HavokPhysics.wasm', folder)) });

/** Returns the value that comes with the result code of a call. Throws if the code is not that of success. */
function must([result, ...values]) {
  if (result !== Havok.Result.RESULT_OK) throw new Error(`result ${result.value}`);
  return values[0];
}

const world = must(Havok.HP_World_Create()), body = must(Havok.HP_Body_Create());
const found = must(Havok.HP_QueryCollector_Create(1));
Havok.HP_Body_SetMotionType(body, Havok.MotionType.STATIC);

const shapes = {
  sphere: (s) => Havok.HP_Shape_CreateSphere([0, 0, 0], s.rounding),
  capsule: (s) => Havok.HP_Shape_CreateCapsule([0, -s.halfHeight, 0], [0, s.halfHeight, 0], s.rounding),
  cylinder: (s) => Havok.HP_Shape_CreateCylinder([0, -s.halfHeight, 0], [0, s.halfHeight, 0], s.radius),
  box: (s) => Havok.HP_Shape_CreateBox([0, 0, 0], [0, 0, 0, 1], s.half.map((half) => 2 * half)),
};
const place = ({ position: p, turn: t }) => [[p.x, p.y, p.z], [t.x, t.y, t.z, t.w]];
const reach = (s) => s.lengths.reduce((sum, x) => sum + x, 0);

// It turns a cylinder into a prism of 16 sides inside it. As small spheres show, the edges of boxes are rounded by 0.015, and
// rims by at most as much.
const rounded_rims = 0.015;
const claim = { relative: 1e-6, absolute: 1e-3, source: 'none made; assumed: 1e-3 of a length of 1' };
serve({ npm: '@babylonjs/havok', call: 'HP_World_ShapeProximityWithCollector', claim, shapes, rounded_rims }, (a, b) => {
  const made = [a, b].map((s) => shapes[s.kind](s));
  if (made.some(([result]) => result !== Havok.Result.RESULT_OK)) return { declined: 'it makes no such shape' };
  const [one, other] = made.map(must);
  Havok.HP_Body_SetShape(body, other);
  Havok.HP_Body_SetQTransform(body, place(b));
  Havok.HP_World_AddBody(world, body, false); // anew: a body that only changes keeps its old bounds
  const far = Math.hypot(b.position.x, b.position.y, b.position.z) + reach(a) + reach(b);
  Havok.HP_World_ShapeProximityWithCollector(world, found, [one, ...place(a), far, false, [0n]]);
  const hits = must(Havok.HP_QueryCollector_GetNumHits(found));
  const distance = hits > 0 ? must(Havok.HP_QueryCollector_GetShapeProximityResult(found, 0))[0] : undefined;
  Havok.HP_World_RemoveBody(world, body);
  for (const shape of [one, other]) Havok.HP_Shape_Release(shape);
  if (distance === undefined) return { declined: 'no hit within any distance' };
  return { verdict: distance <= 0 ? 'intersecting' : 'disjoint', distance };
});
