#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Asks the versions of an npm package about the same pairs, and says when each kind of failure came and went.

    versions.py run DAYLIGHT GUEST VERSION..   for example: run ./daylight rapier 0.11.2 0.12.0; adds to the data
    versions.py page                           prints docs/results/engine_versions.md from the data

Each version is installed by npm into a cache folder, with its guest beside it. A version in the data is not asked
again. A kind of failure is a shape pair and what the engine said beyond its claim.
"""
import json
import os
import pathlib
import subprocess
import sys
from collections import Counter

sys.dont_write_bytecode = True
from compare import (CYLINDERS, HERE, RESULTS, SHAPES, compared, draw, kinds_of, package_of,  # noqa: E402
                     proved, table)

DATA = RESULTS / 'engine_versions.jsonl'
PAIRS = 10000, 5000  # of cylinders, of other shapes, before those of other sizes go


def installed(guest, package, version):
    """The folder with a copy of the guest and that version of its package."""
    cache = pathlib.Path(os.environ.get('XDG_CACHE_HOME', pathlib.Path.home() / '.cache')) / 'daylight/guests'
    folder = cache / f'{package.replace("/", "+")}@{version}'
    folder.mkdir(parents=True, exist_ok=True)
    for name in ('lines.mjs', f'{guest}.mjs', '.npmrc'):
        (folder / name).write_text((HERE / name).read_text())
    (folder / 'package.json').write_text(json.dumps({'private': True, 'type': 'module',
                                                     'dependencies': {package: version}}))
    if not (folder / 'node_modules' / package).is_dir():
        subprocess.run(['npm', 'install', '--no-package-lock'], cwd=folder, check=True, stdout=subprocess.DEVNULL)
    return folder


def data():
    return [json.loads(line) for line in DATA.read_text().splitlines()] if DATA.exists() else []


def run(daylight, guest, versions):
    package = package_of(guest).split()[0]
    known = {(row['package'], row['version']) for row in data()}
    pairs = draw(daylight, CYLINDERS, PAIRS[0]) + draw(daylight, SHAPES, PAIRS[1])
    truths = proved(daylight, pairs)
    for version in versions:
        if (package, version) in known:
            continue
        row = asked(daylight, guest, installed(guest, package, version), pairs, truths)
        with open(DATA, 'a', encoding='utf-8') as file:
            file.write(json.dumps({'package': package, 'version': version, **row}) + '\n')
        print(package, version, row, file=sys.stderr)


def asked(daylight, guest, folder, pairs, truths):
    try:
        _, judged = compared(daylight, ['node', f'{guest}.mjs'], pairs, truths, folder)
    except RuntimeError:
        return {'not_asked': True}
    wrong = Counter(f'{kinds_of(pair)}: {found[0]}' for pair, *_, found in judged if found)
    said = ''.join(answer.get('verdict', 'none')[0] for *_, answer, _ in judged)
    return {'answered': len(judged), 'wrong': dict(sorted(wrong.items())), 'verdicts': fingerprint(said)}


def fingerprint(text):
    """FNV-1a of 64 bits: equal for versions that gave the same verdicts."""
    value = 0xcbf29ce484222325
    for byte in text.encode():
        value = (value ^ byte) * 0x100000001b3 % 2**64
    return f'{value:016x}'


def number(row):
    return [int(part) for part in row['version'].split('.')]


def turns(rows, kind):
    """First bad, last good before it, first good after it: of versions in order; None for what there is not."""
    bad = [kind in row['wrong'] for row in rows]
    first = bad.index(True)
    after = next((i for i in range(first, len(bad)) if not bad[i]), None)
    name = lambda i: None if i is None else rows[i]['version']
    return name(first), name(first - 1 if first else None), name(after)


HEAD = """# Versions of engines

For readers who ask since when an engine has a fault. `oracles/guests/versions.py` asked each version about the same
pairs of ordinary size (0.1 to 10 m), and wrote this page from [its data](engine_versions.jsonl). The claims are those
of [the engines' page](engines.md). A fault is a shape pair and a wrong verdict beyond the claim, a crash, a hang or an
error. The counts are pairs.

    oracles/guests/versions.py run build/release/daylight rapier 0.20.0 0.21.0
    oracles/guests/versions.py page

"""


def page(rows):
    parts = [HEAD]
    for package in dict.fromkeys(row['package'] for row in rows):
        every = sorted((row for row in rows if row['package'] == package), key=number)
        mine = [row for row in every if 'not_asked' not in row]
        mute = ', '.join(row['version'] for row in every if 'not_asked' in row)
        kinds = sorted({kind for row in mine for kind in row['wrong']})
        behaviours = len({row['verdicts'] for row in mine})
        parts.append(f'## {package}\n\nThere are {len(mine)} versions, each with {mine[0]["answered"]} pairs. '
                     f'Different sets of verdicts: {behaviours}.\n'
                     f'Not asked, because the package or its guest does not start: {mute or "none"}.\n\n')
        if kinds:
            parts.append(table(['fault', 'first bad', 'last good', 'first good again'],
                               [[kind, *(x or '-' for x in turns(mine, kind))] for kind in kinds]) + '\n')
        else:
            parts.append('No version has a fault on these pairs.\n\n')
        parts.append(table(['version', *kinds, 'answers'],
                           [[row['version'], *(row['wrong'].get(kind, 0) for kind in kinds), f'`{row["verdicts"]}`']
                            for row in mine]) + '\n')
    return ''.join(parts).rstrip('\n') + '\n'


if __name__ == '__main__':
    if sys.argv[1:] == ['page']:
        print(page(data()), end='')
    elif len(sys.argv) > 4 and sys.argv[1] == 'run':
        run(sys.argv[2], sys.argv[3], sys.argv[4:])
    else:
        sys.exit(__doc__)
