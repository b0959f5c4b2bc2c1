// SPDX-License-Identifier: MIT
// Names beside the marks of a plot, so that none is printed over another, in pixels.
export interface Spot {
  x: number;
  y: number;
}
export interface Box extends Spot {
  wide: number;
  high: number;
}

const letter = 9,
  high = 16,
  gap = 8;

/** The square around a mark. */
export const around = ({ x, y }: Spot, half: number): Box => ({
  x: x - half,
  y: y - half,
  wide: 2 * half,
  high: 2 * half,
});

const meet = (a: Box, b: Box) => a.x < b.x + b.wide && b.x < a.x + a.wide && a.y < b.y + b.high && b.y < a.y + a.high;
const contains = (a: Box, b: Box) =>
  b.x >= a.x && b.x + b.wide <= a.x + a.wide && b.y >= a.y && b.y + b.high <= a.y + a.high;

/** Right, left and centred, first at the height of the mark, then ever farther above and below it. */
function placesBeside({ x, y }: Spot, wide: number): Box[] {
  const steps = Array.from({ length: 24 }, (_, i) => (i % 2 === 0 ? -1 : 1) * Math.ceil(i / 2) * (high / 2));
  return steps.flatMap((step) =>
    [x + gap, x - gap - wide, x - wide / 2].map((left) => ({ x: left, y: y - high / 2 + step, wide, high })),
  );
}

/** The first of the places inside `frame` that meets nothing of `taken`; the first of all if none does. */
export const firstFree = (places: Box[], taken: Box[], frame: Box): Box =>
  places.find((b) => contains(frame, b) && !taken.some((other) => meet(b, other))) ?? places[0]!;

/** A place inside `frame` for each name, which meets nothing of `taken` and no other name. */
export function placed(marks: (Spot & { name: string })[], taken: Box[], frame: Box): Box[] {
  const all = [...taken];
  return marks.map((mark) => {
    const box = firstFree(placesBeside(mark, letter * mark.name.length), all, frame);
    all.push(box);
    return box;
  });
}

/** How far a box is from a spot. */
export const farFrom = ({ x, y }: Spot, box: Box) =>
  Math.hypot(Math.max(box.x - x, x - box.x - box.wide, 0), Math.max(box.y - y, y - box.y - box.high, 0));
