// SPDX-License-Identifier: MIT
// The prover of the page, as it was built into the page: good certificates hold, tampered ones do not.
//     node --test prove_test.mjs
import assert from "node:assert/strict";
import { test } from "node:test";
import { daylight } from "../chart.mjs";

const { exact, floorSqrt, prove } = daylight;

const cylinder = (center, axis, radius, height) => ({ center, axis, radius, height });
const upright = cylinder([0, 0, 0], [0, 0, 1], 1, 2);
const apart = { a: upright, b: cylinder([2.5, 0, 0], [0, 1, 0], 1, 2) };
const meeting = { a: upright, b: cylinder([1, 1, 1], [1, 1, 1], 0.5, 3) };
const atARationalPoint = { a: cylinder([0, 0, 0], [0, 0, 1], 2, 4), b: cylinder([3, 4, 0], [0, 0, 1], 3, 4) };
const huge = { a: cylinder([0, 0, 0], [0, 0, 1], 1e150, 4e150), b: cylinder([0, 2e150, 0], [1, 0, 0], 1e150, 4e150) };
const holds = (pair, truth) => prove(pair, truth).holds;
const direction = (...d) => ({ verdict: "disjoint", direction: d });
const point = (...x) => ({ verdict: "intersecting", point: x });

test("a direction separates or does not", () => {
  assert.equal(holds(apart, direction(1, 0, 0)), true);
  assert.equal(holds(apart, direction(-1e-300, 0, 0)), true, "its length and its sign do not matter");
  assert.equal(holds(apart, direction(0, 1, 0)), false);
  assert.equal(holds(meeting, direction(1, 1, 1)), false);
  assert.equal(holds(apart, direction(0, 0, 0)), false);
});

test("a gap of one unit in the last place shows", () => {
  const next = 2 + 2 ** -51;
  const beside = (x) => ({ a: upright, b: cylinder([x, 0, 0], [0, 3, 4], 1, 2) });
  assert.equal(holds(beside(next), direction(1, 0, 0)), true);
  assert.equal(holds(beside(2), direction(1, 0, 0)), null, "touching: f is 0, which no precision shows");
  assert.equal(holds(beside(2 - 2 ** -52), direction(1, 0, 0)), false);
  assert.equal(holds(beside(next), direction(1, 1e-7, 0)), false, "turned by more than the gap allows");
});

test("a sign that hides in the sixtieth digit shows with more of them", () => {
  const touching = { a: upright, b: cylinder([2, 0, 0], [0, 3, 4], 1, 2) },
    tiny = `1/${10n ** 60n}`,
    tinier = `1/${10n ** 6000n}`;
  assert.equal(holds(touching, direction(1, tiny, 0)), false);
  assert.equal(holds(touching, direction(1, tinier, 0)), null);
  assert.match(prove(touching, direction(1, tinier, 0)).text, /16384/);
});

const ball = (center, rounding) => ({ ...cylinder(center, [1, 2, 0], 0, 0), rounding });
const capsule = (center, axis, height, rounding) => ({ ...cylinder(center, axis, 0, height), rounding });
const points = (verdict, p, q) => ({ verdict, points: [p, q] });

test("balls and capsules: a direction counts the roundings, points are of the cores", () => {
  const balls = (rounding) => ({ a: ball([0, 0, 0], 1), b: ball([3, 4, 0], rounding) });
  assert.equal(holds(balls(3.5), direction(3, 4, 0)), true);
  assert.equal(holds(balls(4), direction(3, 4, 0)), null, "touching");
  assert.equal(holds(balls(4.5), direction(3, 4, 0)), false);
  assert.equal(holds(balls(4), points("touching", [0, 0, 0], [3, 4, 0])), true);
  assert.equal(holds(balls(3.9999999999999996), points("intersecting", [0, 0, 0], [3, 4, 0])), false, "one bit less");
  assert.equal(holds(balls(9), points("intersecting", [0, 0, 0], [3, 4, "1/1000000000000000000"])), false, "no centre");
  assert.equal(holds(balls(9), { verdict: "intersecting", points: [[0, 0, 0]] }), false, "one is missing");
  const crossed = { a: capsule([0, 0, 0], [1, 0, 0], 4, 0.5), b: capsule([1, 0, 0.9], [0, 1, 0], 4, 0.5) };
  assert.equal(holds(crossed, points("intersecting", [1, 0, 0], [1, 0, 0.9])), true);
  assert.equal(holds(crossed, points("intersecting", [1, 0, 0], [1, 0.5, 0.9])), false, "too far apart");
  assert.equal(holds(crossed, points("intersecting", [2.5, 0, 0], [1, 0, 0.9])), false, "beyond the end");
});

