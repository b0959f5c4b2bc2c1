#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""workflows_test.py DAYLIGHT: action.yml, the workflows of this project and those in docs/ci are valid, and the shell of
each of their steps runs: in a project with the plug-in of docs/guides/library.md, with fewer pairs. No step of others
(uses:) is run, and nothing is installed or reported."""
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = pathlib.Path(sys.argv.pop(1)).resolve()
VALIDATOR = ROOT / '.ci/workflows/node_modules/.bin/action-validator'
OURS = sorted((ROOT / '.github/workflows').glob('*.yml'))
GATE, NIGHT, ACTION = ROOT / 'docs/ci/gate.yml', ROOT / 'docs/ci/nightly.yml', ROOT / 'action.yml'
LESS = f'''#!/usr/bin/env bash
words=() last=
for word; do
  case $last in
    --pairs) word=1200 ;;
    --seed) word=1 ;;
    --for) word=${{LONG:-8s}} ;;
  esac
  words+=("$word") last=$word
done
[[ $1 != gate ]] || words+=(--cases '')
exec {shlex.quote(str(PROGRAM))} "${{words[@]}}"
'''
PROJECT = '''cmake_minimum_required(VERSION 3.16)
project(mine CXX)
add_library(mine MODULE mine.cpp)
target_include_directories(mine PRIVATE "$ENV{DAYLIGHT_SOURCE}/oracles")
'''


def skip(why):
    sys.exit(subprocess.run([ROOT / '.ci/skip', why]).returncode)


try:
    import yaml
except ImportError:
    skip('no YAML: apt-get install python3-yaml')
if not VALIDATOR.exists():
    skip('no action-validator: npm ci --prefix .ci/workflows')


def is_valid(text, name):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / name
        path.write_text(text)
        return subprocess.run([VALIDATOR, path], capture_output=True).returncode == 0


class Valid(unittest.TestCase):
    def test_all(self):
        self.assertEqual(len(OURS), 4)
        for path in [*OURS, GATE, NIGHT, ACTION]:
            text = path.read_text()
            self.assertTrue(is_valid(text, path.name), path)
            for planted in (text.replace('runs-on:', 'run-on:').replace('using:', 'used:'),
                            text.replace('steps:', 'steps: 1\n    more:')):
                self.assertFalse(is_valid(planted, path.name), path)
            for used in re.findall(r'uses: (\S+)', text):
                self.assertRegex(used, r'^\./|@v\d+$', path)


class Shell(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)
        for name, text in (('.daylight/daylight', LESS), ('bin/gh', '#!/bin/sh\nprintf "%s\\n" "$4" >>gh.txt\ntest -s "$6"\n'),
                           ('bin/apt-get', '#!/bin/sh\necho "$@" >>apt.txt\n'), ('CMakeLists.txt', PROJECT)):
            self.write(name, text)
        guide = (ROOT / 'docs/guides/library.md').read_text()
        self.write('mine.cpp', re.search(r'^```cpp file=mine.cpp\n(.*?)^```', guide, re.M | re.S)[1])
        self.values = {'matrix.shard': '0', 'github.run_number': '1', 'github.token': 'none', 'github.repository': 'o/r',
                       'github.action_path': str(self.folder / '.daylight')}
        self.environment = dict(os.environ, PATH=f'{self.folder}/bin:{os.environ["PATH"]}', DAYLIGHT_SOURCE=str(ROOT),
                                XDG_STATE_HOME=str(self.folder / 'state'))

    def write(self, name, text):
        path = self.folder / name
        path.parent.mkdir(exist_ok=True)
        path.write_text(text)
        path.chmod(0o755)

    def filled(self, text):
        return re.sub(r'\$\{\{ (.*?) \}\}', lambda m: self.values[m[1]], str(text))

    def run_shell(self, script, shell, environment):
        words = ['bash', '--noprofile', '--norc', '-eo', 'pipefail', '-c'] if shell == 'bash' else ['sh', '-e', '-c']
        assert '${{' not in script, f'an expression in a script: {script}'
        done = subprocess.run([*words, script], cwd=self.folder, capture_output=True, text=True, timeout=600,
                              env={**self.environment, **{k: self.filled(v) for k, v in environment.items()}})
        self.printed = done.stdout + done.stderr
        return done.returncode

    def run_step(self, workflow, job, name):
        step = next(s for s in workflow['jobs'][job]['steps'] if s.get('name') == name)
        shell = step.get('shell', workflow.get('defaults', {}).get('run', {}).get('shell'))
        return self.run_shell(step['run'], shell, {**workflow.get('env', {}), **step.get('env', {})})

    def run_action(self, inputs):
        action = yaml.safe_load(ACTION.read_text())
        self.assertLessEqual(set(inputs), set(action['inputs']))
        for name, about in action['inputs'].items():
            self.values[f'inputs.{name}'] = str(inputs.get(name, about['default']))
        step, = action['runs']['steps']
        return self.run_shell(step['run'], step['shell'], step['env'])

    def steps(self, workflow):
        return [(job, s['name']) for job, about in workflow['jobs'].items() for s in about['steps'] if 'run' in s]

    def test_gate(self):
        workflow = yaml.safe_load(GATE.read_text())
        gated = next(s['with'] for s in workflow['jobs']['gate']['steps'] if s.get('uses') == './.daylight')
        for name in ('Install', 'Build mine'):
            self.assertEqual(self.run_step(workflow, 'gate', name), 0, self.printed)
        self.assertIn('install -y', (self.folder / 'apt.txt').read_text())
        self.assertEqual(self.run_action(gated), 2, self.printed)
        self.assertIn('::error file=mine.cpp,line=1', self.printed)
        self.assertTrue((self.folder / 'daylight.xml').stat().st_size)
        self.assertEqual(self.run_step(workflow, 'gate', 'Keep for the next'), 0)
        self.assertEqual(self.run_action(gated), 0, self.printed)
        self.assertEqual(set(self.steps(workflow)), {('gate', name) for name in ('Install', 'Build mine', 'Keep for the next')})
        self.write('ask.py', 'import sys\nfor line in sys.stdin: print(\'{"declined":"all"}\', flush=True)\n')
        self.assertEqual(self.run_action({'command': 'python3 ask.py', 'claim': '1e-6'}), 3, self.printed)

    def test_night(self):
        workflow = yaml.safe_load(NIGHT.read_text())
        shard, causes = workflow['jobs']['shard'], workflow['jobs']['causes']
        for night in (1, 2):
            self.values['github.run_number'] = str(night)
            for job, names in (('shard', ('Install', 'Build mine')), ('causes', ('Install', 'Build mine'))):
                for name in names:
                    self.assertEqual(self.run_step(workflow, job, name), 0, self.printed)
            for number in shard['strategy']['matrix']['shard']:
                self.values['matrix.shard'] = str(number)
                subprocess.run(['rm', '-rf', self.folder / f'shard-{number}'], check=True)
                self.assertEqual(self.run_step(workflow, 'shard', 'Ask'), 0, self.printed)
            self.assertEqual(self.run_step(workflow, 'causes', 'Find what is new'), 0, self.printed)
            self.assertNotIn('shard is missing', self.printed)
            new = json.loads((self.folder / 'new.json').read_text())
            told = self.folder / 'gh.txt'
            told.unlink(missing_ok=True)
            self.assertEqual(self.run_step(workflow, 'causes', 'Write an issue for each'), 0, self.printed)
            issues = told.read_text().splitlines() if told.exists() else []
            self.assertEqual(len(issues), len(new), (issues, self.printed))
            self.assertTrue(all(len(title) > 10 and not title.startswith('#') for title in issues), issues)
            self.assertEqual(bool(new), night == 1)
            self.assertEqual(self.run_step(workflow, 'causes', 'Fail if anything is new'), int(night == 1))
        self.assertEqual(set(self.steps(workflow)), {('shard', name) for name in ('Install', 'Build mine', 'Ask')} |
                         {('causes', name) for name in ('Install', 'Build mine', 'Find what is new',
                                                        'Write an issue for each', 'Fail if anything is new')})
        self.assertEqual(causes['needs'], 'shard')

    def test_ours(self):
        self.write('build/daylight-0.1.0-Linux.tar.gz', '')
        self.values['github.ref_name'] = 'v0.1.0'
        for name in ('daylight', 'bin/ninja', 'bin/gh'):
            self.write(name, f'#!/bin/sh\necho {pathlib.Path(name).name} $* >>released.txt\n')
        for path in OURS:
            workflow = yaml.safe_load(path.read_text())
            for job, name in self.steps(workflow):
                for script in ('run', 'deep'):
                    self.assertTrue(os.access(ROOT / '.ci' / script, os.X_OK))
                    self.write(f'.ci/{script}', f'#!/bin/sh\necho {script} $CI $* >>ran.txt\n')
                self.assertEqual(self.run_step(workflow, job, name), 0, self.printed)
        self.assertEqual(sorted((self.folder / 'ran.txt').read_text().splitlines()),
                         ['deep true', 'run true', 'run true --quick'])
        self.assertEqual((self.folder / 'released.txt').read_text().splitlines(),
                         ['daylight --version', 'ninja -C build/release portable',
                          'gh release create v0.1.0 build/daylight-0.1.0-Linux.tar.gz --verify-tag --generate-notes'])

    def test_timer(self):
        self.write('mine/none', '')
        self.write('daylight/daylight', LESS)
        subprocess.run(['sh', '-ec', 'cmake -S . -B build && cmake --build build && cp build/libmine.so mine'],
                       cwd=self.folder, env=self.environment, check=True, capture_output=True)
        unit = (ROOT / 'docs/ci/daylight.service').read_text()
        commands = [line.removeprefix('ExecStart=') for line in unit.splitlines() if line.startswith('ExecStart=')]
        codes = []
        for command in commands:
            script = shlex.split(command.replace('%h', str(self.folder)).replace('%%', '%').replace('$$', '$'))
            done = subprocess.run(script, cwd=self.folder / 'mine', env=dict(self.environment, LONG='4s'), capture_output=True)
            codes.append(done.returncode)
        self.assertEqual(codes, [0, 2])
        self.assertIn('OnCalendar=', (ROOT / 'docs/ci/daylight.timer').read_text())


if __name__ == '__main__':
    unittest.main()
