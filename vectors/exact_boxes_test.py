# SPDX-License-Identifier: MIT
"""The exact checker believes a certificate of a box as long as it holds, and none beyond. Separating axes and the
corners of the common part, computed here in rational numbers, state what holds."""
import itertools
import random
import sys
import unittest
from fractions import Fraction

sys.dont_write_bytecode = True
import exact  # noqa: E402

UP = {'center': [0, 0, 0], 'axis': [0, 0, 2], 'radius': 3, 'height': 8, 'rounding': 0}
JUST = 2**-40


def box(center, edges, quaternion=(1, 0, 0, 0), **other):
    return {'shape': 'box', 'center': list(center), 'edges': list(edges), 'quaternion': list(quaternion), **other}


def dot(u, v):
    return sum(x * y for x, y in zip(u, v))


def cross(u, v):
    return (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])


def rows(solid):
    """The rotation of a box as a matrix written out, by columns, times |q|^2; and |q|^2."""
    w, x, y, z = solid['quaternion']
    return ((w * w + x * x - y * y - z * z, 2 * (x * y + w * z), 2 * (x * z - w * y)),
            (2 * (x * y - w * z), w * w - x * x + y * y - z * z, 2 * (y * z + w * x)),
            (2 * (x * z + w * y), 2 * (y * z - w * x), w * w - x * x - y * y + z * z)), w * w + x * x + y * y + z * z


def axes(asked):
    """Directions. If two boxes are apart, one of these 15 separates them."""
    a, b = rows(asked['a'])[0], rows(asked['b'])[0]
    return [n for n in (*a, *b, *(cross(u, v) for u in a for v in b)) if any(n)]


def gap_along(asked, n):
    """The gap of two boxes along n, times |n|: of their 16 corners."""
    ends = []
    for solid in (asked['a'], asked['b']):
        columns, length = rows(solid)
        parts = [Fraction(edge, 2 * length) * dot(n, c) for edge, c in zip(solid['edges'], columns)]
        corners = [dot(n, solid['center']) + dot(signs, parts) for signs in itertools.product((-1, 1), repeat=3)]
        ends.append((min(corners), max(corners)))
    return max(ends[1][0] - ends[0][1], ends[0][0] - ends[1][1])


def common_corners(asked):
    """The corners of what two boxes have in common: points in which three of their planes cross."""
    walls = []
    for solid in (asked['a'], asked['b']):
        columns, length = rows(solid)
        for c, edge in zip(columns, solid['edges']):
            middle = dot(c, solid['center'])
            walls += [(c, middle + Fraction(length * edge, 2)), ([-x for x in c], Fraction(length * edge, 2) - middle)]
    found = set()
    for (n, k), (m, j), (p, i) in itertools.combinations(walls, 3):
        volume = dot(n, cross(m, p))
        if volume != 0:
            parts = zip(cross(m, p), cross(p, n), cross(n, m))
            x = tuple((k * u + j * v + i * w) / volume for u, v, w in parts)
            if all(dot(c, x) <= most for c, most in walls):
                found.add(x)
    return found


def in_words(x):
    return [str(Fraction(c)) for c in x]