test("near touching by two points", () => {
  const root = (n) => `${floorSqrt(BigInt(n) << 1024n)}/${1n << 512n}`;
  const pair = { a: capsule([0, 0, 0], [1, 1, 0], 2, 1), b: ball([0, 0, 2], 1) },
    near = (x, z) => ({ verdict: "touching", near: { points: [[x, x, 0], [0, 0, z]], direction: [0, 0, 1] } });
  assert.equal(holds(pair, near(0, 2)), true);
  assert.equal(holds(pair, near(root(2), 2)), false, "beyond the end of the capsule");
  assert.equal(holds(pair, near("1/1000000000", 2)), false, "farther apart than 2^-200 of the size allows");
  assert.equal(holds({ ...pair, b: ball([0, 0, 2], 0.999) }, near(0, 2)), false);
});

test("lengths hundreds of decades apart", () => {
  const far = {
    a: cylinder([-1e300, 0, 0], [0, 0, 5e-324], 5e-324, 1e-300),
    b: cylinder([1e300, 1, 0], [0, 0, 1e300], 1, 2),
  };
  assert.equal(holds(far, direction(1, 5e-301, 0)), true);
  assert.equal(holds(far, direction(5e-301, -1, 0)), false);
});

test("a point lies in both or not", () => {
  const within = [[1, -0.5860419361783156], [1, -0.5860419361783156], [1, -0.5274632924156251]];
  assert.equal(holds(meeting, point(...within)), true);
  assert.equal(holds(meeting, point(0, 0, 1)), false, "in the first alone");
  assert.equal(holds(meeting, point(1, 1, 1)), false, "in the second alone");
  const touches = (...at) => holds(atARationalPoint, { verdict: "touching", point: at });
  assert.equal(touches("6/5", "8/5", 0), true);
  assert.equal(touches("6/5", "8/5", 2), true, "on the rim too: solids are closed");
  assert.equal(touches("6000000000000000000000001/5000000000000000000000000", "8/5", 0), false);
  assert.equal(touches(1.2, 1.6, 0), false, "rounded to doubles");
  assert.equal(touches("6/5", "8/5", [2, 1e-300]), false, "above both");
});

test("touching solids share no inner point", () => {
  const up = cylinder([0, 0, 0], [0, 0, 2], 3, 8),
    touch = (b, ...at) => holds({ a: up, b }, { verdict: "touching", point: at }),
    at = (center, axis = [0, 0, 1]) => cylinder(center, axis, 3, 8);
  assert.equal(touch(at([6, 0, 1]), 3, 0, 0.5), true, "side and side");
  assert.equal(touch(at([6, 0, 0], [0, 1, 0]), 3, 0, 0), true, "crossed sides");
  assert.equal(touch(at([7, 0, 0], [1, 0, 0]), 3, 0, 0), true, "a cap on a side");
  assert.equal(touch(at([6, 0, 8]), 3, 0, 4), true, "rim and rim");
  assert.equal(touch(cylinder([1, 0, 6], [0, 0, 1], 0, 4), 1, 0, 4), true, "the end of a segment on a cap");
  assert.equal(touch(cylinder([0, 3, 0], [1, 0, 0], 0, 4), 0, 3, 0), true, "a segment along a side");
  for (const x of [0, 1, 2, 3, 4, 5, 5.75])
    for (const z of [0, 1, 4]) {
      assert.equal(touch(at([x, 0, z]), x / 2, 0, z / 2), false, "inner points are shared");
      assert.equal(touch(at([x, 0, z]), 3, 0, 4), false, "at a point of the rim");
    }
  const ball = (x) => ({ ...cylinder([x, 0, 0], [0, 0, 1], 0, 0), rounding: 1 }),
    balls = (x, p, q) => holds({ a: ball(0), b: ball(x) }, { verdict: "touching", points: [p, q] });
  assert.equal(balls(2, [0, 0, 0], [2, 0, 0]), true);
  assert.equal(balls(1.75, [0, 0, 0], [1.75, 0, 0]), false);
  assert.equal(balls(0, [0, 0, 0], [0, 0, 0]), false);
});

