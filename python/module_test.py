# SPDX-License-Identifier: MIT
"""The Python module: shapes, verdicts, errors, the wheel, and the example of docs/library-use.md as it is printed."""
import contextlib
import io
import pathlib
import re
import subprocess
import sys
import tempfile
import threading
import unittest
import zipfile

import numpy as np

import daylight
from daylight import Verdict

HERE = pathlib.Path(__file__).resolve().parent
ROD = np.array([0, 0, 0, 0, 0, 1, 1, 4.0])


def beside(x):
    return np.array([x, 0, 0, 0, 0, 7, 1, 1.0])


class Module(unittest.TestCase):
    def test_one_pair(self):
        self.assertIs(daylight.check(ROD, beside(3)), Verdict.disjoint)
        self.assertIs(daylight.check(ROD, beside(1)), Verdict.intersecting)
        self.assertIs(daylight.check(ROD, beside(2)), Verdict.touching)
        self.assertIs(daylight.check(ROD, beside(np.nan)), Verdict.invalid)
        self.assertEqual([v.name for v in Verdict], ['disjoint', 'intersecting', 'touching', 'undecided', 'invalid'])

    def test_rounding(self):
        ball = np.array([3, 0, 0, 0, 0, 1, 0, 0, 1.5])
        self.assertIs(daylight.check(ROD, ball), Verdict.disjoint)
        self.assertAlmostEqual(daylight.distance(ROD, ball).value, 0.5)
        ball[8] = 2
        self.assertIs(daylight.check(ROD, ball), Verdict.touching)

    def test_distance(self):
        gap = daylight.distance(ROD, beside(3))
        self.assertIs(type(gap.value), float)
        self.assertAlmostEqual(gap.value, 1, delta=gap.error)
        self.assertLess(gap.error, 1e-13)
        np.testing.assert_allclose(beside(3)[:3] + gap.on_b - (ROD[:3] + gap.on_a), [1, 0, 0], atol=1e-13)
        self.assertAlmostEqual(daylight.distance(ROD, beside(1)).value, -1, delta=1e-13)
        self.assertEqual(daylight.distance(ROD, beside(np.nan)).direction.tolist(), [0, 0, 0])

    def test_arrays_say_what_pairs_say(self):
        numbers = np.random.default_rng(20261121)
        for n in (0, 1, 200):
            a, b = numbers.normal(size=(2, n, 8))
            a[:, 6:] **= 2
            b[:, 6:] **= 2
            verdicts = daylight.check(a, b)
            self.assertEqual((verdicts.shape, verdicts.dtype), ((n,), np.int8))
            self.assertEqual(list(verdicts), [daylight.check(x, y) for x, y in zip(a, b)])
            found = daylight.distance(a, b)
            self.assertEqual((found.value.shape, found.on_a.shape), ((n,), (n, 3)))
            self.assertEqual(list(found.value), [daylight.distance(x, y).value for x, y in zip(a, b)])
            self.assertEqual(list(daylight.check(ROD, b)), [daylight.check(ROD, y) for y in b])
        self.assertEqual(len(set(verdicts)), 2)

    def test_layouts(self):
        grid = np.zeros((2, 3, 8)) + beside(3)
        grid[1, 2, 0] = 1
        self.assertEqual(daylight.check(grid, ROD).tolist(), [[0, 0, 0], [0, 0, 1]])
        self.assertEqual(daylight.distance(grid, grid).direction.shape, (2, 3, 3))
        self.assertEqual(daylight.check(np.asfortranarray(grid), ROD).tolist(), [[0, 0, 0], [0, 0, 1]])
        self.assertEqual(daylight.check(grid[::-1, ::2], ROD).tolist(), [[0, 1], [0, 0]])
        self.assertEqual(daylight.check([0, 0, 0, 0, 0, 1, 1, 4], beside(1).astype(np.float32)), Verdict.intersecting)

    def test_errors(self):
        for function in (daylight.check, daylight.distance):
            with self.assertRaisesRegex(ValueError, r'^b has shape \(3, 7\), not \(.., 8\) or'):
                function(ROD, np.zeros((3, 7)))
            with self.assertRaisesRegex(ValueError, r'^a has shape \(\), not'):
                function(np.float64(1), ROD)
            with self.assertRaisesRegex(ValueError, r'^a has shape \(2, 8\) and b \(3, 8\): they must be as many'):
                function(np.zeros((2, 8)), np.zeros((3, 8)))
            for wrong in ('rod', ROD + 1j, object(), [ROD, None]):
                with self.assertRaisesRegex(ValueError, '^a is not an array of float64'):
                    function(wrong, ROD)

    def test_solids_by_name(self):
        rod = {'center': [0, 0, 0], 'axis': [0, 0, 1], 'radius': 1, 'height': 4.0}
        pill = {'shape': 'capsule', 'center': np.array([3, 0, 0]), 'quaternion': [1, 0, 0, 0], 'radius': 2, 'height': np.int64(1)}
        floor = {'shape': 'half_space', 'point': [0, 0, -2], 'normal': [0, 0, np.float64(7)]}
        self.assertIs(daylight.check(rod, pill), Verdict.touching)
        self.assertIs(daylight.check(floor, ROD), Verdict.touching)
        self.assertIs(daylight.check(beside(np.nan), floor), Verdict.invalid)
        stack = np.stack([beside(3)] * 3)
        stack[:, 2] = [-1, -1.5, -2]
        self.assertEqual(daylight.check(stack, floor).tolist(), [0, 2, 1])
        found = daylight.distance(floor, stack)
        np.testing.assert_allclose(found.value, [0.5, 0, -0.5], atol=1e-12)
        self.assertLess(found.error.max(), 1e-12)
        np.testing.assert_allclose(found.direction, [[0, 0, 1]] * 3, atol=1e-15)
        np.testing.assert_allclose((stack[:, :3] + found.on_b)[:, 2], [-1.5, -2, -2.5], atol=1e-12)
        np.testing.assert_allclose(found.on_a[:, 2], 0, atol=1e-12)
        self.assertEqual(daylight.distance(rod, pill).value, daylight.distance(ROD, [3, 0, 0, 0, 0, 1, 0, 1, 2.0]).value)

    def test_boxes(self):
        box = {'shape': 'box', 'center': np.array([3, 0, 0]), 'edges': [2, 4, np.float64(6)], 'quaternion': [3, 3, 3, 3]}
        self.assertIs(daylight.check(box, {**box, 'center': [9, 0, 0]}), Verdict.touching)
        self.assertIs(daylight.check(box, {**box, 'center': [9.1, 0, 0]}), Verdict.disjoint)
        self.assertIs(daylight.check({**box, 'rounding': 0.5}, {**box, 'center': [9.1, 0, 0]}), Verdict.intersecting)
        self.assertIs(daylight.check(beside(-1), box), Verdict.touching)
        rods = np.stack([beside(-2), beside(-1), beside(0)])
        self.assertEqual(daylight.check(rods, box).tolist(), [0, 2, 1])
        found = daylight.distance(rods, box)
        np.testing.assert_allclose(found.value, [1, 0, -1], atol=1e-12)
        self.assertLess(found.error.max(), 1e-12)
        np.testing.assert_allclose(found.direction, [[1, 0, 0]] * 3, atol=1e-12)
        np.testing.assert_allclose((box['center'] + found.on_b)[:, 0], 0, atol=1e-12)

    def test_errors_of_solids_by_name(self):
        ball = {'shape': 'sphere', 'center': [0, 0, 0], 'radius': 1}
        floor = {'shape': 'half_space', 'point': [0, 0, 0], 'normal': [0, 0, 1]}
        for function in (daylight.check, daylight.distance):
            for a, b, error in ((ball, {**ball, 'radius': -1}, r'^b.radius is negative \(-1\)$'),
                                ({**ball, 'shape': 'cone'}, ROD, '^a.shape is "cone", expected cylinder, capsule, sphere, half_space or box$'),
                                (ROD, {**ball, 'center': [0, np.nan, 0]}, r'^b.center\[1\] is NaN, expected a number$'),
                                ({**floor, 'radius': 1}, ROD, '^a.radius is given, but a half_space has point and normal$'),
                                ({'shape': 'box', 'center': [0, 0, 0], 'edges': [1, 2, -3]}, ROD, '^a.edges'),
                                (floor, floor, '^a and b are both half-spaces$'),
                                ({**ball, 'radius': object()}, ROD, '^a has a value that is neither'),
                                (ball, [1, 2], r'^b has shape \(2,\), not')):
                with self.assertRaisesRegex(ValueError, error):
                    function(a, b)

    def test_threads(self):
        a = np.tile(ROD, (20000, 1))
        results = [None] * 4

        def run(i):
            results[i] = daylight.check(a, beside(1.5 + i))
        threads = [threading.Thread(target=run, args=(i,)) for i in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual([set(r.tolist()) for r in results], [{1}, {0}, {0}, {0}])


class Files(unittest.TestCase):
    def test_wheel(self):
        with tempfile.TemporaryDirectory() as folder:
            made = subprocess.run([sys.executable, HERE / 'wheel.py', daylight.__file__, '1.2.3', folder], check=True,
                                  capture_output=True, text=True).stdout.strip()
            zipfile.ZipFile(made).extractall(folder)
            said = subprocess.run([sys.executable, '-c', 'import daylight; print(daylight.__file__)'], check=True,
                                  capture_output=True, text=True, cwd=folder, env={'PYTHONPATH': folder}).stdout
            self.assertTrue(said.startswith(folder))
            self.assertIn('Version: 1.2.3', pathlib.Path(folder, 'daylight-1.2.3.dist-info', 'METADATA').read_text())

    def test_example(self):
        text = (HERE.parent / 'docs' / 'library-use.md').read_text()
        example, = re.findall(r'^```python file=example\.py\n(.*?)^```', text, re.M | re.S)
        expected, = re.findall(r'^```text file=example\.out\n(.*?)^```', text, re.M | re.S)
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            exec(compile(example, 'example.py', 'exec'), {'__name__': '__main__'})
        self.assertEqual(printed.getvalue(), expected)


unittest.main()
