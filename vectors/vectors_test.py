# SPDX-License-Identifier: MIT
"""vectors_test.py DAYLIGHT: the exact checker proves the vectors, and `daylight vectors` writes those of v2 again. The
lint, the runner and the plug-in of pytest notice what is planted."""
import copy
import hashlib
import json
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
import daylight_vectors  # noqa: E402
import exact  # noqa: E402
import lint  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent
PROGRAM = pathlib.Path(sys.argv.pop(1)).resolve()
SMOKE = daylight_vectors.load('smoke')
MINE = '''
import json, os, pathlib, sys
KNOWN = json.loads(pathlib.Path(%r).read_text())['vectors']
def right(a, b):
    for v in KNOWN:
        if all([*map(float, [*v[k]['center'], *v[k]['axis'], v[k]['radius'], v[k]['height'], v[k].get('rounding', 0)])]
               == [*s['center'], *s['axis'], s['radius'], s['height'], s['rounding']] for k, s in (('a', a), ('b', b))):
            return v['result'] != 'disjoint' if v['result'] != 'invalid' else 'invalid'
    raise ValueError('not a number')
def blind(a, b):
    return right(a, b) is True and not a['rounding'] > 0
def unable(a, b):
    print('not an answer')
def loop():
    while True: pass
FAULTS = [loop, lambda: os._exit(3), lambda: sys.exit('no idea'), lambda: 1 / 0, lambda: [1], lambda: int('x')]
def broken(a, b):
    number = int(os.environ['FAULT'])
    if a['rounding'] > 0 and not os.path.exists(f'broke{number}'):
        open(f'broke{number}', 'w').close()
        return FAULTS[number]()
'''


def python_with_pytest():
    """A Python that has it: this one, or Debian's, for which the package is."""
    for python in (sys.executable, '/usr/bin/python3'):
        if subprocess.run([python, '-c', 'import pytest'], capture_output=True).returncode == 0:
            return python
    if os.environ.get('CI') == 'true':
        raise AssertionError('with CI=true nothing may be skipped: no pytest')
    raise unittest.SkipTest('no pytest: apt-get install python3-pytest')


def written(*arguments):
    return subprocess.run([PROGRAM, 'vectors', *arguments], stdout=subprocess.PIPE, text=True, check=True).stdout


class Version2(unittest.TestCase):
    def test_what_is_committed(self):
        self.assertEqual(written(), (daylight_vectors.V2 / 'vectors.jsonl').read_text())
        documents = [daylight_vectors.load('v2'), daylight_vectors.load(self.file('--count', '300', '--seed', '7'))]
        vectors = documents[0]['vectors']
        self.assertEqual(len({v['id'] for v in vectors}), 500)
        self.assertEqual([line for document in documents for line in lint.lint(document['vectors'])], [])
        for v in vectors + documents[1]['vectors']:
            self.assertEqual(v['truth'], v['answer']['verdict'])
            low, high, size = *v['distance'], float(exact.size(v))
            self.assertAlmostEqual(v['margin'], max(low, -high, 0) / size if size else low > 0)
        self.assertEqual({f for v in vectors for f in v['flags']}, set(daylight_vectors.known_flags()) - {'Invalid'})
        shapes = {tuple(sorted(v[k].get('shape', 'cylinder') for k in 'ab')) for v in vectors}
        self.assertEqual(len(shapes), 5)  # without two half-spaces
        for word in ('disjoint', 'intersecting'):
            self.assertGreater(sum(v['truth'] == word for v in vectors), 150)
        wrong = dict(next(v for v in vectors if v['truth'] == 'disjoint'), a=vectors[0]['b'], b=vectors[0]['b'])
        self.assertEqual(len(list(lint.lint([*vectors[:9], wrong]))), 1)
        self.assertEqual(daylight_vectors.judge(vectors[0], vectors[0]['truth']), 'right')
        self.assertEqual(daylight_vectors.solid_of({'shape': 'box', 'edges': [1, 0, 2]}),
                         {'shape': 'box', 'edges': [1.0, 0.0, 2.0], 'rounding': 0.0})

    def file(self, *arguments):
        with tempfile.NamedTemporaryFile('w', suffix='.jsonl', delete=False) as file:
            file.write(written(*arguments))
        self.addCleanup(os.unlink, file.name)
        return file.name

    def test_the_header(self):
        header = written('--header')
        self.assertEqual(re.findall(r'"(v2-\w+)"', header), [v['id'] for v in daylight_vectors.load('v2')['vectors']])
        subprocess.run(['cc', '-xc', '-Wall', '-Wno-unused', '-Werror', '-fsyntax-only', '-'], input=header, text=True,
                       check=True)


