#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Tests how untaken_branches.py reads what llvm-cov says, and the arguments in the sources."""
import sys
import unittest

sys.dont_write_bytecode = True
from untaken_branches import arguments_for, branches_of, folded

SOURCE = '''\
int sign(int x) {
  if (x > 0 || x < -1) return 1;
  // not covered: x is
  // no zero
  if (x == 0)
    return 0;
  switch (x) {
    case 1: return 1;
    case 2: return 2;
  }
}
// not covered within: no pair asks
int unasked(int x) {
  return x ? 1 : 2;
}
constexpr int two() { return 2; }
'''.split('\n')


def function(name, place, count, branches):
    return {'name': name, 'filenames': [name], 'count': count, 'regions': [[*place, count, 0, 0, 0]],
            'branches': [[*b, 0, 0, 4] for b in branches]}


class UntakenBranches(unittest.TestCase):
    def setUp(self):
        sign = (1, 17, 11, 2)
        conditions = [(2, 7, 2, 12), (2, 16, 2, 22), (5, 7, 5, 13), (7, 11, 7, 12), (8, 5, 8, 11), (9, 5, 9, 11)]
        counts = [[(3, 0), (0, 0), (0, 0), (0, 0), (0, 0), (0, 0)], [(0, 2), (0, 2), (0, 2), (0, 2), (0, 2), (2, 0)]]
        instances = [function('/source/solver/sign.hpp', sign, 1, [(*c, *n) for c, n in zip(conditions, instance)])
                     for instance in counts]
        unasked = function('/source/solver/sign.hpp', (13, 20, 15, 2), 0, [(14, 10, 14, 11, 0, 0)])
        two = function('/source/solver/sign.hpp', (16, 21, 16, 34), 0, [])
        others = function('/usr/include/vector', (1, 1, 2, 2), 0, [(2, 7, 2, 12, 0, 1)])
        self.files = folded([*instances, unasked, two, others], '/source')
        self.count, self.untaken = branches_of(SOURCE, *self.files['solver/sign.hpp'])

    def test_instances_add_up_and_only_ours_count(self):
        self.assertEqual(list(self.files), ['solver/sign.hpp'])
        # Two functions, three conditions and that of unasked(), two cases.
        self.assertEqual(self.count, 2 + 2 * 4 + 2)

    def test_lists_what_is_not_taken_and_not_what_is_behind_it(self):
        self.assertEqual([(b.line, b.what, b.text) for b in self.untaken],
                         [(2, 'never true', 'x < -1'), (5, 'never true', 'x == 0'), (8, 'never', 'case 1'),
                          (13, 'never called', 'int unasked(int x) {')])

    def test_an_argument_holds_for_its_statement_or_function(self):
        self.assertEqual(list(arguments_for(SOURCE, self.files['solver/sign.hpp'][0], self.untaken)), [0, 3, 0, 12])


if __name__ == '__main__':
    unittest.main()
