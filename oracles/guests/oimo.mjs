// SPDX-License-Identifier: MIT
// OimoPhysics: the distance of its GJK and EPA, which is of cores, less the margins around them.
import { readFileSync } from 'node:fs';
import { serve } from './lines.mjs';

const folder = new URL('node_modules/oimophysics/', import.meta.url);
// Its file is a module, but its package does not state it: Node.js 18 would read it as CommonJS.
const source = readFileSync(new URL('OimoPhysics.js', folder));
const { oimo } = await import(`data:text/javascript;base64,${source.toString('base64')}`);
const { geometry, narrowphase } = oimo.collision, { Quat, Transform, Vec3 } = oimo.common;
const gjk = new narrowphase.detector.gjkepa.GjkEpa();

const shapes = {
  sphere: (s) => new geometry.SphereGeometry(s.rounding),
  capsule: (s) => new geometry.CapsuleGeometry(s.rounding, s.halfHeight),
  cylinder: (s) => new geometry.CylinderGeometry(s.radius, s.halfHeight),
  box: (s) => new geometry.BoxGeometry(new Vec3(...s.half)),
};

function placed(s) {
  const { position: p, turn: t } = s, at = new Transform();
  at.setPosition(new Vec3(p.x, p.y, p.z));
  at.setOrientation(new Quat(t.x, t.y, t.z, t.w));
  return [shapes[s.kind](s), at];
}

const rounded_rims = oimo.common.Setting.defaultGJKMargin; // inside the solid; less for a thin box
const claim = { relative: 1e-6, absolute: 1e-4, source: 'none made; assumed: 1e-4 of a length of 1. Its EPA ends after 40 steps' };
serve({ npm: 'oimophysics', call: 'GjkEpa.computeClosestPoints', claim, shapes, rounded_rims }, (a, b) => {
  const [one, at] = placed(a), [other, there] = placed(b);
  const status = gjk.computeClosestPoints(one, other, at, there, null);
  if (status !== 0) return { error: `GjkEpaResultState ${status}` };
  const distance = gjk.distance - one.getGjkMergin() - other.getGjkMergin();
  return { verdict: distance <= 0 ? 'intersecting' : 'disjoint', distance };
});
