// SPDX-License-Identifier: MIT
// The guests in Node share this: a hello, then an answer line for each line of a pair. Most engines use single
// precision and keep a cylinder along y. So positions count from the centre of a before they are rounded.
import { createInterface } from 'node:readline';

/** The unit quaternion that turns y to the line of `axis`, by the half-way vector. */
function turnFromY(axis) {
  const unit = Math.max(...axis.map(Math.abs)) * (axis[1] < 0 ? -1 : 1); // a cylinder looks the same upside down
  const [x, y, z] = axis.map((c) => c / unit);
  const length = Math.hypot(x, y, z), n = Math.hypot(x, y + length, z);
  return { x: z / n, y: 0, z: -x / n, w: (y + length) / n };
}

function solidOf(cylinder, origin) {
  const [x, y, z] = cylinder.center.map((c, i) => c - origin[i]);
  const { height, radius, rounding = 0 } = cylinder;
  const kind = rounding === 0 ? 'cylinder' : radius > 0 ? 'rounded' : height > 0 ? 'capsule' : 'sphere';
  return { kind, halfHeight: height / 2, radius, rounding, position: { x, y, z }, turn: turnFromY(cylinder.axis) };
}

/** Lengths whose fourth powers single precision holds. */
const least = 1e-9, most = 1e9;

function fits({ halfHeight, radius, rounding, position }) {
  return [halfHeight, radius, rounding].every((x) => x === 0 || (x >= least && x <= most)) &&
    Object.values(position).every((x) => Math.abs(x) <= most);
}

/** All kinds of solids that daylight asks about. */
export const all_kinds = ['sphere', 'capsule', 'cylinder', 'rounded'];

/** `answer` takes two solids and gives an answer line as an object. */
export function serve(hello, answer) {
  // Answers to lines that arrive together leave together: a write for each line would take longer than the answer.
  let said = '';
  const flush = () => { process.stdout.write(said); said = ''; };
  const say = (object) => {
    if (said === '') setImmediate(flush);
    said += JSON.stringify(object) + '\n';
  };
  say(hello);
  createInterface({ input: process.stdin }).on('line', (line) => {
    const { a, b } = JSON.parse(line);
    try {
      const solids = [a, b].map((cylinder) => solidOf(cylinder, a.center));
      say(solids.every(fits) ? answer(...solids) : { declined: 'beyond single precision' });
    } catch (error) {
      say({ error: String(error) });
      flush();
      process.exit(1); // an engine that threw is in no known state
    }
  });
}
