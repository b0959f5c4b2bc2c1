#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Tests whose fault compare.py finds, how it survives engines that end or hang, and that the pages say what their data
say."""
import json
import pathlib
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
import compare
import versions

CYLINDER = {'center': [0, 0, 0], 'axis': [0, 0, 1], 'radius': 2, 'height': 4}
PAIR = {'a': CYLINDER, 'b': CYLINDER}
ENDS_AT_THE_SECOND = '''
import sys
print('{"name":"fake"}', flush=True)
for number, line in enumerate(sys.stdin):
    if '"radius": 7' in line: sys.exit(1)
    print('{"verdict":"disjoint"}', flush=True)
'''
REPLAYS = '''#!/bin/sh
echo '  m    {"verdict":"disjoint"}  <- wrong_disjoint'
echo '  m-0  {"verdict":"intersecting"}'
'''


class Compare(unittest.TestCase):
    def fault(self, answer, true, own=None):
        return compare.fault_of(answer, [true, true], [own or true] * 2, 1e-3)

    def test_blames_the_algorithm_only_beyond_its_own_solid(self):
        self.assertEqual(self.fault({'verdict': 'disjoint'}, -0.1, 0.05), ('disjoint', 'model'))
        self.assertEqual(self.fault({'verdict': 'disjoint'}, -0.1, -0.05), ('disjoint', 'algorithm'))
        self.assertEqual(self.fault({'verdict': 'intersecting'}, 0.1, 0.2), ('intersecting', 'algorithm'))
        self.assertIsNone(self.fault({'verdict': 'intersecting'}, 0.0005))
        self.assertIsNone(self.fault({'verdict': 'disjoint'}, -0.0005))

    def test_distances_lie_between_those_of_both_solids(self):
        def said(distance):
            return self.fault({'verdict': 'disjoint', 'distance': distance}, 0.1, 0.2)
        self.assertEqual(said(0.05), ('distance', 'algorithm'))
        self.assertEqual(said(0.15), ('distance', 'model'))
        self.assertEqual(said(0.25), ('distance', 'algorithm'))
        self.assertIsNone(said(0.1))

    def test_inner_solids(self):
        inner = compare.inner_solid(CYLINDER, {'radius': 0.5, 'rims': 0.25})
        self.assertEqual((inner['radius'], inner['height'], inner['rounding']), (0.75, 3.5, 0.25))
        ball = dict(CYLINDER, radius=0, height=0, rounding=1)
        self.assertEqual(compare.inner_solid(ball, {'radius': 0.5}), ball)

    def test_an_engine_that_ends_loses_one_pair(self):
        with tempfile.NamedTemporaryFile('w', suffix='.py') as file:
            file.write(ENDS_AT_THE_SECOND)
            file.flush()
            other = {'a': dict(CYLINDER, radius=7), 'b': CYLINDER}
            _, answers = compare.ask([sys.executable, file.name], [PAIR, other, PAIR], '.')
        self.assertEqual(answers, [{'verdict': 'disjoint'}, {'crash': True}, {'verdict': 'disjoint'}])

    def test_states_one_cause_only_if_all_counts_agree(self):
        def words(both, left):
            return compare.shared_in_words({'package': 'x 1', 'shared': {'wrong': 9, 'methods': {'m': both, 'n': left}}})
        self.assertIn('one cause', words(9, 0))
        for both, left in ((8, 0), (9, 1)):
            self.assertNotIn('one cause', words(both, left))

    def test_counts_the_wrong_verdicts_that_packaged_methods_share(self):
        with tempfile.TemporaryDirectory() as folder:
            program = pathlib.Path(folder, 'daylight')
            program.write_text(REPLAYS)
            program.chmod(0o700)
            said = {'verdict': 'disjoint'}
            judged = [(PAIR, {}, {}, said, ('disjoint', 'model')), (PAIR, {}, {}, said, None)]
            self.assertEqual(compare.shared(program, ('m', 'm-0'), judged), {'wrong': 1, 'methods': {'m': 1, 'm-0': 0}})

    def test_pages_say_what_their_data_say(self):
        engines = [json.loads(line) for line in (compare.RESULTS / 'engines.jsonl').read_text().splitlines()]
        self.assertEqual(compare.page(engines), (compare.RESULTS / 'engines.md').read_text())
        self.assertEqual(versions.page(versions.read(compare.RESULTS / 'versions.jsonl'), 'versions.jsonl'),
                         (compare.RESULTS / 'versions.md').read_text())
        for row in engines:
            self.assertGreaterEqual(row['answered'], 20000)
            if row['worst']:
                self.assertEqual(compare.picture_of(row), (compare.RESULTS / f'engines/{row["name"]}.svg').read_text())


class Versions(unittest.TestCase):
    def test_turns(self):
        rows = [{'version': str(i), 'wrong': {'x': 1} if i in (2, 3) else {}} for i in range(6)]
        rows[4]['date'] = '2025-01-31'
        self.assertEqual(versions.turns(rows, 'x'), ('1', '2', '4 (2025-01-31)'))
        self.assertEqual(versions.turns(rows[2:4], 'x'), ('-', '2', '-'))

    def test_range(self):
        every, tags = ['1.0.0-beta.1', '0.2.0', '0.10.1', '0.9.3', '0.9.0'], {'latest': '0.10.1'}
        found = lambda first, last: versions.in_range(every, 'x', tags, first, last)
        self.assertEqual(found('', 'latest'), ['0.2.0', '0.9.0', '0.9.3', '0.10.1'])
        self.assertEqual(found('0.3', '0.9'), ['0.9.0', '0.9.3'])

    def test_what_counts_as_extreme_and_as_an_answer(self):
        far = dict(CYLINDER, center=[0, 101, 0])
        self.assertEqual([versions.is_ordinary({'a': CYLINDER, 'b': b}) for b in (CYLINDER, far)], [True, False])
        self.assertEqual(versions.answer_of({'verdict': 'touching'}), {'verdict': 'intersecting'})
        self.assertIn('declined', versions.answer_of({'verdict': 'undecided', 'error': 'x declined: no disks'}))
        self.assertIn('error', versions.answer_of({'verdict': 'undecided', 'error': 'x failed: crash'}))

    def test_a_page_compares_answers_to_the_same_pairs(self):
        rows = [{'package': 'x', 'version': v, 'pairs': pairs, 'guest': 'g', 'drawn': 7, 'answered': 9, 'wrong': {},
                 'verdicts': 'same'} for v, pairs in (('1.0', 'old'), ('1.2', 'new'), ('1.1', 'new'))]
        self.assertIn('--from 1.1 --to 1.2 --pairs 7\n\n## x\n\n2 versions answered', versions.page(rows, 'data'))

    def test_a_mirror_states_no_release_dates(self):
        times = {'1.0.0': '2025-01-31T12:00:00.000Z'}
        self.assertEqual(versions.dates_of(times), {})
        self.assertEqual(versions.dates_of(times | {'created': '2025-01-30'})['1.0.0'], '2025-01-31')


if __name__ == '__main__':
    unittest.main()
