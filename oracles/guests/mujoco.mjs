// SPDX-License-Identifier: MIT
// MuJoCo's mj_geomDistance. With --contacts: whether mj_forward makes a contact. With --libccd: the same, by its older
// algorithm for convex solids. Each pair is compiled as its own model, because a changed geom keeps its old bounds.
import { writeFileSync } from 'node:fs';
import load from '@mujoco/mujoco';
import { serve } from './lines.mjs';

const MuJoCo = await load(), option = ['contacts', 'libccd'].find((word) => process.argv.includes(`--${word}`));

const lengths = {
  sphere: (s) => [s.rounding],
  capsule: (s) => [s.rounding, s.halfHeight],
  cylinder: (s) => [s.radius, s.halfHeight],
  half_space: () => [0, 0, 1], // without end
  box: (s) => s.half,
};
const quarter = Math.SQRT1_2; // from its z to y, but not for boxes
const turnOf = ({ half, turn: t }) => half
  ? [t.w, t.x, t.y, t.z]
  : [(t.w + t.x) * quarter, (t.x - t.w) * quarter, (t.y - t.z) * quarter, (t.z + t.y) * quarter];
const shown = (numbers) => numbers.map((x) => (Math.abs(x) < 1e-300 ? 0 : x)).join(' '); // no denormal numbers
const posed = (s) => `pos="${shown(Object.values(s.position))}" quat="${shown(turnOf(s))}"`;
const geom = (s) => `geom type="${s.kind.replace('half_space', 'plane')}" size="${lengths[s.kind](s).join(' ')}"`;
const beyond = 1e10; // all distances of pairs that lines.mjs accepts

const name = option ? `mujoco3-${option}` : 'mujoco3';
const claim = { relative: 1e-12, absolute: 1e-6, source: 'ccd_tolerance: tolerance of the convex collision algorithm' };
const call = option ? 'mj_forward' : 'mj_geomDistance';
serve({ name, npm: '@mujoco/mujoco', call, claim, shapes: lengths, sizes: { zero: false } }, (a, b) => {
  if (b.kind === 'half_space') [a, b] = [b, a];
  // The second moves, since solids that are fixed to the world make no contact.
  const mjcf = `<mujoco>
  <option><flag nativeccd="${option === 'libccd' ? 'disable' : 'enable'}"/></option>
  <worldbody>
    <${geom(a)} ${posed(a)}/>
    <body ${posed(b)}><freejoint/><inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/><${geom(b)}/></body>
  </worldbody></mujoco>\n`;
  MuJoCo.FS.writeFile('/pair.xml', mjcf);
  if (process.env.DAYLIGHT_MODEL) writeFileSync(process.env.DAYLIGHT_MODEL, mjcf); // for MuJoCo's issue tracker
  const model = MuJoCo.MjModel.mj_loadXML('/pair.xml'), data = new MuJoCo.MjData(model);
  try {
    MuJoCo.mj_forward(model, data);
    if (option) return { verdict: data.ncon > 0 ? 'intersecting' : 'disjoint' };
    const distance = MuJoCo.mj_geomDistance(model, data, 0, 1, beyond, new Float64Array(6));
    return { verdict: distance <= 0 ? 'intersecting' : 'disjoint', distance };
  } finally {
    data.delete();
    model.delete();
  }
});