class Version1(unittest.TestCase):
    def test_what_is_committed(self):
        """The files never change, and the checker proves them."""
        digest = hashlib.sha256(b''.join(path.read_bytes() for path in sorted(daylight_vectors.FOLDER.iterdir())))
        self.assertEqual(digest.hexdigest(), 'd011ce2abfdafb837e0d2607d16e02d9d1672d4f5a7ebf48483d150d59251c42')
        self.assertEqual(list(lint.lint(daylight_vectors.load('standard')['vectors'])), [])
        page = (HERE.parent / 'docs/vectors.md').read_text()
        self.assertEqual(set(re.findall(r'^\| `([A-Z]\w+)` \|', page, re.M)), set(daylight_vectors.known_flags()))

    def test_what_is_planted(self):
        def put(*path):
            def change(v):
                for key in path[:-2]:
                    v = v[key]
                v[path[-2]] = path[-1](v[path[-2]]) if callable(path[-1]) else path[-1]
            return change
        for change, result, why in (
                (put('result', 'intersecting'), 'disjoint', 'no certificate'),
                (put('result', 'disjoint'), 'intersecting', 'does not belong'),
                (put('result', 'touching'), 'intersecting', 'they overlap at this point'),
                (put('result', 'invalid'), 'disjoint', 'the pair is valid'),
                (put('result', 'far'), 'disjoint', 'no verdict'),
                (put('certificate', 'direction', 0, lambda x: x + 1e-4), 'disjoint', 'lower end'),
                (put('certificate', 'direction', lambda d: d[1:] + d[:1]), 'disjoint', 'separate'),
                (put('certificate', 'nearest', 'points', 0, 0, [0, 0]), 'disjoint', 'upper end'),
                (put('certificate', 'point', 0, [9, 9]), 'intersecting', 'both'),
                (put('distance', 0, lambda x: x * (1 + 1e-9)), 'disjoint', 'distance'),
                (put('distance', 1, lambda x: x * (1 - 1e-9)), 'disjoint', 'distance'),
                (put('distance', 0, lambda x: x * (1 - 1e-6)), 'intersecting', 'distance'),
                (put('a', 'radius', None), 'disjoint', 'not valid')):
            v = copy.deepcopy(next(v for v in SMOKE['vectors'] if v['result'] == result))
            change(v)
            stated = list(lint.lint([v]))
            self.assertTrue(stated and stated[0].startswith(v['id']) and why in stated[0], (why, stated))


