#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Asks collision libraries about the test vectors, and writes which get which class of bug wrong:

    docs/results/vectors.py build/release/daylight >docs/results/vectors.md

`npm ci --prefix oracles/guests` installs the engines that run in Node.js.
"""
import collections
import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / 'python/vectors'))
from daylight_vectors import flags, load  # noqa: E402
from daylight_vectors.runner import judge  # noqa: E402

ENGINES = {'intersect': 'ours', 'fcl-libccd': 'FCL', 'bullet-cylinder': 'Bullet', 'libccd-gjk': 'libccd GJK',
           'libccd-mpr': 'libccd MPR', 'ode': 'ODE', 'mujoco': 'MuJoCo', 'rapier': 'Rapier', 'jolt': 'Jolt'}
GUESTS = [part for name in ('rapier', 'jolt') for part in ('--command', f'{name}=node {ROOT}/oracles/guests/{name}.mjs')]
CORE = ('center', 'axis', 'radius', 'height', 'rounding')


def claims(program):
    """{method: (relative, absolute)}, as `campaign --list` states them."""
    text = subprocess.run([program, 'campaign', '--list', *GUESTS], check=True, capture_output=True, text=True).stdout
    stated = re.findall(r'^  (\S+) +.*?above a margin of (\S+) size \+ (\S+) ', text, re.M)
    return {name: (float(relative), float(absolute)) for name, relative, absolute in stated}


def answers(program, method, vectors):
    lines = [json.dumps({name: {k: v[name][k] for k in CORE if k in v[name]} for name in 'ab'}) for v in vectors]
    run = subprocess.run([program, 'check', *GUESTS, '--method', method], input='\n'.join(lines), capture_output=True,
                         text=True, check=False)
    return [json.loads(line) for line in run.stdout.splitlines()]


def outcome(v, answer, claim):
    if answer['verdict'] == 'undecided':
        return 'wrong' if ' failed: ' in answer.get('error', '') else 'declined'
    size = sum(v[name].get(k, 0) for name in 'ab' for k in ('radius', 'height', 'rounding'))
    result = judge(v, answer['verdict'], claim[0] * size + claim[1])
    return result if result in ('right', 'acceptable') else 'wrong'


def row(title, vectors, outcomes):
    cells = []
    for method in ENGINES:
        counts = collections.Counter(outcomes[method][v['id']] for v in vectors)
        cells.append('-' if counts['declined'] == len(vectors) else str(counts['wrong']))
    return f'| {title} | {len(vectors)} | ' + ' | '.join(cells) + ' |'


def main(program):
    vectors = [v for v in load('standard')['vectors'] if v['kind'] in ('pair', 'changed')]
    stated, outcomes = claims(program), {}
    for method in ENGINES:
        said = answers(program, method, vectors)
        assert len(said) == len(vectors), f'{method} answered {len(said)} of {len(vectors)} vectors'
        outcomes[method] = {v['id']: outcome(v, a, stated[method]) for v, a in zip(vectors, said)}
    print(f'''# The test vectors put to collision libraries

    docs/results/vectors.py build/release/daylight >docs/results/vectors.md

The table covers the {len(vectors):,} valid vectors of the standard tier. A number counts vectors that the library answers
wrongly beyond its claim, or that it fails on. A dash means that the library supports none of them. A vector counts for
each of its [flags](../vectors.md#flags). If a library states no claim, we assume one.
''')
    print('| | vectors | ' + ' | '.join(ENGINES.values()) + ' |\n|---|' + '---:|' * (len(ENGINES) + 1))
    claim = [f'{stated[m][0]:g}' + (f' + {stated[m][1]:g}' if stated[m][1] else '') for m in ENGINES]
    print('| claim, relative to the size | | ' + ' | '.join(claim) + ' |')
    for sizes in ('ordinary', 'extreme'):
        print(row(f'{sizes} sizes', [v for v in vectors if v['sizes'] == sizes], outcomes))
    for flag in sorted(flags()):
        if some := [v for v in vectors if flag in v['flags']]:
            print(row(f'`{flag}`', some, outcomes))
    for title, kind in (('asked', ('right', 'acceptable', 'wrong')), ('within the claim', ('acceptable',)),
                        ('**wrong beyond the claim**', ('wrong',))):
        counts = [sum(o in kind for o in outcomes[m].values()) for m in ENGINES]
        print(f'| {title} | {len(vectors)} | ' + ' | '.join(map(str, counts)) + ' |')


if __name__ == '__main__':
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
