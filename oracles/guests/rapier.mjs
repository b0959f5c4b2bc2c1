// SPDX-License-Identifier: MIT
// Rapier's (parry's) test of two solids.
import RAPIER from '@dimforge/rapier3d-compat';
import { serve } from './lines.mjs';

await RAPIER.init();
const claim = { relative: 1e-6, absolute: 1.2e-6, source: 'parry gjk eps_tol(): 10 units of the last place of 1 in single precision' };
const shapes = {
  sphere: (s) => new RAPIER.Ball(s.rounding),
  capsule: (s) => new RAPIER.Capsule(s.halfHeight, s.rounding),
  cylinder: (s) => new RAPIER.Cylinder(s.halfHeight, s.radius),
  half_space: () => new RAPIER.HalfSpace({ x: 0, y: 1, z: 0 }),
  box: (s) => new RAPIER.Cuboid(...s.half),
  rounded_box: (s) => new RAPIER.RoundCuboid(...s.half, s.rounding),
  rounded: (s) => new RAPIER.RoundCylinder(s.halfHeight, s.radius, s.rounding),
};
serve({ npm: '@dimforge/rapier3d-compat', call: 'Shape.intersectsShape', claim, shapes }, (a, b) => {
  const [first, second] = [a, b].map((s) => shapes[s.kind](s));
  const meet = first.intersectsShape(a.position, a.turn, second, b.position, b.turn);
  return { verdict: meet ? 'intersecting' : 'disjoint' };
});
