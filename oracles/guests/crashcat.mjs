// SPDX-License-Identifier: MIT
// crashcat's collideShapeVsShape of two solids, with its default settings. Cylinders and boxes are made with sharp edges.
// Its boxes have rounded edges only for its GJK.
import * as crashcat from 'crashcat';
import { serve } from './lines.mjs';

const { box, capsule, collideShapeVsShape, createAnyCollideShapeCollector, createDefaultCollideShapeSettings, cylinder, plane, sphere } = crashcat;
crashcat.registerAllShapes();
const settings = createDefaultCollideShapeSettings(), found = createAnyCollideShapeCollector();

const shapes = {
  sphere: (s) => sphere.create({ radius: s.rounding }),
  capsule: (s) => capsule.create({ halfHeightOfCylinder: s.halfHeight, radius: s.rounding }),
  cylinder: (s) => cylinder.create({ halfHeight: s.halfHeight, radius: s.radius, convexRadius: 0 }),
  half_space: () => plane.create({ plane: { normal: [0, 1, 0], constant: 0 } }),
  box: (s) => box.create({ halfExtents: s.half, convexRadius: 0 }),
  rounded: (s) => cylinder.create({ halfHeight: s.halfHeight + s.rounding, radius: s.radius + s.rounding, convexRadius: s.rounding }),
};
const operand = (s) => {
  const { position: p, turn: t } = s;
  return [shapes[s.kind](s), 0, 0, p.x, p.y, p.z, t.x, t.y, t.z, t.w, 1, 1, 1];
};

const claim = { relative: 1e-6, absolute: settings.collisionTolerance, source: 'collisionTolerance of its default settings: closer is considered to be colliding' };
serve({ npm: 'crashcat', call: 'collideShapeVsShape', claim, shapes }, (a, b) => {
  const kinds = [a.kind, b.kind];
  if (kinds.includes('half_space') && kinds.includes('rounded')) return { declined: 'its planes see sharp cylinders' };
  found.reset();
  collideShapeVsShape(found, settings, ...operand(a), ...operand(b));
  return { verdict: found.hit ? 'intersecting' : 'disjoint' };
});
