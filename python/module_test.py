# SPDX-License-Identifier: MIT
"""The Python module: shapes, verdicts, errors, campaigns, and the example of docs/library-use.md as it is printed."""
import ast
import contextlib
import io
import pathlib
import pydoc
import re
import threading
import unittest

import numpy as np

import daylight
from daylight import Hull, Proof, Verdict

PAGE = pathlib.Path(__file__).resolve().parents[1] / 'docs' / 'library-use.md'
FUNCTIONS = ['campaign', 'decide', 'decide_exactly', 'distance', 'intersect', 'within']
ROD = np.array([0, 0, 0, 0, 0, 1, 1, 4.0])


def beside(x):
    return np.array([x, 0, 0, 0, 0, 7, 1, 1.0])


class Module(unittest.TestCase):
    def test_one_pair(self):
        self.assertIs(daylight.intersect(ROD, beside(3)), Verdict.disjoint)
        self.assertIs(daylight.intersect(ROD, beside(1)), Verdict.intersecting)
        self.assertIs(daylight.decide_exactly(ROD, beside(2)), Verdict.touching)
        self.assertIs(daylight.intersect(ROD, beside(np.nan)), Verdict.invalid)
        self.assertEqual([v.name for v in Verdict], ['disjoint', 'intersecting', 'touching', 'undecided', 'invalid'])

    def test_proofs(self):
        apart = daylight.decide(ROD, beside(3))
        self.assertIs(apart.verdict, Verdict.disjoint)
        self.assertGreater(apart.direction[0], 0)
        meet = daylight.decide(ROD, beside(1))
        self.assertIs(meet.verdict, Verdict.intersecting)
        x = meet.point_head + meet.point_tail
        self.assertTrue(np.hypot(x[0], x[1]) <= 1 and np.hypot(x[0] - 1, x[1]) <= 1 and abs(x[2]) <= 0.5)

    def test_hulls(self):
        self.assertEqual(daylight.decide(ROD, beside(1))[4:], (Hull.space, Hull.space, Proof.point))
        axis = np.array([0.1, 0.2, 0, 0.3, 0.4, 1, 0, 4])
        meet = daylight.decide(axis, ROD)
        self.assertEqual((meet.verdict, meet.hull_a, meet.hull_b), (Verdict.intersecting, Hull.line, Hull.space))
        self.assertIs(type(meet.hull_a), Hull)
        many = daylight.decide(np.array([axis, ROD]), ROD)
        self.assertEqual((many.hull_a.tolist(), many.hull_a.dtype), ([Hull.line, Hull.space], np.int8))

    def test_rounding(self):
        ball = np.array([3, 0, 0, 0, 0, 1, 0, 0, 1.5])
        self.assertIs(daylight.intersect(ROD, ball), Verdict.disjoint)
        self.assertIs(daylight.within(ROD, ball, 0.5), Verdict.intersecting)
        self.assertIs(daylight.within(ROD, ball, 0.4), Verdict.disjoint)
        self.assertIs(daylight.within(ROD, ball, -1), Verdict.invalid)
        self.assertAlmostEqual(daylight.distance(ROD, ball).value, 0.5)
        wide = ball.copy()
        wide[8] = 2.5
        meet = daylight.decide(ROD, wide)
        self.assertIs(meet.proof, Proof.points)
        self.assertLessEqual(np.linalg.norm(ball[:3] + meet.point_tail - ROD[:3] - meet.point_head), 2.5)
        self.assertEqual(daylight.intersect(ROD, np.array([ball, wide])).tolist(), [0, 1])
        self.assertIs(daylight.decide_exactly(ROD, np.array([3, 0, 0, 0, 0, 1, 0, 0, 2.0])), Verdict.touching)

    def test_distance(self):
        gap = daylight.distance(ROD, beside(3))
        self.assertAlmostEqual(gap.value, 1, delta=gap.error)
        self.assertLess(gap.error, 1e-13)
        np.testing.assert_allclose(beside(3)[:3] + gap.on_b - (ROD[:3] + gap.on_a), [1, 0, 0], atol=1e-13)
        self.assertIs(gap.verdict, Verdict.disjoint)
        self.assertAlmostEqual(daylight.distance(ROD, beside(1)).value, -1, delta=1e-13)

    def test_batches_say_what_pairs_say(self):
        numbers = np.random.default_rng(20261121)
        for n in (0, 1, 127, 128, 129, 1000):
            a, b = numbers.normal(size=(2, n, 8))
            a[:, 6:] **= 2
            b[:, 6:] **= 2
            verdicts = daylight.intersect(a, b)
            self.assertEqual((verdicts.shape, verdicts.dtype), ((n,), np.int8))
            self.assertEqual(list(verdicts), [daylight.intersect(x, y) for x, y in zip(a, b)])
            decided = daylight.decide(a, b)
            self.assertEqual(list(decided.verdict), list(daylight.decide_exactly(a, b)))
            found = daylight.distance(a, b)
            self.assertEqual((found.value.shape, found.on_a.shape), ((n,), (n, 3)))
            self.assertEqual(list(found.value), [daylight.distance(x, y).value for x, y in zip(a, b)])
            self.assertEqual(list(daylight.intersect(ROD, b)), [daylight.intersect(ROD, y) for y in b])
            self.assertEqual(list(daylight.intersect(b, ROD)), [daylight.intersect(y, ROD) for y in b])
        self.assertEqual(len(set(verdicts)), 2)

    def test_layouts(self):
        grid = np.zeros((2, 3, 8)) + beside(3)
        grid[1, 2, 0] = 1
        self.assertEqual(daylight.intersect(grid, ROD).tolist(), [[0, 0, 0], [0, 0, 1]])
        self.assertEqual(daylight.distance(grid, grid).direction.shape, (2, 3, 3))
        self.assertEqual(daylight.intersect(np.asfortranarray(grid), ROD).tolist(), [[0, 0, 0], [0, 0, 1]])
        self.assertEqual(daylight.intersect(grid[::-1, ::2], ROD).tolist(), [[0, 1], [0, 0]])
        self.assertEqual(daylight.intersect([0, 0, 0, 0, 0, 1, 1, 4], beside(1).astype(np.float32)), Verdict.intersecting)

    def test_errors(self):
        with self.assertRaisesRegex(ValueError, r'^b has shape \(3, 7\), not \(.., 8\) or'):
            daylight.intersect(ROD, np.zeros((3, 7)))
        with self.assertRaisesRegex(ValueError, r'^a has shape \(\), not'):
            daylight.distance(np.float64(1), ROD)
        with self.assertRaisesRegex(ValueError, r'^a has shape \(2, 8\) and b \(3, 8\): they must be as many'):
            daylight.decide(np.zeros((2, 8)), np.zeros((3, 8)))
        for wrong, dtype in (('rod', '<U3'), (ROD + 1j, 'complex128'), (object(), 'object'), ([ROD, None], None)):
            found = 'a has dtype ' + dtype if dtype else 'a is not an array'
            for function in (daylight.intersect, daylight.decide, daylight.decide_exactly, daylight.distance):
                with self.assertRaisesRegex(ValueError, f'^({found}), not float64 or a type that NumPy casts to it safely$'):
                    function(wrong, ROD)
        for claim in ({'relative': -1.0}, {'absolute': np.nan}, {'relative': np.inf}):
            with self.assertRaisesRegex(ValueError, '^a claim is finite and not negative: relative '):
                daylight.campaign(lambda a, b: None, **claim)
        with self.assertRaises(TypeError):
            daylight.campaign(lambda a, b: None, pairs=-1)

    def test_what_does_not_belong_is_zero(self):
        nothing = [0, 0, 0]
        for other, zeros in ((beside(3), 'point_head point_tail'), (beside(1), 'direction'),
                             (beside(2), 'direction point_head point_tail'), (beside(np.nan), 'direction point_head point_tail')):
            decision = daylight.decide(ROD, other)
            for field in zeros.split():
                self.assertEqual(getattr(decision, field).tolist(), nothing, (decision, field))
        gap = daylight.distance(ROD, beside(np.nan))
        self.assertIs(gap.verdict, Verdict.invalid)

    def test_threads(self):
        a = np.tile(ROD, (100000, 1))
        results = [None] * 4

        def run(i):
            results[i] = daylight.intersect(a, beside(1 + i))
        threads = [threading.Thread(target=run, args=(i,)) for i in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual([set(r.tolist()) for r in results], [{1}, {1}, {0}, {0}])


class Campaign(unittest.TestCase):
    def test_right_answers_pass(self):
        for right in (daylight.decide_exactly, lambda a, b: daylight.decide_exactly(a, b).name, lambda a, b: None):
            self.assertEqual(
                [f for f in daylight.campaign(right, pairs=400, seed=3) if f['kind'] != 'undecided_truth'], [])

    def test_wrong_answers_are_found(self):
        said_apart = daylight.campaign(lambda a, b: False, pairs=200, seed=3)
        self.assertEqual({f['kind'] for f in said_apart} - {'undecided_truth'}, {'wrong_disjoint'})
        said_together = daylight.campaign(lambda a, b: 'intersecting', pairs=200, seed=3)
        kinds = {f['kind'] for f in said_together}
        self.assertIn('wrong_intersecting', kinds)
        for f in said_together:
            if f['kind'] == 'wrong_intersecting':
                self.assertIs(daylight.decide_exactly(f['a'], f['b']), Verdict.disjoint)
                self.assertEqual((f['truth']['verdict'], f['said']['verdict']), ('disjoint', 'intersecting'))
                self.assertLessEqual(0, f['margin'][0])
        again = daylight.campaign(lambda a, b: 'intersecting', pairs=200, seed=3)
        self.assertEqual(repr(again), repr(said_together))
        self.assertNotEqual(repr(daylight.campaign(lambda a, b: 'intersecting', pairs=200, seed=4)), repr(again))
        claimed = daylight.campaign(lambda a, b: False, pairs=200, seed=3, relative=1e9)
        self.assertLessEqual({f['severity'] for f in claimed}, {'resolution', 'unresolved'})

    def test_distances_are_checked(self):
        def off(a, b):
            return daylight.decide_exactly(a, b), daylight.distance(a, b).value + 1e6
        self.assertIn('distance_outside', {f['kind'] for f in daylight.campaign(off, pairs=100, relative=1e-6)})

    def test_failures(self):
        def kinds(answer):
            return {f['kind'] for f in daylight.campaign(answer, pairs=30)}
        self.assertEqual(kinds(lambda a, b: 1 / 0), {'exception'})
        self.assertEqual(kinds(lambda a, b: 'maybe'), {'malformed'})
        self.assertEqual(kinds(lambda a, b: object()), {'malformed'})
        self.assertEqual(kinds(lambda a, b: 7), {'malformed'})
        self.assertEqual(kinds(lambda a, b: 10**30), {'malformed'})
        self.assertEqual(kinds(lambda a, b: (True, 'far')), {'malformed'})
        self.assertEqual(kinds(lambda a, b: np.bool_(True)), kinds(lambda a, b: True))

        def interrupted(a, b):
            raise KeyboardInterrupt
        with self.assertRaises(KeyboardInterrupt):
            daylight.campaign(interrupted)
        with self.assertRaises(TypeError):
            daylight.campaign('no callable')


class Documentation(unittest.TestCase):
    """help(daylight) tells of every function what comes back; the stub's signatures are the module's."""

    def test_help(self):
        text = pydoc.render_doc(daylight, renderer=pydoc.plaintext)
        for said in ('(.., 8)', 'lengths in one unit', 'raise ValueError'):
            self.assertIn(said, text)
        for name in FUNCTIONS:
            self.assertIn('\nReturns ', getattr(daylight, name).__doc__)
            self.assertLessEqual(max(map(len, getattr(daylight, name).__doc__.splitlines()[1:])), 84)

    def test_stub(self):
        stub = ast.parse(pathlib.Path(__file__).with_name('daylight.pyi').read_text()).body
        functions = {x.name: x.args for x in stub if isinstance(x, ast.FunctionDef)}
        self.assertEqual(sorted(functions), FUNCTIONS)
        for name, arguments in functions.items():
            signature = getattr(daylight, name).__doc__.splitlines()[0]
            self.assertEqual(re.findall(r'(\w+): ', signature), [x.arg for x in arguments.args])
            self.assertEqual(re.findall(r' = ([\d.]+)', signature), [ast.unparse(x) for x in arguments.defaults])
        for x in stub:
            if isinstance(x, ast.ClassDef):
                known = getattr(daylight, x.name)
                if known in (Verdict, Hull, Proof):
                    self.assertEqual({y.targets[0].id: y.value.value for y in x.body}, {v.name: v for v in known})
                else:
                    self.assertEqual([y.target.id for y in x.body], list(known._fields))
        self.assertEqual({x.name for x in stub if isinstance(x, (ast.ClassDef, ast.FunctionDef))},
                         {name for name in dir(daylight) if not name.startswith('_')})


class Readme(unittest.TestCase):
    def test_example(self):
        text = PAGE.read_text()
        example, = re.findall(r'^```python file=example\.py\n(.*?)^```', text, re.M | re.S)
        expected, = re.findall(r'^```text file=example\.out\n(.*?)^```', text, re.M | re.S)
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            exec(compile(example, 'example.py', 'exec'), {'__name__': '__main__'})
        self.assertEqual(printed.getvalue(), expected)


unittest.main()
