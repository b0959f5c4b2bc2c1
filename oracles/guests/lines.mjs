// SPDX-License-Identifier: MIT
// The guests in Node share this: a hello, then an answer line for each line of a pair. Most engines use single
// precision and keep a cylinder along y. So positions count from the centre of a bounded solid before they are rounded.
import { readFileSync } from 'node:fs';
import { createInterface } from 'node:readline';

/** The vector in a length that has squares, upside down if y is negative. */
const upright = (axis) => axis.map((c) => c / (Math.max(...axis.map(Math.abs)) * (axis[1] < 0 ? -1 : 1)));

/** The unit quaternion that turns y to the line of `axis`, by the half-way vector. A cylinder looks the same upside down. */
function turnFromY(axis) {
  const [x, y, z] = upright(axis);
  const length = Math.hypot(x, y, z), n = Math.hypot(x, y + length, z);
  return { x: z / n, y: 0, z: -x / n, w: (y + length) / n };
}

/** Its plane is y = 0 before the turn, and contains the point of it that is nearest to the origin. */
function halfSpaceOf({ point, normal }, origin) {
  const line = upright(normal), length = Math.hypot(...line), { x, z, w } = turnFromY(normal);
  const away = point.map((c, i) => c - origin[i]);
  const offset = line.reduce((sum, c, i) => sum + (c / length) * away[i], 0);
  const [px, py, pz] = line.map((c) => (c / length) * offset);
  const turn = normal[1] < 0 ? { x: w, y: z, z: 0, w: -x } : { x, y: 0, z, w }; // half a turn about x first
  return { kind: 'half_space', lengths: [], position: { x: px, y: py, z: pz }, turn, away: Math.hypot(...away) };
}

/** The unit quaternion of any quaternion but 0. */
function unit(quaternion) {
  const [w, x, y, z] = quaternion.map((c) => c / Math.max(...quaternion.map(Math.abs)));
  const n = Math.hypot(w, x, y, z);
  return { x: x / n, y: y / n, z: z / n, w: w / n };
}

/** `lengths` has all of its lengths. */
function solidOf(solid, origin) {
  if (solid.shape === 'half_space') return halfSpaceOf(solid, origin);
  const [x, y, z] = solid.center.map((c, i) => c - origin[i]);
  const { height, radius, rounding = 0, quaternion = [1, 0, 0, 0] } = solid;
  const position = { x, y, z };
  if (solid.shape === 'box') {
    const half = solid.edges.map((edge) => edge / 2), kind = rounding === 0 ? 'box' : 'rounded_box';
    return { kind, half, rounding, lengths: [...half, rounding], position, turn: unit(quaternion) };
  }
  const halfHeight = height / 2, lengths = [halfHeight, radius, rounding];
  const kind = rounding === 0 ? 'cylinder' : radius > 0 ? 'rounded' : height > 0 ? 'capsule' : 'sphere';
  return { kind, halfHeight, radius, rounding, lengths, position, turn: turnFromY(solid.axis) };
}

/** Lengths whose fourth powers single precision holds. */
const least = 1e-9, most = 1e9;
/** A point of a half-space this far off leaves the rounding errors of its plane below the claims. */
const farthest = 1e6;

function fits({ lengths, position, away = 0 }) {
  return away <= farthest && lengths.every((x) => x === 0 || (x >= least && x <= most)) &&
    Object.values(position).every((x) => Math.abs(x) <= most);
}

/** `answer` takes two solids and gives an answer line as an object. `npm` names the package that it asks. The keys of
    `shapes` are the kinds that it takes. */
export function serve({ npm, shapes, ...hello }, answer) {
  const { version } = JSON.parse(readFileSync(new URL(`node_modules/${npm}/package.json`, import.meta.url)));
  // Answers to lines that arrive together leave together: a write for each line would take longer than the answer.
  let said = '';
  const flush = () => { process.stdout.write(said); said = ''; };
  const say = (object) => {
    if (said === '') setImmediate(flush);
    said += JSON.stringify(object) + '\n';
  };
  const install = `npm install --prefix . ${npm}@${version}`;
  say({ ...hello, version, takes: Object.keys(shapes), install, files: ['lines.mjs'] });
  createInterface({ input: process.stdin }).on('line', (line) => {
    const { a, b } = JSON.parse(line);
    try {
      const solids = [a, b].map((solid) => solidOf(solid, a.center ?? b.center));
      say(solids.every(fits) ? answer(...solids) : { declined: 'too far, or beyond single precision' });
    } catch (error) {
      say({ error: String(error) });
      flush();
      process.exit(1); // an engine that threw is in no known state
    }
  });
}
