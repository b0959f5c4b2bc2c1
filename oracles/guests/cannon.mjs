// SPDX-License-Identifier: MIT
// cannon-es: a test of separating axes of two prisms, which lie inside the cylinders.
import { readFileSync } from 'node:fs';
import { Cylinder, Quaternion, Vec3 } from 'cannon-es';
import { serve } from './lines.mjs';

const { version } = JSON.parse(readFileSync(new URL('node_modules/cannon-es/package.json', import.meta.url)));
const sides = 8; // numSegments of its constructor

const placed = ({ radius, halfHeight, position: p, turn: t }) => [
  new Cylinder(radius, radius, 2 * halfHeight, sides), new Vec3(p.x, p.y, p.z), new Quaternion(t.x, t.y, t.z, t.w)];

const claim = { relative: 1e-6, absolute: 1e-6, source: 'cannon-es.js, Vec3.almostZero: an axis shorter than 1e-6 is passed over' };
serve({ name: 'cannon', version, claim, takes: ['cylinder'] }, (a, b) => {
  const [one, at, turn] = placed(a), [other, ...there] = placed(b), axis = new Vec3();
  const meet = one.findSeparatingAxis(other, at, turn, ...there, axis);
  return { verdict: meet ? 'intersecting' : 'disjoint' };
});