test("nothing is proved of pairs that are not valid", () => {
  for (const change of [{ radius: -1 }, { height: -1 }, { rounding: -1 }, { axis: [0, 0, 0] }, { center: [NaN, 0, 0] }])
    for (const truth of [direction(1, 0, 0), point(1, 0, 0), { verdict: "touching", point: [1, 0, 0] }])
      for (const side of ["a", "b"])
        assert.equal(holds({ ...apart, [side]: { ...apart[side], ...change } }, truth), false, JSON.stringify(change));
});

test("touching within 2^-200 of the size", () => {
  const near = (x, d) => ({ verdict: "touching", near: { point: x, direction: d } });
  assert.equal(holds(huge, near([-0.0000028746500148266185, 1e150, 0], [0, 1, 0])), true);
  const beyond = (by) => holds(huge, near([-0.0000028746500148266185, [1e150, by], 0], [0, 1, 0]));
  assert.equal(beyond(1e85), true, "it is below 2^-200 of 1.0e151");
  assert.equal(beyond(1e92), false);
  assert.equal(holds(huge, near([0, 1e150, 0], [1e-20, 1, 0])), false);
  assert.equal(holds(huge, near([0, 1e150, 0], [0, 0, 0])), false);
});

test("a truth without a certificate proves nothing, and throws nothing", () => {
  for (const truth of [
    direction(1, 0),
    direction(1, 0, "x"),
    direction(1, 0, "1/0"),
    direction(1, 0, null),
    direction(1, 0, [1, "2"]),
    direction(Infinity, 0, 0),
    { verdict: "disjoint" },
    point(),
    { verdict: "intersecting", direction: [1, 0, 0] },
    { verdict: "touching", near: {} },
  ])
    assert.equal(holds(apart, truth), false, JSON.stringify(truth));
  for (const verdict of ["undecided", "invalid", "nonsense"]) assert.equal(holds(apart, { verdict }), null);
  assert.equal(holds({ a: upright, b: { ...upright, axis: [0, 0, 0] } }, direction(1, 0, 0)), false);
});

test("a part that does not belong to the verdict is refused", () => {
  const proofs = { direction: [1, 0, 0], point: [1, 0, 0], points: [[1, 0, 0], [1, 0, 0]], near: { point: [1, 0, 0] } };
  const extra = (truth, ...parts) => {
    for (const part of parts)
      assert.match(prove(apart, { ...truth, [part]: proofs[part] }).text, /does not belong to the verdict/, part);
  };
  extra(direction(1, 0, 0), "point", "points", "near");
  extra(point(1, 0, 0), "direction", "points", "near");
  extra({ verdict: "touching", point: [1, 0, 0] }, "direction", "points", "near");
  extra({ verdict: "undecided" }, "direction", "point", "points", "near");
});

test("doubles are taken exactly, roots rounded down", () => {
  assert.deepEqual(exact(0.1), { n: 3602879701896397n * 2n, d: 2n ** 56n });
  assert.deepEqual(exact(-5e-324), { n: -1n, d: 2n ** 1074n });
  assert.deepEqual(exact(2 ** 60), { n: 2n ** 60n, d: 1n });
  const large = [10n ** 40n, 10n ** 40n - 1n, 2n ** 2000n + 1n, 3n ** 1400n, 3n ** 1400n - 1n];
  for (const n of [0n, 1n, 2n, 3n, 4n, 15n, 16n, 17n, ...large]) {
    const root = floorSqrt(n);
    assert.ok(root * root <= n && (root + 1n) * (root + 1n) > n, String(n));
  }
});

