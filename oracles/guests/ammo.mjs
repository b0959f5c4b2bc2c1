// SPDX-License-Identifier: MIT
// ammo.js (Bullet in single precision): contactPairTest of two objects, and the least distance of its contacts.
import Ammo from 'ammo.js';
import { serve } from './lines.mjs';

const Bullet = typeof Ammo === 'function' ? await Ammo() : Ammo;
const configuration = new Bullet.btDefaultCollisionConfiguration(), dispatcher = new Bullet.btCollisionDispatcher(configuration);
const world = new Bullet.btDiscreteDynamicsWorld(
  dispatcher, new Bullet.btDbvtBroadphase(), new Bullet.btSequentialImpulseConstraintSolver(), configuration);
const up = new Bullet.btVector3(0, 1, 0);
let least;
const heard = new Bullet.ConcreteContactResultCallback();
heard.addSingleResult = (point) => {
  least = Math.min(least, Bullet.wrapPointer(point, Bullet.btManifoldPoint).getDistance());
  return 0;
};

function made(Shape, ...half) {
  const vector = new Bullet.btVector3(...half), shape = new Shape(vector);
  Bullet.destroy(vector);
  return shape;
}
const shapes = {
  sphere: (s) => new Bullet.btSphereShape(s.rounding),
  capsule: (s) => new Bullet.btCapsuleShape(s.rounding, 2 * s.halfHeight),
  cylinder: (s) => made(Bullet.btCylinderShape, s.radius, s.halfHeight, s.radius),
  box: (s) => made(Bullet.btBoxShape, ...s.half),
  half_space: () => new Bullet.btStaticPlaneShape(up, 0),
};

function placed(s) {
  const { position: p, turn: t } = s, object = new Bullet.btPairCachingGhostObject(), shape = shapes[s.kind](s);
  const at = new Bullet.btVector3(p.x, p.y, p.z), turn = new Bullet.btQuaternion(t.x, t.y, t.z, t.w);
  const pose = new Bullet.btTransform(turn, at);
  object.setCollisionShape(shape);
  object.setWorldTransform(pose);
  return { object, end: () => [object, shape, pose, at, turn].forEach((gone) => Bullet.destroy(gone)) };
}

const rounded_rims = 0.04; // at most: CONVEX_DISTANCE_MARGIN
const claim = { relative: 1e-6, absolute: 1e-3, source: 'none made; assumed: 1e-3 of a length of 1' };
serve({ npm: 'ammo.js', call: 'btCollisionWorld.contactPairTest', claim, shapes, rounded_rims }, (a, b) => {
  const one = placed(a), other = placed(b);
  least = Infinity;
  world.contactPairTest(one.object, other.object, heard);
  for (const gone of [one, other]) gone.end();
  return { verdict: least <= 0 ? 'intersecting' : 'disjoint' };
});
