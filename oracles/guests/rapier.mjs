// SPDX-License-Identifier: MIT
// Rapier's (parry's) test of two cylinders.
import RAPIER from '@dimforge/rapier3d-compat';
import { serve } from './lines.mjs';

await RAPIER.init();
const claim = { relative: 1e-6, absolute: 1.2e-6, source: 'parry gjk eps_tol(): 10 units of the last place of 1 in single precision' };
serve({ name: 'rapier', version: RAPIER.version(), claim }, (a, b) => {
  const [first, second] = [a, b].map((s) => new RAPIER.Cylinder(s.halfHeight, s.radius));
  const meet = first.intersectsShape(a.position, a.turn, second, b.position, b.turn);
  return { verdict: meet ? 'intersecting' : 'disjoint' };
});