test("a point in hulls is the nearest point of both", () => {
  const rod = cylinder([0, 0, 0], [0, 0, 1], 1, 4),
    segment = cylinder([0.1, 0.2, 0], [0.3, 0.4, 1], 0, 4),
    disk = cylinder([0, 0, 0.5], [0, 1, 3], 1, 0);
  const on = (x, hulls) => ({ ...point(...x), hulls });
  assert.equal(holds({ a: rod, b: segment }, point(0.13, 0.24, 0.1)), false, "no double lies on the segment");
  assert.equal(holds({ a: rod, b: segment }, on([0.13, 0.24, 0.1], ["space", "line"])), true);
  assert.equal(holds({ a: rod, b: segment }, on([0.13, 0.24, 9], ["space", "line"])), false, "beyond both ends");
  assert.equal(holds({ a: disk, b: rod }, on([0.1, 0.1, 0.4], ["plane", "space"])), true);
  assert.equal(holds({ a: disk, b: segment }, on([0.2, 0.3, 0.4], ["plane", "line"])), true, "at the crossing");
  const beside = cylinder([5, 0, 0], [0.3, 0.4, 1], 0, 4);
  assert.equal(holds({ a: disk, b: beside }, on([0.2, 0.3, 0.4], ["plane", "line"])), false);
  const above = cylinder([0, 0, 0.75], [0, 1, 3], 1, 0);
  assert.match(prove({ a: disk, b: above }, on([0, 0, 0.6], ["plane", "plane"])).text, /no common point/);
  const capsule = { ...segment, rounding: 0.25 },
    ball = { ...cylinder([0.3, 0.2, 0.1], [0, 0, 1], 0, 0), rounding: 0.25 };
  const points = { verdict: "intersecting", points: [[0.13, 0.24, 0.1], [0.3, 0.2, 0.1]] };
  assert.equal(holds({ a: capsule, b: ball }, points), false);
  assert.equal(holds({ a: capsule, b: ball }, { ...points, hulls: ["line", "center"] }), true);
});

test("a half-space: its normal separates, and points lie behind its plane", () => {
  const plane = { shape: "half_space", point: [0, 0, 0], normal: [0, 3, 4] },
    ball = (z) => ({ ...cylinder([0, 0, z], [0, 0, 1], 0, 0), rounding: 4 });
  const direction = (...d) => ({ verdict: "disjoint", direction: d });
  assert.equal(holds({ a: plane, b: ball(6) }, direction(0, 3, 4)), true);
  assert.equal(holds({ a: plane, b: ball(6) }, direction(0, 0.75, 1)), true);
  assert.equal(holds({ a: plane, b: ball(6) }, direction(0, 3, 4.000001)), false, "beside the normal");
  assert.equal(holds({ a: plane, b: ball(6) }, direction(0, -3, -4)), false, "inward");
  assert.equal(holds({ a: ball(6), b: plane }, direction(0, -3, -4)), true);
  assert.equal(holds({ a: plane, b: ball(5) }, direction(0, 3, 4)), null, "they touch");
  const points = (verdict, y, z) => ({ verdict, points: [[0, y, z], [0, 0, 5]] });
  assert.equal(holds({ a: plane, b: ball(5) }, points("touching", "-12/5", "9/5")), true);
  assert.equal(holds({ a: plane, b: ball(5) }, points("touching", "-12/5", "10/5")), false, "outside");
  const rod = cylinder([0, 0, 1], [1, 0, 0], 1, 2);
  assert.equal(holds({ a: plane, b: rod }, { verdict: "touching", point: [0, 0, 0] }), false, "they overlap there");
  assert.equal(holds({ a: plane, b: rod }, { verdict: "intersecting", point: [0, 0, 0] }), true);
});

const box = (center, edges, quaternion, rounding = 0) => ({ shape: "box", center, edges, quaternion, rounding });
const die = box([0, 0, 0], [6, 6, 8]);

test("a box: its edges have rational directions for any length of its quaternion", () => {
  for (const k of [1, -3, 2 ** -1070, 2 ** 1000]) {
    const turned = box([18, 34, 8], [50, 50, 50], [4 * k, 2 * k, 2 * k, k]); // two edges cross at (3, 3, 0)
    assert.equal(holds({ a: die, b: turned }, { verdict: "touching", point: [3, 3, 0] }), true);
    assert.equal(holds({ a: die, b: turned }, direction(3, 5, 0)), false, "touching");
    const apart = { ...turned, center: [18, 34 + 2 ** -40, 8] };
    assert.equal(holds({ a: die, b: apart }, direction(3, 5, 0)), true);
    assert.equal(holds({ a: die, b: apart }, direction(3, 4, 0)), false);
    const deep = { a: die, b: { ...turned, center: [18, 34 - 2 ** -40, 8] } };
    assert.equal(holds(deep, { verdict: "intersecting", point: [3, 3, 0] }), true);
    assert.equal(holds(deep, { verdict: "touching", point: [3, 3, 0] }), false);
    assert.equal(holds(deep, { verdict: "intersecting", point: [3, 3 - 2 ** -39, 0] }), false);
  }
});

