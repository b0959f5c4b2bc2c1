#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The algorithms of docs/algorithms.md as they stand there, against the program given as the first argument: on 10,000
pairs each says what its C++ says, but nearer to touching than a billionth of the size. And what section 7 of the text
of 2017 says of convexity, in fractions."""
import fractions
import itertools
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE / 'algorithms'))
sys.dont_write_bytecode = True

import slices  # noqa: E402
import solids  # noqa: E402
import text_2008  # noqa: E402
import text_2017  # noqa: E402

PROGRAM = sys.argv.pop(1)
FAMILIES = ('random axes_nearly_parallel axes_perpendicular disks needles needle_and_disk segments flat_disks points '
            'coaxial mixed_scale lattice raw_axes touching_rim_rim touching_side_rim touching_cap_rim touching_disks '
            'coins_edge_to_edge close_contacts close_rims').split()
PAIRS_EACH = 500
MARGIN = 1e-9  # of the size: rounding in so different orders is far below


def run(*arguments):
    return subprocess.run([PROGRAM, *arguments], stdout=subprocess.PIPE, text=True, check=False).stdout.splitlines()


def size(pair):
    delta = [y - x for x, y in zip(pair['a']['center'], pair['b']['center'])]
    return max([solids.length(delta)] + [s[k] for s in (pair['a'], pair['b']) for k in ('radius', 'height')])


class Algorithms(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.lines = [line for name in FAMILIES for line in run('families', name, '--count', str(PAIRS_EACH))]
        cls.pairs = [json.loads(line) for line in cls.lines]
        cls.solids = [[solids.solid(*(pair[k][x] for x in ('center', 'axis', 'radius', 'height'))) for k in 'ab']
                      for pair in cls.pairs]
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)

    def ask(self, lines, *arguments):
        file = pathlib.Path(self.folder.name) / 'pairs.jsonl'
        file.write_text('\n'.join(lines) + '\n')
        return [json.loads(line) for line in run('check', str(file), *arguments)]

    def check(self, disjoint, method, step=1):
        """Of every step-th pair."""
        self.assertEqual(len(self.pairs), 10000)
        said = ['disjoint' if disjoint(a, b) else 'intersecting' for a, b in self.solids[::step]]
        answers = [answer['verdict'] for answer in self.ask(self.lines[::step], '--method', method)]
        self.assertEqual(len(answers), len(said))
        self.assertGreater(said.count('disjoint'), 2000 // step)
        self.assertGreater(said.count('intersecting'), 2000 // step)
        differ = [i for i, (x, y) in enumerate(zip(said, answers)) if x != y]
        if not differ:
            return
        margins = self.ask([self.lines[i * step] for i in differ], '--distance')
        for i, truth in zip(differ, margins):
            low, high = (float(x) for x in truth.get('distance', [0, 0]))
            margin = max(low, -high)  # what is proved of it
            self.assertLess(margin, MARGIN * size(self.pairs[i * step]),
                            f'{method} {answers[i]}, {truth["verdict"]}: {self.lines[i * step]}')
        self.assertLess(len(differ), 300)

    def test_slices(self):
        self.check(slices.disjoint, 'intersect')

    def test_text_2017(self):
        self.check(text_2017.disjoint, 'seed2017-cg-steps-64')

    def test_text_2008(self):
        self.check(text_2008.disjoint, 'seed2008-projection-polish16')

    def test_text_2008_by_the_polynomial(self):
        self.check(lambda a, b: text_2008.disjoint(a, b, text_2008.by_polynomial), 'seed2008-polynomial-polish16', 10)

    def test_obtuse_axes(self):
        """rho as the document has it, with its c: with the cosine itself these would be apart."""
        text = ' '.join((HERE / 'algorithms.md').read_text().split())
        for said in ('the radius r_i and the height h_i.', 's = |W_0 x W_1| and c = |W_0.W_1|',
                     'r_1^2 s^2 < rho^2, with rho = |W_0.Delta| - h_0/2 - (h_1/2) c.'):
            self.assertTrue(said in text, said)
        line = ('{"a":{"center":[0,0,0],"axis":[0,0,1],"radius":1,"height":2},'
                '"b":{"center":[0,0,1.2],"axis":[0,7,-4],"radius":0.1,"height":2}}')
        self.assertEqual(self.ask([line], '--method', 'intersect')[0]['verdict'], 'intersecting')
        a, b = (solids.solid(*json.loads(line)[k].values()) for k in 'ab')
        cosine = solids.dot(a.w, b.w)
        self.assertLess(cosine, 0)
        for c, apart in ((abs(cosine), False), (cosine, True)):
            rho = abs(solids.dot(a.w, solids.sub(b.c, a.c))) - a.half - b.half * c
            self.assertEqual(rho > 0 and b.r ** 2 * (1 - c * c) < rho ** 2, apart)


def directions():
    """Unit vectors in fractions, from Pythagorean quadruples."""
    for quadruple in ((1, 2, 2, 3), (2, 3, 6, 7), (1, 4, 8, 9), (4, 4, 7, 9), (2, 6, 9, 11), (0, 3, 4, 5)):
        for numbers in itertools.permutations(quadruple[:3]):
            for signs in itertools.product((1, -1), repeat=3):
                yield tuple(fractions.Fraction(s * x, quadruple[3]) for s, x in zip(signs, numbers))


class Section13(unittest.TestCase):
    def test_below_by_squares(self):
        for x, y in itertools.product([fractions.Fraction(k, 7) for k in range(9)], repeat=2):
            self.assertEqual(text_2008.below_by_squares(x * x, y * y, 1), x + y < 1)


class Convexity(unittest.TestCase):
    """eta = sqrt(Q) with Q = |D|^2 - (D.W)^2, D = (s, t, 1 - s - t), W = (a, b, c). The numbers 2 Q Q_ss - Q_s^2 and so
    on are 4 Q^(3/2) eta_ss and so on."""

    @staticmethod
    def seconds(w, s, t):
        a, b, c = w
        u = 1 - s - t
        along = a * s + b * t + c * u
        q = s * s + t * t + u * u - along * along
        qs, qt = 2 * s - 2 * u - 2 * (a - c) * along, 2 * t - 2 * u - 2 * (b - c) * along
        qss, qst, qtt = 4 - 2 * (a - c) ** 2, 2 - 2 * (a - c) * (b - c), 4 - 2 * (b - c) ** 2
        return q, 2 * q * qss - qs * qs, 2 * q * qst - qs * qt, 2 * q * qtt - qt * qt

    def test_identities(self):
        axes = list(directions())[::7]
        points = [(fractions.Fraction(i, 7), fractions.Fraction(j, 11)) for i in range(5) for j in range(4)]
        checked = 0
        for (a, b), (s, t) in itertools.product(itertools.product(axes[:9], axes[9:18]), points):
            _, ss0, st0, tt0 = self.seconds(a, s, t)
            _, ss1, st1, tt1 = self.seconds(b, s, t)
            self.assertEqual(ss0, 4 * (sum(a) * t - a[1]) ** 2)
            self.assertEqual(tt0, 4 * (sum(a) * s - a[0]) ** 2)
            self.assertEqual(ss0 * tt0 - st0 * st0, 0)
            normal = solids.cross(a, b)
            along = normal[0] * s + normal[1] * t + normal[2] * (1 - s - t)
            self.assertEqual(ss0 * tt1 + ss1 * tt0 - 2 * st0 * st1, 16 * along ** 2)
            checked += 1
        self.assertGreater(checked, 1000)

    def test_of_no_unit_axis(self):
        """The determinant is 16 (1 - |W|^2) times -Q: the factor 16 that the text leaves out, and its polynomial p."""
        for w in ((fractions.Fraction(3, 10), fractions.Fraction(2, 5), fractions.Fraction(1, 2)), (1, 2, 3)):
            q, ss, st, tt = self.seconds(w, fractions.Fraction(1, 5), fractions.Fraction(3, 10))
            self.assertEqual(ss * tt - st * st, -16 * q * (sum(x * x for x in w) - 1))


if __name__ == '__main__':
    unittest.main()