class Runner(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / 'mine.py').write_text(MINE % str(daylight_vectors.FOLDER / 'smoke.json'))
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(self.folder)
        sys.modules.pop('mine', None)
        self.addCleanup(lambda: str(self.folder) in sys.path and sys.path.remove(os.getcwd()))

    def ask(self, name, **options):
        run = daylight_vectors.Run(name, SMOKE['vectors'], **options)
        wrong = [v for v in run.vectors if run.is_wrong(v)]
        run.asker.close()
        return run, wrong

    def test_judging(self):
        apart = next(v for v in SMOKE['vectors'] if v['result'] == 'disjoint')
        deep = next(v for v in SMOKE['vectors'] if v['result'] == 'intersecting')
        touch = next(v for v in SMOKE['vectors'] if v['result'] == 'touching')
        middle = sum(apart['distance']) / 2
        for v, said, tolerance, judged in (
                (apart, False, 0, 'right'), (apart, True, 0, 'said True'), (apart, True, 1e9, 'acceptable'),
                (apart, 'disjoint', 0, 'right'), (apart, 'touching', 0, "said 'touching'"), (apart, middle, 0, 'right'),
                (apart, middle + 1e-3, 0, 'said a distance'), (apart, middle + 1e-3, 1e-2, 'acceptable'),
                (apart, math.nan, 1e9, 'said a distance'), (apart, 'invalid', 0, "said 'invalid'"),
                (apart, None, 0, 'declined'),
                (apart, 'far', 0, 'none of'), (deep, True, 0, 'right'),
                (deep, 'touching', 0, 'said'), (deep, False, 0, 'said'), (touch, 'touching', 0, 'right'),
                (touch, True, 0, 'right'), (touch, False, 0, 'said'), (touch, False, 1e-12, 'acceptable'),
                (touch, 0.0, 0, 'right')):
            self.assertIn(judged, daylight_vectors.judge(v, said, tolerance), (v['result'], said))
        self.assertEqual(daylight_vectors.decade_of({'result': 'disjoint', 'margin': 0.005}), '1e-03')

    def test_a_run(self):
        run, wrong = self.ask('mine:right')
        self.assertEqual((list(run.results.values()), wrong), (['right'] * 200, []))
        run, wrong = self.ask('mine:blind')
        decade, capsules = next((decade, [v for v in cell if run.is_wrong(v)])
                                for (flag, decade), cell in run.cells().items() if flag == 'Capsule')
        self.assertRegex(decade, r'1e-0\d')
        report = daylight_vectors.report('Capsule', capsules, run.results)
        self.assertRegex(report, f'^{len(capsules)} wrong. The simplest, v1-')
        self.assertIn('Met by', report)
        failed = sorted(v['id'] for v in wrong)
        self.assertGreater(len(failed), 3)
        pathlib.Path('left out').write_text(''.join(f'{name} spheres are not ours\n' for name in failed) + '# all\n\n')
        excluded = daylight_vectors.exclusions('left out')
        self.assertEqual(sorted(excluded), failed)
        run, wrong = self.ask('mine:blind', excluded=excluded)
        self.assertEqual((len(run.results), wrong), (200 - len(failed), []))
        pathlib.Path('left out').write_text(failed[0] + '\n')
        with self.assertRaisesRegex(ValueError, 'without a reason'):
            daylight_vectors.exclusions('left out')
        for name in ('mine', 'nobody:right', 'mine:left'):
            with self.assertRaises(ValueError):
                self.ask(name)
        self.assertEqual(list(self.ask('mine:unable')[0].results.values()), ['declined'] * 200)

    def test_what_breaks(self):
        for number, why in enumerate(('gave no answer within 1 s', 'ended its process', 'ended its process',
                                      'raised ZeroDivisionError', 'said [1], which is no answer', 'raised ValueError')):
            os.environ['FAULT'] = str(number)
            self.addCleanup(os.environ.pop, 'FAULT', None)
            run, wrong = self.ask('mine:broken', limit=1.0)
            self.assertEqual(len(wrong), 1)
            self.assertTrue(run.results[wrong[0]['id']].startswith(why), run.results[wrong[0]['id']])
            self.assertEqual(list(run.results.values()).count('declined'), 199)

    def test_the_lint_command(self):
        document = copy.deepcopy(SMOKE)
        document['vectors'][0]['result'] = 'touching'
        pathlib.Path('wrong.json').write_text(json.dumps(document))
        done = subprocess.run([sys.executable, HERE / 'lint.py', 'wrong.json'], stdout=subprocess.PIPE, text=True)
        self.assertRegex(f'{done.returncode} {done.stdout}', r'^2 wrong.json: v1-\w+: .*\n1 wrong\n$')

    def test_the_plug_in(self):
        python = python_with_pytest()

        def pytest(*arguments):
            done = subprocess.run([python, '-m', 'pytest', '-p', 'daylight_vectors', '-v', *arguments],
                                  stdout=subprocess.PIPE, text=True,
                                  env=dict(os.environ, PYTHONPATH=os.pathsep.join([str(HERE), os.getcwd()])))
            return done.returncode, done.stdout
        status, text = pytest('--daylight', 'mine:right')
        self.assertEqual(status, 0, text)
        self.assertRegex(text, r'daylight::Coaxial\[1e-0\d\] PASSED')
        status, text = pytest('--daylight', 'mine:blind')
        self.assertEqual(status, 1, text)
        self.assertRegex(text, r'daylight::Capsule\[1e-0\d\] FAILED')
        self.assertRegex(text, r'\d+ wrong. The simplest, v1-')
        self.assertRegex(pytest('--daylight', 'mine:blind', '--failed-first')[1], r'\n\ndaylight::\S+ FAILED')
        failed = self.ask('mine:blind')[1]
        pathlib.Path('left out').write_text(''.join(f'{v["id"]} spheres are not ours\n' for v in failed))
        self.assertEqual(pytest('--daylight', 'mine:blind', '--daylight-exclude', 'left out')[0], 0)
        self.assertRegex(pytest('--daylight', 'mine:unable')[1], r'daylight::\S+ SKIPPED')
        self.assertEqual(pytest('--daylight', 'nobody:right')[0], 4)
        self.assertEqual(pytest()[0], 5)


if __name__ == '__main__':
    unittest.main()
