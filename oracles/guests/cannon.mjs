// SPDX-License-Identifier: MIT
// cannon-es: a test of separating axes of two polyhedra. The prisms lie inside the cylinders.
import { Box, Cylinder, Narrowphase, Plane, Quaternion, Vec3 } from 'cannon-es';
import { serve } from './lines.mjs';

const sides = 8; // numSegments of its constructor

const toY = new Quaternion(-Math.SQRT1_2, 0, 0, Math.SQRT1_2); // from z, the normal of its planes

const shapes = {
  cylinder: ({ radius, halfHeight }) => new Cylinder(radius, radius, 2 * halfHeight, sides),
  half_space: () => new Plane(),
  box: ({ half }) => new Box(new Vec3(...half)).convexPolyhedronRepresentation,
};
const placed = (s) => {
  const { position: p, turn: t } = s;
  return [shapes[s.kind](s), new Vec3(p.x, p.y, p.z), new Quaternion(t.x, t.y, t.z, t.w)];
};

const claim = { relative: 1e-6, absolute: 1e-6, source: 'cannon-es.js, Vec3.almostZero: an axis shorter than 1e-6 is passed over' };
serve({ npm: 'cannon-es', call: 'ConvexPolyhedron.findSeparatingAxis', claim, shapes }, (a, b) => {
  if (b.kind === 'half_space') [a, b] = [b, a];
  const [one, at, turn] = placed(a), [other, ...there] = placed(b), axis = new Vec3();
  const meet = a.kind === 'half_space'
    ? Narrowphase.prototype.planeConvex(one, other, at, there[0], turn.mult(toY), there[1], null, null, null, null, true)
    : one.findSeparatingAxis(other, at, turn, ...there, axis);
  return { verdict: meet ? 'intersecting' : 'disjoint' };
});
