#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Fetches public robots with git and prints the tables of docs/robots.md: tools/public_robots.py DAYLIGHT FOLDER"""
import json
import pathlib
import subprocess
import sys

DATA, RESOURCES = 'Gepetto/example-robot-data', 'moveit/moveit_resources'
COMMITS = {DATA: '39aa94379908fa743da90b21dc9e1fb8308f746b', RESOURCES: 'ef5836ddf4d6a7773cee895a675bfa852a3798f6'}
ROBOTS = [(DATA, f'robots/{urdf}', f'robots/{urdf.split("/")[0]}/srdf/{srdf}') for urdf, srdf in (
    ('panda_description/urdf/panda_collision.urdf', 'panda.srdf'), ('go1_description/urdf/go1.urdf', 'go1.srdf'),
    ('b1_description/urdf/b1.urdf', 'b1.srdf'), ('a1_description/urdf/a1.urdf', 'a1.srdf'),
    ('anymal_b_simple_description/robots/anymal.urdf', 'anymal.srdf'),
    ('anymal_c_simple_description/urdf/anymal.urdf', 'anymal.srdf'),
    ('anymal_b_simple_description/robots/anymal-kinova.urdf', 'anymal-kinova.srdf'))]
ROBOTS += [(RESOURCES, f'{name}_description/urdf/{name}.urdf', f'{name}_moveit_config/config/{name}.srdf')
           for name in ('fanuc', 'panda')]

daylight, folder = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
for repository, commit in COMMITS.items():
    place = folder / repository
    if not place.exists():
        place.mkdir(parents=True)
        for words in (['init', '-q'], ['fetch', '-q', '--depth', '1', f'https://github.com/{repository}', commit],
                      ['checkout', '-q', 'FETCH_HEAD']):
            subprocess.run(['git', *words], cwd=place, check=True)
found = []
for repository, urdf, srdf in ROBOTS:
    subprocess.run([daylight, 'scene', folder / repository / urdf, '--srdf', folder / repository / srdf, '--prove',
                    '--json', folder / 'robot.json'], stdout=subprocess.DEVNULL, check=False)
    study = json.loads((folder / 'robot.json').read_text())
    verdicts = [entry['verdict'] for entry in study['exemptions']]
    counts = ' | '.join(str(verdicts.count(word)) for word in ('never', 'refuted', 'open'))
    print(f'| `{urdf.removeprefix("robots/")}` | {len(verdicts)} | {counts} | {study["motions_cpu_ms"] / 1000:.1f} s |')
    found.append(f'# {urdf}')
    for entry in study['exemptions']:
        refuted = [proof for proof in entry['pairs'] if proof['verdict'] == 'refuted']
        for worst in sorted(refuted, key=lambda proof: proof['least_seen'])[:1]:
            joints = ' '.join(f'{name}={value:.6g}' for name, value in worst['joints'].items())
            found.append(f'{entry["link1"]} - {entry["link2"]} {-worst["least_seen"]:.2g} {joints}')
print('\n'.join(found))
