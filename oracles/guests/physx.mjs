// SPDX-License-Identifier: MIT
// PhysX's overlap of two solids, and the separation that its GJK finds. Cylinders and rounded boxes are convex cores.
import { readFileSync } from 'node:fs';
import { serve } from './lines.mjs';

// The package is built for browsers, and looks for them while it loads.
const node = globalThis.process;
const wasmBinary = readFileSync(new URL('node_modules/physx-js-webidl/physx-js-webidl.wasm', import.meta.url));
globalThis.window = globalThis;
globalThis.process = undefined;
const PhysX = await (await import('physx-js-webidl')).default({ wasmBinary });
globalThis.process = node;

const query = PhysX.PxGeometryQuery.prototype, factory = PhysX.PxConvexCoreGeometryFactory.prototype;

function cylinder(s) {
  const core = new PhysX.PxConvexCoreCylinder(2 * s.halfHeight, s.radius);
  const geometry = factory.createFromCylinder(core, s.rounding);
  PhysX.destroy(core);
  return geometry;
}

function rounded_box(s) {
  const core = new PhysX.PxConvexCoreBox(...s.half.map((half) => 2 * half));
  const geometry = factory.createFromBox(core, s.rounding);
  PhysX.destroy(core);
  return geometry;
}

const shapes = {
  sphere: (s) => new PhysX.PxSphereGeometry(s.rounding),
  capsule: (s) => new PhysX.PxCapsuleGeometry(s.rounding, s.halfHeight),
  cylinder,
  rounded: cylinder,
  half_space: () => new PhysX.PxPlaneGeometry(),
  box: (s) => new PhysX.PxBoxGeometry(...s.half),
  rounded_box,
};

const quarter = Math.SQRT1_2; // from its x to y, but not for boxes
const turnOf = ({ half, turn: t }) => half
  ? [t.x, t.y, t.z, t.w]
  : [(t.x + t.y) * quarter, (t.y - t.x) * quarter, (t.z + t.w) * quarter, (t.w - t.z) * quarter];

function placed(s) {
  const { position: p } = s;
  const at = new PhysX.PxVec3(p.x, p.y, p.z);
  const turn = new PhysX.PxQuat(...turnOf(s));
  const pose = new PhysX.PxTransform(at, turn), geometry = shapes[s.kind](s);
  return { geometry, pose, end: () => [geometry, pose, turn, at].forEach((gone) => PhysX.destroy(gone)) };
}

// isValid() of its geometries asks for a volume, hence `zero`.
const claim = { relative: 1e-6, absolute: 1e-3, source: 'none made; assumed: 1e-3 of the length scale 1' };
serve({ npm: 'physx-js-webidl', call: 'PxGeometryQuery.overlap', claim, shapes, sizes: { zero: false } }, (a, b) => {
  const [one, other] = [placed(a), placed(b)];
  const meet = query.overlap(one.geometry, one.pose, other.geometry, other.pose);
  for (const gone of [one, other]) gone.end();
  return { verdict: meet ? 'intersecting' : 'disjoint' };
});
