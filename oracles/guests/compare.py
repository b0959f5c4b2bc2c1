#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compares the engines of this folder on pairs of ordinary size, and writes docs/results/engines.md.

    compare.py run DAYLIGHT [--cylinders N] [--shapes N]   asks all engines, writes engines.jsonl and the page (minutes)
    compare.py page                                        prints the page of docs/results/engines.jsonl

An answer is wrong beyond the claim if the distance that daylight proved exceeds the engine's tolerance. The engine's
own solid lies inside the cylinder and holds an inner one, which its hello states. Wrong for both is the algorithm's
fault. Wrong for the cylinder alone may be the model's.
"""
import argparse
import json
import math
import pathlib
import statistics
import subprocess
import sys
from collections import Counter, defaultdict

HERE = pathlib.Path(__file__).resolve().parent
RESULTS = HERE.parents[1] / 'docs/results'
ENGINES = ('rapier', 'jolt', 'physx', 'havok', 'ammo', 'cannon', 'crashcat', 'oimo')
CYLINDERS = ('random,touching_cap_cap,touching_cap_side,touching_parallel_sides,touching_cap_rim,touching_side_side,'
             'touching_side_rim,touching_rim_rim,axes_parallel,axes_nearly_parallel,axes_perpendicular,axes_crossing,'
             'contained,coaxial,equal')
SHAPES = ('sphere_sphere,sphere_capsule,sphere_cylinder,sphere_rounded,capsule_capsule,capsule_cylinder,'
          'capsule_rounded,cylinder_rounded,rounded_rounded')
LENGTHS = ('radius', 'height', 'rounding')
CHUNK, PATIENCE = 5000, 120


def lengths(pair):
    return [pair[k].get(length, 0) for k in 'ab' for length in LENGTHS]


def ordinary(pair):
    return all(x == 0 or 0.1 <= x <= 10 for x in lengths(pair))


def lines_of(command, text):
    done = subprocess.run(command, input=text, capture_output=True, text=True, check=True)
    return [json.loads(line) for line in done.stdout.splitlines()]


def to_text(pairs):
    return ''.join(json.dumps({k: p[k] for k in 'ab'}) + '\n' for p in pairs)


def draw(daylight, families, count):
    return [p for p in lines_of([daylight, 'ask', '--seed', '1', '--cases', '', '--families', families, '--pairs',
                                 str(count)], '') if ordinary(p)]


def proved(daylight, pairs):
    """The truth of each pair: its verdict, certificate and an interval of its signed distance."""
    return lines_of([daylight, 'check', '--distance', '-'], to_text(pairs))


def ask(command, pairs, folder=HERE):
    """The hello of an engine, and an answer for each pair; a pair at which it ends or hangs is answered by that."""
    hello, answers = None, []
    while len(answers) < len(pairs):
        part = pairs[len(answers):len(answers) + CHUNK]
        try:
            out = subprocess.run(command, input=to_text(part), capture_output=True, text=True, cwd=folder,
                                 timeout=PATIENCE, check=False).stdout
            end = 'crash'
        except subprocess.TimeoutExpired as late:
            out, end = (late.stdout or b'').decode(), 'hang'
        said = [json.loads(line) for line in out.splitlines() if line.startswith('{')]
        if not said:
            sys.exit(f'{command} does not start')
        hello, said = said[0], said[1:]
        answers += said[:len(part)]
        if len(said) < len(part) and not (said and 'error' in said[-1]):
            answers.append({end: True})
    return hello, answers


def kind_of(solid):
    if not solid.get('rounding'):
        return 'cylinder'
    return 'rounded' if solid['radius'] else 'capsule' if solid['height'] else 'sphere'


def kinds_of(pair):
    return ' - '.join(sorted(kind_of(pair[k]) for k in 'ab'))


def inner_solid(solid, inner):
    """The cylinder with a smaller radius and rounded rims; other solids as they are."""
    if kind_of(solid) != 'cylinder':
        return solid
    radius, height = solid['radius'] * inner.get('radius', 1), solid['height']
    rims = min(inner.get('rims', 0), radius, height / 2)
    return dict(solid, radius=radius - rims, height=height - 2 * rims, rounding=rims)


def inner_pairs(pairs, inner):
    return [{k: inner_solid(p[k], inner) for k in 'ab'} for p in pairs]


def fault_of(answer, true, own, tolerance):
    """What is wrong beyond the tolerance, as (kind, whose); None if nothing is. `true` and `own` are the intervals of
    the distance of the cylinders and of the inner solids."""
    for failure in ('crash', 'hang', 'error'):
        if failure in answer:
            return failure, 'algorithm'
    if answer['verdict'] == 'intersecting' and true[0] > tolerance:
        return 'intersecting', 'algorithm'
    if answer['verdict'] == 'disjoint' and true[1] < -tolerance:
        return 'disjoint', 'algorithm' if own[1] < -tolerance else 'model'
    if 'distance' in answer:
        far = tolerance + 1e-5 * max(map(abs, true))  # single precision, and where an iteration stops
        kind = 'distance' if answer['verdict'] == 'disjoint' else 'depth'
        if answer['distance'] < true[0] - far or answer['distance'] > own[1] + far:
            return kind, 'algorithm'
        if answer['distance'] > true[1] + far:
            return kind, 'model'
    return None


def judge(hello, pairs, truths, owns, answers):
    claim = hello['claim']
    for pair, truth, own, answer in zip(pairs, truths, owns, answers):
        if 'declined' in answer:
            continue
        tolerance = claim['relative'] * sum(lengths(pair)) + claim['absolute']
        yield pair, truth, own, answer, fault_of(answer, truth['distance'], own['distance'], tolerance)


def summary(hello, package, judged):
    """The row of an engine: counts, and its worst wrong verdict."""
    judged = list(judged)
    faults = Counter((fault, whose) for *_, found in judged if found for fault, whose in [found])
    by_kinds, asked = defaultdict(Counter), Counter(kinds_of(pair) for pair, *_ in judged)
    worst, from_margin, model_margin = None, 0, 0
    for pair, truth, own, answer, found in judged:
        margin = min(map(abs, truth['distance'])) / sum(lengths(pair))
        verdict = answer.get('verdict')
        if verdict and verdict != truth['verdict'] and truth['verdict'] != 'touching':
            from_margin = max(from_margin, margin)
        if found is None or found[0] not in ('intersecting', 'disjoint'):
            continue
        by_kinds[kinds_of(pair)][found[1]] += 1
        if found[1] == 'model':
            model_margin = max(model_margin, margin)
        own_margin = min(map(abs, own['distance'])) / sum(lengths(pair)) if verdict == 'disjoint' else margin
        if found[1] == 'algorithm' and (worst is None or own_margin > worst['margin']):
            worst = {'margin': own_margin, 'pair': {k: pair[k] for k in 'ab'}, 'said': verdict,
                     'truth': truth['verdict'], 'distance': truth['distance']}
    times = [answer['ns'] for *_, answer, _ in judged if 'ns' in answer]
    return {
        'name': hello['name'], 'package': package, 'claim': hello['claim'], 'model': hello['model'],
        'takes': hello['takes'], 'answered': len(judged), 'asked': dict(sorted(asked.items())),
        'faults': {f'{fault}/{whose}': n for (fault, whose), n in sorted(faults.items())},
        'verdicts': {k: dict(v) for k, v in sorted(by_kinds.items())}, 'wrong_below': from_margin,
        'worst': worst, 'ns': round(statistics.median(times), -2) if times else None,
    }


def package_of(engine):
    """Name and version of the npm package that a guest imports."""
    names = json.loads((HERE / 'package.json').read_text())['dependencies']
    source = (HERE / f'{engine}.mjs').read_text()
    return next(f'{name} {version}' for name, version in names.items() if f"'{name}'" in source)


def run(daylight, cylinders, shapes, only, keep):
    pairs = draw(daylight, CYLINDERS, cylinders) + draw(daylight, SHAPES, shapes)
    truths, rows = proved(daylight, pairs), []
    for engine in only or ENGINES:
        hello, answers = ask(['node', str(HERE / f'{engine}.mjs'), '--time'], pairs[:1])
        mine = [i for i, p in enumerate(pairs) if all(kind_of(p[k]) in hello['takes'] for k in 'ab')]
        chosen, truth = [pairs[i] for i in mine], [truths[i] for i in mine]
        hello, answers = ask(['node', str(HERE / f'{engine}.mjs'), '--time'], chosen)
        inner = hello['model'].get('inner')
        shrunk = inner_pairs(chosen, inner) if inner else chosen
        owns = proved(daylight, shrunk) if inner else truth
        judged = list(judge(hello, chosen, truth, owns, answers))
        rows.append(summary(hello, package_of(engine), judged))
        if keep:
            keep_findings(pathlib.Path(keep), engine, shrunk, judged, owns)
        print(engine, rows[-1]['answered'], rows[-1]['faults'], file=sys.stderr)
    return rows


def keep_findings(folder, engine, shrunk, judged, owns):
    """Writes up to ten of the algorithm's wrong verdicts with the certificates, for exact.py: about the inner solids if
    the engine said disjoint."""
    folder.mkdir(parents=True, exist_ok=True)
    with open(folder / f'{engine}.pairs.jsonl', 'w') as to, open(folder / f'{engine}.answers.jsonl', 'w') as proofs:
        wrong = [(s, j) for s, j in zip(shrunk, judged) if j[4] and j[4][1] == 'algorithm' and 'verdict' in j[3]]
        wrong.sort(key=lambda x: (x[1][4][0] in ('distance', 'depth'), -min(map(abs, x[1][2]['distance']))))
        for solids, (pair, truth, own, answer, _) in wrong[:10]:
            meet = own['verdict'] != 'disjoint' and answer['verdict'] == 'disjoint'
            to.write(to_text([solids if meet else pair]))
            proofs.write(json.dumps(own if meet else truth) + '\n')


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest='command', required=True)
    running = commands.add_parser('run')
    running.add_argument('daylight')
    running.add_argument('--cylinders', type=int, default=30000)
    running.add_argument('--shapes', type=int, default=15000)
    running.add_argument('--only', nargs='*')
    running.add_argument('--keep')
    running.add_argument('--out', default=RESULTS / 'engines.jsonl')
    commands.add_parser('page')
    options = parser.parse_args()
    if options.command == 'run':
        rows = run(options.daylight, options.cylinders, options.shapes, options.only, options.keep)
        pathlib.Path(options.out).write_text(''.join(json.dumps(row) + '\n' for row in rows))


if __name__ == '__main__':
    main()