test("a box touches other solids", () => {
  const up = cylinder([0, 0, 0], [0, 0, 2], 3, 8),
    sheet = box([0, 0, 4], [2, 2, 0]);
  for (const [a, at] of [
    [{ ...up, center: [6, 0, 0] }, [3, 0, 1]],
    [{ ...up, center: [0, 0, 8] }, [1, 1, 4]],
    [cylinder([24, 31, 5], [-12, -16, 15], 25, 50), [3, 3, 0]], // a rim on an edge
    [cylinder([3, 3, 0], [1, -1, 0], 0, 8), [3, 3, 0]],
    [sheet, [0, 1, 4]],
    [{ shape: "half_space", point: [3, 3, -4], normal: [-1, -1, 3] }, [3, 3, -4]],
  ]) {
    const touch = (b, ...point) => holds({ a, b }, { verdict: "touching", point });
    assert.equal(touch(die, ...at), true, JSON.stringify(a));
    assert.equal(touch({ ...die, rounding: 2 ** -40 }, ...at), false, "a point of rounded solids");
    assert.equal(touch({ ...die, edges: die.edges.map((e) => e + 2 ** -40) }, ...at), false, "deeper");
    assert.equal(touch(die, 5, 5, 5), false);
  }
  assert.equal(holds({ a: sheet, b: up }, { verdict: "touching", point: [0, 0, 4] }), true);
  const beside = { ...sheet, center: [1, 1, 4] };
  assert.equal(holds({ a: sheet, b: beside }, { verdict: "touching", point: [1, 1, 4] }), true);
});

test("a rounded box, a flat box, and solids that are not boxes", () => {
  const rod = capsule([6, 7, 0], [0, 0, 1], 2, 3),
    meet = (verdict, rounding) => holds({ a: { ...die, rounding }, b: rod }, points(verdict, [3, 3, 1], [6, 7, 1]));
  assert.deepEqual([2, 2 + 2 ** -40, 2 - 2 ** -40].map((r) => meet("touching", r)), [true, false, false]);
  assert.deepEqual([2, 2 + 2 ** -40, 2 - 2 ** -40].map((r) => meet("intersecting", r)), [true, true, false]);
  assert.equal(holds({ a: { ...die, rounding: 1.75 }, b: rod }, direction(3, 4, 0)), true);
  const beside = points("touching", [0, 3, 0], [3, 7, 0]);
  assert.equal(holds({ a: die, b: ball([3, 7, 0], 5) }, beside), false, "they overlap elsewhere");
  const near = (x, at = 3) => {
    const b = cylinder([x, 0, 0], [0, 0, 1], 3, 8);
    return holds({ a: die, b }, { verdict: "touching", near: { point: [at, 0, 0], direction: [1, 0, 0] } });
  };
  assert.deepEqual([near(6), near(6, [3, 2 ** -210])], [true, true]);
  assert.deepEqual([near(6 + 2 ** -40), near(6 - 2 ** -40)], [false, false]);
  const leaning = { a: box([0.1, 0.2, 0.3], [2, 2, 0], [1, 2, 3, 4]), b: cylinder([0, 0, 0], [0, 0, 1], 3, 8) };
  for (const hulls of [undefined, ["plane", "space"]]) {
    assert.equal(holds(leaning, { ...point(0.1, 0.2, 0.300000001), hulls }), true, "the point meant is in its plane");
    assert.equal(holds(leaning, { ...point(1.7, 0.2, 0.3), hulls }), false);
  }
  for (const change of [{ edges: [1, 1] }, { edges: [1, 1, -1] }, { quaternion: [0, 0, 0, 0] }, { quaternion: [1] }])
    assert.equal(holds({ a: { ...die, ...change }, b: rod }, direction(3, 4, 0)), false, JSON.stringify(change));
});
