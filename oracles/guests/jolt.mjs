// SPDX-License-Identifier: MIT
// Jolt's CollideShape of two solids with sharp edges.
import initJolt from 'jolt-physics';
import { serve } from './lines.mjs';

const Jolt = await initJolt();
const engine = new Jolt.JoltInterface(engineSettings()); // registers the shapes
const plane = new Jolt.Plane(new Jolt.Vec3(0, 1, 0), 0), scale = new Jolt.Vec3(1, 1, 1), origin = new Jolt.RVec3(0, 0, 0);
const half = new Jolt.Vec3(0, 0, 0), settings = new Jolt.CollideShapeSettings(), filter = new Jolt.ShapeFilter();

function engineSettings() {
  const settings = new Jolt.JoltSettings();
  settings.mObjectLayerPairFilter = new Jolt.ObjectLayerPairFilterTable(1);
  const layers = new Jolt.BroadPhaseLayerInterfaceTable(1, 1);
  layers.MapObjectToBroadPhaseLayer(0, new Jolt.BroadPhaseLayer(0));
  settings.mBroadPhaseLayerInterface = layers;
  settings.mObjectVsBroadPhaseLayerFilter =
    new Jolt.ObjectVsBroadPhaseLayerFilterTable(layers, 1, settings.mObjectLayerPairFilter, 1);
  return settings;
}

// A convex radius rounds only what its GJK sees; its penetration depth takes the sharp solid. So it is 0.
const shapes = {
  sphere: (s) => new Jolt.SphereShape(s.rounding),
  capsule: (s) => new Jolt.CapsuleShape(s.halfHeight, s.rounding),
  cylinder: (s) => new Jolt.CylinderShape(s.halfHeight, s.radius, 0),
  half_space: () => new Jolt.PlaneShape(plane),
  box: (s) => {
    half.Set(...s.half);
    return new Jolt.BoxShape(half, 0);
  },
};

function placed(s) {
  const { position, turn } = s;
  const shape = shapes[s.kind](s);
  shape.AddRef();
  const at = new Jolt.RVec3(position.x, position.y, position.z), rotation = new Jolt.Quat(turn.x, turn.y, turn.z, turn.w);
  const solid = new Jolt.TransformedShape();
  solid.mShape = shape;
  solid.SetWorldTransform(at, rotation, scale);
  return { shape, solid, end: () => { Jolt.destroy(solid); Jolt.destroy(at); Jolt.destroy(rotation); shape.Release(); } };
}

const claim = { relative: 1e-6, absolute: 1e-4, source: 'PhysicsSettings.h: closer than 1e-4 m is considered to be colliding' };
serve({ npm: 'jolt-physics', call: 'TransformedShape.CollideShape', claim, shapes }, (a, b) => {
  const one = placed(a), other = placed(b), hit = new Jolt.CollideShapeAnyHitCollisionCollector();
  one.solid.CollideShape(other.shape, scale, other.solid.GetCenterOfMassTransform(), settings, origin, hit, filter);
  const meet = hit.HadHit();
  for (const gone of [one, other]) gone.end();
  Jolt.destroy(hit);
  return { verdict: meet ? 'intersecting' : 'disjoint' };
});