class Boxes(unittest.TestCase):
    def test_boxes_and_a_brute_force(self):
        """Small boxes, flat ones too: 15 axes and the corners of the common part state what may be believed."""
        draw, counts = random.Random(5), {'disjoint': 0, 'touching': 0, 'intersecting': 0}
        for number in range(100):
            turns = [[1, 0, 0, 0], [0, 0, 0, 3], [1, 1, 0, 0]] if number % 2 else [
                [draw.randint(-2, 2) for _ in range(3)] + [1] for _ in range(3)]
            asked = {k: box([draw.randint(-3, 3) for _ in range(3)], [draw.choice((0, 2, 4, 6)) for _ in range(3)],
                            draw.choice(turns)) for k in 'ab'}
            widest, points = max(gap_along(asked, n) for n in axes(asked)), common_corners(asked)
            truth = 'disjoint' if widest > 0 else 'intersecting' if widest < 0 else 'touching'
            counts[truth] += 1
            self.assertEqual(bool(points), widest <= 0, asked)
            other = [[draw.randint(-9, 9) for _ in range(3)] for _ in range(9)]
            wild = {k: dict(asked[k], quaternion=[2.0**e * x for x in asked[k]['quaternion']])
                    for k, e in (('a', 500), ('b', -1000))}
            for n in axes(asked) + other:
                why = exact.fault(wild, {'verdict': 'disjoint', 'direction': in_words(n)})
                self.assertEqual(why is None, any(n) and gap_along(asked, n) > 0, (asked, n))
            if points:
                points.add(tuple(sum(c) / len(points) for c in zip(*points)))
            else:  # of one of them alone
                points = {tuple(asked[k]['center']) for k in 'ab'}
            for x in points:
                for verdict in ('intersecting', 'touching'):
                    why = exact.fault(wild, {'verdict': verdict, 'point': in_words(x)})
                    believed = truth != 'disjoint' and (verdict != 'touching' or truth == 'touching')
                    self.assertEqual(why is None, believed, (asked, x, verdict))
                    forged = [[c + by * draw.choice((-1, 1)) for c in x] for by in (JUST, 1, 9)]
                    for y in forged:
                        within = all(abs(dot(c, [p - q for p, q in zip(y, s['center'])])) <= Fraction(length * edge, 2)
                                     for s in asked.values() for columns, length in [rows(s)]
                                     for c, edge in zip(columns, s['edges']))
                        flat = 0 in asked['a']['edges'] + asked['b']['edges']  # then another point is meant
                        why = exact.fault(wild, {'verdict': 'intersecting', 'point': in_words(y)})
                        self.assertTrue(truth != 'disjoint' or why, (asked, y))
                        self.assertTrue(flat or (why is None) == within, (asked, y))
        self.assertTrue(min(counts.values()) >= 8, counts)

    def test_rounded_boxes_and_balls(self):
        """The point of a box that is nearest to a ball, by clamping along the edges, and the same in a turned frame."""
        draw, counts = random.Random(3), {True: 0, False: 0}
        for _ in range(400):
            edges, at = [draw.choice((0, 2, 4)) for _ in range(3)], [draw.randint(-6, 6) for _ in range(3)]
            solid = box((0, 0, 0), edges, [draw.randint(-3, 3) for _ in range(3)] + [1], rounding=draw.randint(0, 3))
            near = [max(Fraction(-e, 2), min(Fraction(e, 2), x)) for e, x in zip(edges, at)]
            columns, length = rows(solid)
            turned = [in_words(dot(x, c) / Fraction(length) for c in zip(*columns)) for x in (near, at)]
            ball = {'shape': 'sphere', 'center': turned[1], 'radius': draw.randint(1, 6)}
            asked = {'a': exact.plain(solid), 'b': exact.plain(ball)}
            between, reach = dot(*[[p - q for p, q in zip(at, near)]] * 2), solid['rounding'] + ball['radius']
            self.assertEqual(exact.come_near(asked, turned), between <= reach**2, asked)
            ends = [exact.vector(x) for x in turned]
            touch = exact.come_near(asked, turned) and exact.touch_at(asked, *ends)
            self.assertEqual(touch, between == reach**2, asked)
            counts[touch] += 1
            if any(ends[1][i] != ends[0][i] for i in range(3)):
                towards = exact.minus(ends[1], ends[0])
                self.assertEqual(exact.separates(asked, towards), between > reach**2, asked)
        self.assertTrue(min(counts.values()) >= 5, counts)

    def test_boxes_and_other_solids(self):
        """Contacts of a box with each shape, which are neither apart nor any deeper."""
        die, turned = box((0, 0, 0), (6, 6, 8)), box((0, 0, 0), (2, 6, 8), (3, 0, 0, 3))  # by a right angle about z
        sheet, slope = box((0, 0, 4), (2, 2, 0)), {'shape': 'half_space', 'point': [3, 3, -4], 'normal': [-1, -1, 3]}
        contacts = [(UP | {'center': [6, 0, 0]}, die, (3, 0, 1)), (UP | {'center': [0, 0, 8]}, die, (1, 1, 4)),
                    ({'center': [3, 1, 8], 'axis': [0, 0, 1], 'radius': 0, 'height': 8}, turned, (3, 1, 4)),
                    ({'center': [3, 3, 0], 'axis': [1, -1, 0], 'radius': 0, 'height': 8}, die, (3, 3, 0)),
                    ({'center': [6, 0, 4], 'axis': [0, 1, 0], 'radius': 3, 'height': 0}, die, (3, 0, 4)),
                    (UP | {'center': [3, 7, 0], 'axis': [0, 1, 0]}, die, (3, 3, 1)), (UP, sheet, (0, 1, 4)),
                    (sheet | {'center': [2, 2, 4]}, sheet, (1, 1, 4)), (sheet | {'center': [1, 1, 4]}, sheet, (0, 1, 4)),
                    ({'shape': 'half_space', 'point': [0, 0, -4], 'normal': [0, 0, 2]}, die, (1, 2, -4)),
                    (box((18, 34, 8), (50, 50, 50), (4, 2, 2, 1)), die, (3, 3, 0)),  # crossed edges
                    ({'center': [24, 31, 5], 'axis': [-12, -16, 15], 'radius': 25, 'height': 50}, die, (3, 3, 0)),
                    (slope, die, (3, 3, -4)), (box((6, 0, 0), (0, 0, 0)), box((3, 0, 0), (6, 0, 0)), (6, 0, 0))]
        for a, b, point in contacts:
            for asked in ({'a': a, 'b': b}, {'a': b, 'b': a}):
                answer = {'verdict': 'touching', 'point': list(point), 'distance': [0, 0]}
                self.assertIsNone(exact.fault(asked, answer), asked)
                for k in 'ab':
                    deeper = dict(asked, **{k: dict(asked[k], rounding=JUST)})
                    if 'point' not in asked[k]:
                        self.assertIsNotNone(exact.fault(deeper, answer), deeper)
                for d in itertools.product((-1, 0, 1), repeat=3):
                    self.assertIsNotNone(exact.fault(asked, {'verdict': 'disjoint', 'direction': list(d)}))
                for x in itertools.product((-1, 0, 1), repeat=3):
                    moved = dict(answer, point=[c + JUST * by for c, by in zip(point, x)])
                    if any(abs(p) > q for p, q in zip(moved['point'], (3, 3, 4))) and b == die:
                        self.assertIsNotNone(exact.fault(asked, moved), (asked, x))
        rod = {'shape': 'capsule', 'center': [6, 7, 0], 'axis': [0, 0, 1], 'radius': 3, 'height': 2}
        points = [[3, 3, 1], [6, 7, 1]]
        for rounding, verdicts in ((2, ['intersecting', 'touching']), (2 + JUST, ['intersecting']), (2 - JUST, [])):
            asked = {'a': dict(die, rounding=rounding), 'b': rod}
            self.assertEqual([v for v in ('intersecting', 'touching')
                              if not exact.fault(asked, {'verdict': v, 'points': points})], verdicts)
            apart = exact.fault(asked, {'verdict': 'disjoint', 'direction': [3, 4, 0]})
            self.assertEqual(apart is None, rounding < 2)
        ball = {'shape': 'sphere', 'center': [3, 7, 0], 'radius': 5}
        beside = {'verdict': 'intersecting', 'points': [[0, 3, 0], [3, 7, 0]]}
        self.assertIsNone(exact.fault({'a': die, 'b': ball}, beside))
        self.assertIn('overlap', exact.fault({'a': die, 'b': ball}, dict(beside, verdict='touching')))
        near = {'verdict': 'touching', 'near': {'point': [3, 0, 0], 'direction': [1, 0, 0]}}
        for x in (6, 6 + JUST, 6 - JUST):
            self.assertEqual(exact.fault({'a': die, 'b': UP | {'center': [x, 0, 0]}}, near) is None, x == 6)
        near['near']['point'] = [[3, 2.0**-210], 0, 0]
        self.assertIsNone(exact.fault({'a': die, 'b': UP | {'center': [6, 0, 0]}}, near))
        leaning = {'a': box((0.1, 0.2, 0.3), (2, 2, 0), (1, 2, 3, 4)), 'b': UP}
        meet = {'verdict': 'intersecting', 'point': [0.1, 0.2, 0.3 + JUST]}
        for hulls in ({}, {'hulls': ['plane', 'space']}):  # the point that is meant is the centre
            self.assertIsNone(exact.fault(leaning, meet | hulls))
            self.assertIn('not in both', exact.fault(leaning, meet | hulls | {'point': [1.7, 0.2, 0.3]}))
        one = f'{10**30000 - 1}/{10**30000}'
        self.assertIsNone(exact.fault({'a': die, 'b': UP}, {'verdict': 'intersecting', 'point': [one, one, 0]}))
        for change in ({'edges': [1, 1]}, {'edges': [1, 1, -1]}, {'quaternion': [0, 0, 0, 0]}, {'quaternion': [1, 0, 0]},
                       {'rounding': -1}, {'center': None}, {'edges': [1, 1, float('inf')]}, {'edges': [1, 1, '1']}):
            for answer in (meet, {'verdict': 'disjoint', 'direction': [1, 0, 0]}):
                self.assertIn('not valid', exact.fault({'a': die | change, 'b': UP}, answer))
        known = {'verdict': 'invalid', 'error': 'line 1'}
        self.assertEqual(exact.fault({'a': die, 'b': UP}, known), 'the pair is valid')
        self.assertIsNone(exact.fault({'a': die | {'size': 1}, 'b': UP}, known))


if __name__ == '__main__':
    unittest.main()
