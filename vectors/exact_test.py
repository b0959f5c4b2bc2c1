# SPDX-License-Identifier: MIT
"""The exact checker believes each certificate up to where it holds and none beyond."""
import sys
import unittest

sys.dont_write_bytecode = True
import exact  # noqa: E402

UP = {'center': [0, 0, 0], 'axis': [0, 0, 2], 'radius': 3, 'height': 8, 'rounding': 0}
SLANTED = {'center': [0, 0, 0], 'axis': [0, 3, 4], 'radius': 5, 'height': 10, 'rounding': 1}
POINT = {'center': [0, 0, 0], 'axis': [1, 0, 0], 'radius': 0, 'height': 0}
JUST = 2**-40


def pair(a, center, **other):
    return {'a': a, 'b': dict(POINT, center=center, **other)}


class Exact(unittest.TestCase):
    def test_a_gap(self):
        """The point is `reach` from the centre along d if it is on the edge: a little nearer or farther decides."""
        for solid, d, reach in ((UP, (0, 0, 1), 4), (UP, (7, 0, 0), 3), (UP, (3, 0, 4), 5), (UP, (-3, 0, 4), 5),
                                (SLANTED, (0, 3, 4), 6), (SLANTED, (1, 0, 0), 6), (SLANTED, (0, -4, 3), 6),
                                (SLANTED, (0, 0, 1), 8), (SLANTED, (0, 1, 1), 1 + 8 / 2**0.5)):
            length = sum(x * x for x in d)**0.5
            for by in (-JUST, JUST):
                for swap in (False, True):
                    asked = pair(solid, [x / length * (reach + by) for x in d])
                    asked = {'a': asked['b'], 'b': asked['a']} if swap else asked
                    self.assertEqual(exact.separates(asked, d), by > 0, (solid, d, by))
                    low, high = (exact.gap(asked, d, 400, above) for above in (False, True))
                    self.assertTrue(low <= high and abs(low - by) < 2**-45, (solid, d, by))
        for z, width in ((5, -2**0.5), (9, 2**0.5)):  # with few bits the bounds are on their sides
            low, high = (exact.gap(pair(UP, [0, 0, z]), (0, 1, 1), 3, above) for above in (False, True))
            self.assertTrue(low < width < high and high - low < 0.5)
        self.assertFalse(exact.separates(pair(UP, [9, 0, 0]), (0, 0, 0)))
        self.assertFalse(exact.separates(pair(UP, [3, 0, 0]), (1, 0, 0)))

    def test_a_point(self):
        for p, inside in (((3, 0, 4), True), ((3 + JUST, 0, 4), False), ((3, 0, -4 - JUST), False),
                          ((0, -3, 0), True), ((0, -3 - JUST, 0), False)):
            self.assertEqual(exact.in_both(pair(UP, p), p), inside, p)
        self.assertFalse(exact.in_both(pair(UP, (0, 0, 0)), (1, 0, 0)))
        self.assertTrue(exact.in_both(pair(UP, (0, 0, 1), height=2), ('1/3', 0, [0.5, 0.5])))
        self.assertTrue(exact.in_both(pair(UP, (0, 0, 1), radius=2), (1, 1, 1 + JUST), ('space', 'space')) is False)
        self.assertTrue(exact.in_both(pair(UP, (0, 0, 1), radius=2), (JUST, 1, 1), ('space', 'plane')))
        for hull in ('plane', 'line', 'point'):
            moved = exact.nearest(exact.vector((5, 6, 7)), exact.equations(UP, hull))
            self.assertEqual(moved, {'plane': [5, 6, 0], 'line': [0, 0, 7], 'point': [0, 0, 0]}[hull])

    def test_two_points(self):
        for q, near in ((5, True), (5 + JUST, False)):
            asked = pair(dict(UP, rounding=1), (q, 0, 0), rounding=1)
            self.assertEqual(exact.come_near(asked, [(3, 0, 0), (q, 0, 0)]), near)
            self.assertEqual(exact.come_near(asked, [(3, 0, 0), (q, 0, 0)], extra=JUST), True)
            self.assertFalse(exact.come_near(asked, [(3 + JUST, 0, 0), (q, 0, 0)]))
            self.assertFalse(exact.come_near(asked, [(3, 0, 0), (4, 0, 0)]))

    def test_nearly_touching(self):
        for q, near in ((3, True), (3 + JUST, False), (3 - JUST, False)):
            proof = {'point': (q, 0, 0), 'direction': (1, 0, 0)}
            answer = {'verdict': 'touching', 'near': proof}
            self.assertEqual(exact.fault(pair(UP, (q, 0, 0)), answer) is None, near, q)
            rounded = pair(dict(UP, rounding=1), (q + 1, 0, 0))
            answer['near'] = {'points': [(3, 0, 0), (q + 1, 0, 0)], 'direction': (1, 0, 0)}
            self.assertEqual(exact.fault(rounded, answer) is None, near, q)

    def test_an_answer(self):
        apart = pair(UP, (4, 0, 0))
        for answer, why in (({'verdict': 'disjoint', 'direction': (1, 0, 0), 'distance': [1, 1]}, None),
                            ({'verdict': 'disjoint', 'direction': (1, 0, 0), 'distance': [2, 1]}, 'contradicts'),
                            ({'verdict': 'disjoint', 'direction': (1, 0, 0), 'distance': [-1, 0]}, 'contradicts'),
                            ({'verdict': 'disjoint', 'direction': (0, 0, 1)}, 'separate'),
                            ({'verdict': 'disjoint', 'direction': (1, 0, 0), 'clearance': 1}, 'separate'),
                            ({'verdict': 'intersecting', 'points': [(3, 0, 0), (4, 0, 0)], 'clearance': 1}, None),
                            ({'verdict': 'intersecting', 'point': (3, 0, 0)}, 'not in both'),
                            ({'verdict': 'invalid'}, 'without'), ({'verdict': 'far'}, 'no verdict')):
            self.assertIn(why or 'None', str(exact.fault(apart, answer)))

    def test_what_was_said(self):
        apart = pair(UP, (4, 0, 0))
        for said, refuted in (({'distance': 0.5, 'tolerance': 0.25, 'direction': (1, 0, 0)}, True),
                              ({'distance': 0.5, 'tolerance': 0.5, 'direction': (1, 0, 0)}, False),
                              ({'distance': 2, 'tolerance': 0.5, 'points': [(3, 0, 0), (4, 0, 0)]}, True),
                              ({'distance': 2, 'tolerance': 1.5, 'points': [(3, 0, 0), (4, 0, 0)]}, False),
                              ({'direction': (0, 0, 1)}, True), ({'direction': (1, 0, 0)}, False),
                              ({'point': (3, 0, 0)}, True)):
            self.assertEqual(exact.refuted(apart, said)[1], refuted, said)


if __name__ == '__main__':
    unittest.main()
