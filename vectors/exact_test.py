# SPDX-License-Identifier: MIT
"""The exact checker believes each certificate as long as it holds, and none beyond."""
import contextlib
import io
import pathlib
import sys
import tempfile
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

    def test_a_half_space(self):
        plane = {'shape': 'half_space', 'point': [0, 0, 0], 'normal': [0, 3, 4]}
        ball = {'shape': 'sphere', 'center': [0, 0, 6], 'radius': 4}
        touching = dict(ball, center=[0, 0, 5])

        def why(a, b, verdict, **certificate):
            return exact.fault({'a': a, 'b': b}, dict(certificate, verdict=verdict))
        self.assertIsNone(why(plane, ball, 'disjoint', direction=[0, 3, 4], distance=[0.75, 0.85]))
        self.assertIsNone(why(ball, plane, 'disjoint', direction=[0, -0.75, -1]))
        for d in ((0, -3, -4), (0, 3, 4 + JUST), (0, 0, 0)):
            self.assertIn('separate', why(plane, ball, 'disjoint', direction=d))
        self.assertIn('separate', why(plane, touching, 'disjoint', direction=[0, 3, 4]))
        on_plane = [0, '-12/5', '9/5']
        self.assertIsNone(why(plane, touching, 'touching', points=[on_plane, [0, 0, 5]]))
        self.assertIn('not in the cores', why(plane, touching, 'touching', points=[[0, '-12/5', 2], [0, 0, 5]]))
        self.assertIn('overlap', why(plane, dict(touching, radius=5), 'touching', points=[on_plane, [0, 0, 5]]))
        rod = {'shape': 'capsule', 'center': [0, 0, 5], 'quaternion': [1, 0, 0, 0], 'radius': 2, 'height': 10}
        self.assertIsNone(why(plane, rod, 'intersecting', point=[0, 0, 0]))
        self.assertIn('not valid', why(plane, plane, 'disjoint', direction=[0, 3, 4]))
        self.assertIn('not valid', why(dict(plane, normal=[0, 0, 0]), ball, 'disjoint', direction=[0, 3, 4]))
        near = {'point': [0, 0, 0], 'direction': [0, 3, 4]}
        self.assertIsNone(why(plane, dict(UP, axis=[0, 3, 4], height=10, center=[0, 3, 4]), 'touching', near=near))
        self.assertIn('2^-200', why(plane, dict(UP, axis=[0, 3, 4], height=10, center=[0, 3, 4.1]), 'touching', near=near))

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
        for answer in ({'verdict': 'disjoint', 'direction': (1, 0, 0), 'distance': [1, 1]},
                       {'verdict': 'intersecting', 'points': [(3, 0, 0), (4, 0, 0)], 'clearance': 1}):
            self.assertIsNone(exact.fault(apart, answer))
        self.assertIn('no verdict', exact.fault(apart, {'verdict': 'far'}))

    def test_a_tolerated_overlap(self):
        """An overlap of 1: the direction shows that it is not deeper than tolerated, until it is."""
        deep = {'a': UP, 'b': dict(UP, center=[5, 0, 0])}
        answer = {'verdict': 'disjoint', 'direction': [1, 0, 0], 'distance': [JUST, 1]}
        for tolerated, held in ((1 + JUST, True), (1, False), (1 - JUST, False)):
            self.assertEqual(exact.fault(deep, dict(answer, clearance=-tolerated)) is None, held, tolerated)
        self.assertIsNotNone(exact.fault(deep, dict(answer, direction=[0, 0, 1], clearance=-1.5)))

    def test_what_does_not_belong_to_the_verdict(self):
        deep, apart, touch = ({'a': UP, 'b': dict(UP, center=[x, 0, 0])} for x in (5, 7, 6))
        whole = {'disjoint': (apart, {'direction': [1, 0, 0]}), 'intersecting': (deep, {'point': [2.5, 0, 0]}),
                 'touching': (touch, {'point': [3, 0, 0]}), 'undecided': (touch, {})}
        others = {'direction': [1, 0, 0], 'point': [2.5, 0, 0], 'points': [[2.5, 0, 0], [2.5, 0, 0]],
                  'near': {'point': [3, 0, 0], 'direction': [1, 0, 0]}}
        for verdict, (asked, proof) in whole.items():
            self.assertIsNone(exact.fault(asked, dict(proof, verdict=verdict)), verdict)
            for part in others.keys() - proof.keys():
                stated = dict(proof, verdict=verdict) | {part: others[part]}
                self.assertIn('does not belong', str(exact.fault(asked, stated)), (verdict, part))
        self.assertEqual(exact.fault(apart, {'verdict': 'disjoint', 'direction': [1, 0, 0], 'hulls': ['line', 'space']}),
                         'hulls without a point')

    def test_touching(self):
        """Parts of two solids in contact, and the same pairs a little deeper."""
        coin = {'center': [0, 0, 0], 'axis': [0, 0, 1], 'radius': 2, 'height': 0}
        rod = {'center': [0, 0, 5], 'axis': [0, 0, 1], 'radius': 0, 'height': 4}
        contacts = [({'a': UP, 'b': dict(UP, center=[6, 0, z])}, (3, 0, z / 2)) for z in (0, 1, 8)]  # side, side and rim
        contacts += [({'a': UP, 'b': dict(UP, center=[x, 0, 8])}, (x / 2, 0, 4)) for x in (0, 1, 6)]  # caps, rims
        contacts += [({'a': UP, 'b': dict(UP, center=[6, 0, 0], axis=[0, 1, 0])}, (3, 0, 0)),  # crossed sides
                     ({'a': UP, 'b': dict(UP, center=[7, 0, 0], axis=[1, 0, 0])}, (3, 0, 0)),  # cap on a side
                     ({'a': UP, 'b': dict(UP, center=[0, 0, 7], axis=[1, 0, 0])}, (0, 0, 4)),  # side on a cap
                     ({'a': UP, 'b': dict(rod, center=[3, 0, 0])}, (3, 0, 1)), ({'a': UP, 'b': dict(rod, center=[0, 0, 6])}, (0, 0, 4)),
                     ({'a': coin, 'b': rod | {'center': [1, 0, 2]}}, (1, 0, 0)),
                     ({'a': coin, 'b': dict(coin, center=[4, 0, 0], axis=[0, 1, 1])}, (2, 0, 0)),
                     (pair(UP, [3, 0, 4]), (3, 0, 4)), (pair(coin, [1, 1, 0]), (1, 1, 0))]
        for asked, point in contacts:
            answer = {'verdict': 'touching', 'point': list(point), 'distance': [0, 0]}
            self.assertIsNone(exact.fault(asked, answer), (asked, point))
            self.assertIsNotNone(exact.fault(asked, dict(answer, distance=[1, 2])))
            self.assertIsNotNone(exact.fault(asked, dict(answer, distance=[-2, -1])))
            deeper = dict(asked, a=dict(asked['a'], rounding=JUST))
            self.assertIsNotNone(exact.fault(deeper, answer), (asked, point))
        for x in (6, 6 - JUST):
            asked = {'a': dict(UP, rounding=1), 'b': dict(UP, center=[x + 1, 0, 0])}
            answer = {'verdict': 'touching', 'points': [[3, 0, 0], [x - 2, 0, 0]]}
            self.assertEqual(exact.fault(asked, answer) is None, x == 6)

    def test_forgeries(self):
        """Statements of each verdict that are false, or that the certificate does not prove."""
        apart, deep, touch = ({'a': UP, 'b': dict(UP, center=[x, 0, 0])} for x in (7, 5, 6))
        broken = [dict(apart, a=dict(UP, **change)) for change in
                  ({'radius': -1}, {'height': -1}, {'rounding': -1}, {'axis': [0, 0, 0]}, {'axis': [0, 1]},
                   {'center': [0, 0, float('nan')]}, {'center': [0, 0, float('inf')]}, {'radius': '3'},
                   {'height': None}, {'radius': True})] + [{'a': UP}]
        gap = {'verdict': 'disjoint', 'direction': [1, 0, 0]}
        meet = {'verdict': 'intersecting', 'point': [2.5, 0, 0]}
        contact = {'verdict': 'touching', 'point': [3, 0, 0]}
        forged = [(p, dict(gap, direction=d)) for p in (deep, touch) for d in
                  ([1, 0, 0], [-1, 0, 0], [0, 1, 0], [1, 1, 0], [0, 0, 0], [1, JUST, 0], [0, 0, 1])]
        forged += [(apart, dict(gap, **change)) for change in
                   ({'direction': [0, 0, 1]}, {'direction': [0, 0, 0]}, {'clearance': -100}, {'clearance': 1},
                    {'clearance': 'x'}, {'distance': [-1, 0]}, {'distance': [2, 1]}, {'distance': [0.25, 0.5]})]
        forged += [(apart, dict(meet, point=p)) for p in
                   ([2.5, 0, 0], [3, 0, 0], [3.5, 0, 0], [4, 0, 0], [0, 0, 0], [7, 0, 0], ['7/2', 0, 0], [[3, 0.5], 0, 0])]
        forged += [(deep, dict(meet, **change)) for change in
                   ({'distance': [1, 2]}, {'distance': [JUST, 1]}, {'distance': [0, -1]}, {'clearance': -1},
                    {'point': [0, 0, 0]}, {'point': [2.5, 0, 4.5]}, {'point': [2.5, 3, 0]}, {'point': [1.5, 0, 0]},
                    {'points': [[2.5, 0, 0], [2.75, 0, 0]]}, {'points': [[9, 0, 0], [9, 0, 0]]},
                    {'point': [2.5, 0, JUST + 4]})]
        forged += [(p, dict(contact, point=q)) for p in (deep, apart) for q in
                   ([2.5, 0, 0], [3, 0, 0], [2, 0, 0], [3.5, 0, 0], [4, 0, 0], [2.5, 0, 4], [3, 0, 4], [2.5, 1, 0])]
        forged += [(deep, dict(contact, point=[2.5, 0, 0], **change)) for change in
                   ({'distance': [0, 0]}, {'distance': [-1, 0]}, {'distance': [7, 8]}, {'points': [[2, 0, 0], [2, 0, 0]]})]
        forged += [(touch, dict(contact, **change)) for change in
                   ({'distance': [JUST, 1]}, {'distance': [-1, -JUST]}, {'point': [3, JUST, 0]}, {'point': [0, 0, 0]},
                    {'clearance': 1}, {'near': {'point': [2.5, 0, 0], 'direction': [1, 0, 0]}})]
        forged += [(p, answer) for p in broken for answer in (gap, meet, contact)]
        forged += [(p, {'verdict': 'invalid', 'error': 'a.radius is negative'}) for p in (apart, deep, touch)]
        for asked, answer in forged:
            self.assertIsNotNone(exact.fault(asked, answer), (asked, answer))

    def test_what_is_malformed_fails_and_ends(self):
        apart = pair(UP, (4, 0, 0))
        for answer in (None, [1, 2], {'verdict': ['disjoint']}, {'verdict': 'disjoint', 'direction': ['1e99999999', 0, 0]}):
            with contextlib.redirect_stdout(io.StringIO()) as printed:
                self.assertEqual(exact.check([apart], [answer]), 2)
            self.assertIn('1 certificates fail', printed.getvalue())
        with contextlib.redirect_stdout(io.StringIO()) as printed:
            exact.check([apart], [{'verdict': 'disjoint', 'distance': [7, 8], 'clearance': -0.1}])
        self.assertIn('1 answers to a negative clearance have none', printed.getvalue())

    def test_files_of_strangers(self):
        """Each line is judged, none ends the others, and nothing that a stranger wrote reaches the terminal raw."""
        right = '{"verdict":"invalid","error":"a defect"}'
        odd = ['[1]', '{"a":1,"a":2}', '{' * 10, '[' * 100000, '{"a":{"radus":1},"b":{}}',
               '{"a":{"center":[0,0,0],"axis":[0,0,1],"radius":1%s,"height":1},"b":{}}' % ('0' * 400)]
        printed = io.StringIO()
        with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(printed):
            pairs, answers = pathlib.Path(folder, 'pairs'), pathlib.Path(folder, 'answers')
            pairs.write_text('\n'.join(odd))
            answers.write_text('\n'.join([right] * len(odd)))
            self.assertEqual(exact.check(exact.read(pairs), exact.read(answers)), 0)
            pairs.write_text('\n'.join(['{"a":1}'] * 3))
            answers.write_text('{"verdict":"\\u001b[31mred"}\n{"verdict":"\\ud800"}\n[')
            self.assertEqual(exact.check(exact.read(pairs), exact.read(answers)), 2)
        self.assertIn('3 certificates fail', printed.getvalue())
        self.assertTrue(printed.getvalue().isascii() and '\x1b' not in printed.getvalue())

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
