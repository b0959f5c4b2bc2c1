#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compares the engines of this folder on pairs of ordinary size, and writes docs/results/engines.md.

    compare.py run DAYLIGHT [--keep DIR]   asks all engines, writes engines.jsonl and the page (minutes)
    compare.py page                                        prints the page of docs/results/engines.jsonl

An answer is wrong beyond the claim if the distance that daylight proved exceeds the engine's tolerance. The engine's
own solid lies inside the cylinder and holds an inner one, which its hello states. Wrong for both is the algorithm's
fault. Wrong for the cylinder alone may be the model's.
"""
import argparse
import datetime
import json
import pathlib
import re
import statistics
import subprocess
import sys
import textwrap
from collections import Counter, defaultdict

import picture

HERE = pathlib.Path(__file__).resolve().parent
RESULTS = HERE.parents[1] / 'docs/results'
ENGINES = ('rapier', 'jolt', 'physx', 'havok', 'ammo', 'cannon', 'crashcat', 'oimo')
CYLINDERS = ('random,touching_cap_cap,touching_cap_side,touching_parallel_sides,touching_cap_rim,touching_side_side,'
             'touching_side_rim,touching_rim_rim,axes_parallel,axes_nearly_parallel,axes_perpendicular,axes_crossing,'
             'contained,coaxial,equal')
SHAPES = ('sphere_sphere,sphere_capsule,sphere_cylinder,sphere_rounded,capsule_capsule,capsule_cylinder,'
          'capsule_rounded,cylinder_rounded,rounded_rounded')
EXTREMES = ('needles,disks,needle_and_disk,segments,flat_disks,points,far,mixed_scale,tiny_and_huge,touching_needles,'
            'touching_disks,coins_edge_to_edge')
# An engine that contains a packaged library: the method that asks this library in the same way, and the one without
# the library's collision margin.
PACKAGED = {'ammo': ('bullet-cylinder', 'bullet-cylinder-margin0')}
LENGTHS = ('radius', 'height', 'rounding')
TWO_CYLINDERS = 'cylinder - cylinder'
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


def draw_any(daylight, families, count):
    return lines_of([daylight, 'ask', '--seed', '1', '--cases', '', '--families', families, '--pairs', str(count)], '')


def draw(daylight, families, count):
    return [p for p in draw_any(daylight, families, count) if ordinary(p)]


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
            raise RuntimeError(f'{command} does not start')
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
    worst, from_margin = None, 0
    for pair, truth, own, answer, found in judged:
        margin = min(map(abs, truth['distance'])) / sum(lengths(pair))
        verdict = answer.get('verdict')
        if verdict and verdict != truth['verdict'] and truth['verdict'] != 'touching':
            from_margin = max(from_margin, margin)
        if found is None or found[0] not in ('intersecting', 'disjoint'):
            continue
        by_kinds[kinds_of(pair)][found[1]] += 1
        own_margin = min(map(abs, own['distance'])) / sum(lengths(pair)) if verdict == 'disjoint' else margin
        if found[1] == 'algorithm' and (worst is None or own_margin > worst['margin']):
            worst = {'margin': own_margin, 'pair': {k: pair[k] for k in 'ab'}, 'said': verdict,
                     'truth': truth['verdict'], 'distance': truth['distance'],
                     'proof': {k: truth[k] for k in ('direction', 'point') if k in truth}}
    times = [answer['ns'] for *_, answer, _ in judged if 'ns' in answer]
    return {
        'name': hello['name'], 'package': package, 'claim': hello['claim'], 'model': hello['model'],
        'takes': hello['takes'], 'answered': len(judged), 'asked': dict(sorted(asked.items())),
        'faults': {f'{fault}/{whose}': n for (fault, whose), n in sorted(faults.items())},
        'verdicts': {k: dict(v) for k, v in sorted(by_kinds.items())}, 'wrong_below': from_margin,
        'worst': worst, 'distances': any('distance' in answer for *_, answer, _ in judged),
        'date': datetime.date.today().isoformat(), 'ns': round(statistics.median(times), -2) if times else None,
    }


def of_extremes(judged):
    """Counts without blame: a margin may be larger than such a solid."""
    faults = [found[0] for *_, found in judged if found]
    return {'answered': len(judged), 'wrong': sum(f in ('intersecting', 'disjoint') for f in faults),
            'failed': sum(f in ('crash', 'hang', 'error') for f in faults)}


def package_of(engine):
    """Name and version of the npm package that a guest imports."""
    names = json.loads((HERE / 'package.json').read_text())['dependencies']
    source = (HERE / f'{engine}.mjs').read_text()
    return next(f'{name} {version}' for name, version in names.items() if f"'{name}'" in source)


def compared(daylight, command, pairs, truths, folder=HERE):
    """The hello of an engine, and (pair, truth, own, answer, fault) of each pair that it takes. `own` is the truth
    about its inner solids, with these."""
    hello, _ = ask(command, pairs[:1], folder)
    mine = [(p, t) for p, t in zip(pairs, truths) if all(kind_of(p[k]) in hello['takes'] for k in 'ab')]
    pairs, truths = zip(*mine)
    inner = hello.get('model', {}).get('inner')
    solids = inner_pairs(pairs, inner) if inner else pairs
    owns = [dict(t, solids=s) for t, s in zip(proved(daylight, solids) if inner else truths, solids)]
    _, answers = ask(command, pairs, folder)
    return hello, list(judge(hello, pairs, truths, owns, answers))


def shared(daylight, methods, judged):
    """How many wrong verdicts about two cylinders the packaged methods give too."""
    wrong = [x for x in judged if x[4] and x[4][0] in ('intersecting', 'disjoint') and kinds_of(x[0]) == TWO_CYLINDERS]
    text = subprocess.run([daylight, 'replay', '-', '--methods', ','.join(methods)], text=True, capture_output=True,
                          input=to_text(x[0] for x in wrong), check=False).stdout
    said = {m: re.findall(rf'^ +{re.escape(m)} +.*?"verdict":"(\w+)"', text, re.MULTILINE) for m in methods}
    return {'wrong': len(wrong), 'methods': {
        method: sum(verdict == x[3]['verdict'] for x, verdict in zip(wrong, verdicts, strict=True))
        for method, verdicts in said.items()}}


def run(daylight, cylinders, shapes, extremes, only, keep):
    pairs = draw(daylight, CYLINDERS, cylinders) + draw(daylight, SHAPES, shapes)
    extreme = draw_any(daylight, EXTREMES, extremes)
    truths, extreme_truths, rows = proved(daylight, pairs), proved(daylight, extreme), []
    for engine in only or ENGINES:
        command = ['node', str(HERE / f'{engine}.mjs'), '--time']
        hello, judged = compared(daylight, command, pairs, truths)
        beyond = of_extremes(compared(daylight, command, extreme, extreme_truths)[1])
        rows.append({**summary(hello, package_of(engine), judged), 'extremes': beyond})
        if engine in PACKAGED:
            rows[-1]['shared'] = shared(daylight, PACKAGED[engine], judged)
        if keep:
            keep_findings(pathlib.Path(keep), engine, judged)
        print(engine, rows[-1]['answered'], rows[-1]['faults'], file=sys.stderr)
    return rows


def keep_findings(folder, engine, judged):
    """Writes up to ten wrong answers with the certificates, for exact.py: the algorithm's before the model's, verdicts
    before distances. If the algorithm said disjoint, the proof is about the inner solids."""
    folder.mkdir(parents=True, exist_ok=True)
    wrong = [x for x in judged if x[4] and 'verdict' in x[3]]
    wrong.sort(key=lambda x: (x[4][1] == 'model', x[4][0] in ('distance', 'depth'), -min(map(abs, x[1]['distance']))))
    with open(folder / f'{engine}.pairs.jsonl', 'w') as to, open(folder / f'{engine}.answers.jsonl', 'w') as proofs:
        for pair, truth, own, answer, (_, whose) in wrong[:10]:
            inner = whose == 'algorithm' and own['verdict'] != 'disjoint' and answer['verdict'] == 'disjoint'
            to.write(to_text([own['solids'] if inner else pair]))
            proofs.write(json.dumps(own if inner else truth) + '\n')


HEAD = """# Engines of npm

For readers who ask which engine to trust with cylinders. `oracles/guests/compare.py` asked {count} engines on {date},
and wrote this page from [its data](engines.jsonl). All lengths of a pair are 0.1 to 10 m, and most pairs nearly touch.
Extreme pairs have a section of their own.

    oracles/guests/compare.py run build/release/daylight --keep kept
    python/vectors/daylight_vectors/exact.py kept/physx.pairs.jsonl kept/physx.answers.jsonl

The second command checks the proofs of up to ten wrong answers of an engine with exact arithmetic.

* *claim* is the tolerance, the relative part times the size of the pair. If an engine states none, we assume one.
* *beyond claim* counts wrong verdicts that the tolerance does not cover. They are wrong even for the solid that the
  engine collides, so the *algorithm* is at fault.
* *model* counts wrong verdicts beyond the tolerance which may be right for the solid that the engine collides. An
  engine that collides prisms gives them on purpose.
* *right from* is the margin, relative to the size, above which no verdict was wrong.
* *distances* and *depths* count wrong ones beyond the tolerance and 1e-5 of the distance, algorithm + model. A dash
  means that we did not ask the engine for them.
* *time* is the median for a pair in Node.js, in microseconds, with the making of both solids. The machine was shared.

"""


EXTREME_PAIRS = """
## Extreme pairs

Needles, disks, points, and solids that are far away, very small or very large. Wrong verdicts beyond the claim are
counted without blame, because the margin of an engine may be larger than such a solid. The guests decline lengths that
single precision cannot hold, and shapes that the engine refuses to make.

"""


def count_of(row, kinds, whose):
    return sum(row['faults'].get(f'{kind}/{whose}', 0) for kind in kinds)


def table(titles, rows):
    sides = ['---' if i == 0 or isinstance(rows[0][i], str) else '---:' for i in range(len(titles))]
    return ''.join('| ' + ' | '.join(map(str, cells)) + ' |\n' for cells in [titles, sides, *rows])


def claim_in_words(row):
    claim = row['claim']
    return f'{claim["relative"]:g} size + {claim["absolute"]:g}'


def shared_in_words(row):
    wrong, ((same, both), (without, left)) = row['shared']['wrong'], row['shared']['methods'].items()
    text = (f'{row["package"]} contains Bullet. The method `{same}`, which asks the packaged Bullet in double '
            f'precision, gives {both} of the {wrong} wrong verdicts about two cylinders too. `{without}` sets the '
            f'collision margin to 0 and gives {left} of them.')
    if both == wrong and left == 0:
        text += ' So all of them have one cause, the margin that rounds the rims.'
    return '\n## Shared with a packaged library\n\n' + textwrap.fill(text, 120, break_on_hyphens=False) + '\n'


def picture_of(row):
    return picture.svg(row['worst']['pair'], f'{row["name"]} returns {row["worst"]["said"]}')


def page(rows):
    verdicts, broken = ('intersecting', 'disjoint'), ('crash', 'hang', 'error')
    parts = [HEAD.format(count=len(rows), date=rows[0]['date'])]

    def values(row, kind):
        if not row['distances']:
            return '-'
        return f'{count_of(row, [kind], "algorithm")} + {count_of(row, [kind], "model")}'
    parts.append(table(
        ['engine', 'pairs', 'beyond claim', 'model', 'right from', 'distances', 'depths', 'failed', 'time'],
        [[row['package'], row['answered'], count_of(row, verdicts, 'algorithm'), count_of(row, verdicts, 'model'),
          f'{row["wrong_below"]:.1e}', values(row, 'distance'), values(row, 'depth'),
          count_of(row, broken, 'algorithm'), f'{row["ns"] / 1000:.0f}'] for row in rows]))
    parts.append('\n*failed* counts crashes, hangs and errors that the engine reported.\n\n'
                 '## What they claim and collide\n\n')
    parts.append(table(['engine', 'claim', 'source', 'its cylinder', 'precision'],
                       [[row['name'], claim_in_words(row), row['claim']['source'], row['model']['text'],
                         row['model']['precision']] for row in rows]))
    parts.append('\n## By shape pair\n\nWrong verdicts beyond the claim: algorithm + model, of pairs. '
                 'A dash means that the engine was not asked.\n\n')
    kinds = sorted({kind for row in rows for kind in row['asked']})

    def cell(row, kind):
        wrong = row['verdicts'].get(kind, {})
        if kind not in row['asked']:
            return '-'
        return f'{wrong.get("algorithm", 0)} + {wrong.get("model", 0)} of {row["asked"][kind]}'
    parts.append(table(['', *(row['name'] for row in rows)],
                       [[kind, *(cell(row, kind) for row in rows)] for kind in kinds]))
    parts.append(EXTREME_PAIRS)
    parts.append(table(['engine', 'pairs', 'wrong', 'failed'],
                       [[row['name'], *(row['extremes'][k] for k in ('answered', 'wrong', 'failed'))] for row in rows]))
    parts += [shared_in_words(row) for row in rows if 'shared' in row]
    parts.append('\n## The worst pair of each engine\n\nThe algorithm\'s wrong verdict with the largest margin. '
                 'The last line is the proof: a common point, or the '
                 'direction\nnormal to a plane between both. `daylight check --distance` repeats it.\n\n')
    for row in rows:
        worst = row['worst']
        if not worst:
            parts.append(f'* {row["name"]}: none.\n')
            continue
        pair, proof = (json.dumps(worst[k], separators=(',', ':')) for k in ('pair', 'proof'))
        parts.append(f'* {row["name"]} returns {worst["said"]}. The pair is {worst["truth"]}, its signed distance is '
                     f'{worst["distance"][0]:.3g}.\n\n  ![The pair of {row["name"]}](engines/{row["name"]}.svg)\n\n'
                     f'      {pair}\n      {proof}\n\n')
    return ''.join(parts).rstrip('\n') + '\n'


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest='command', required=True)
    running = commands.add_parser('run')
    running.add_argument('daylight')
    running.add_argument('--cylinders', type=int, default=30000)
    running.add_argument('--shapes', type=int, default=15000)
    running.add_argument('--extremes', type=int, default=2400)
    running.add_argument('--only', nargs='*')
    running.add_argument('--keep')
    running.add_argument('--out', default=RESULTS / 'engines.jsonl')
    commands.add_parser('page')
    options = parser.parse_args()
    if options.command == 'run':
        rows = run(options.daylight, options.cylinders, options.shapes, options.extremes, options.only, options.keep)
        pathlib.Path(options.out).write_text(''.join(json.dumps(row) + '\n' for row in rows))
        pathlib.Path(options.out).with_suffix('.md').write_text(page(rows))
        folder = pathlib.Path(options.out).with_suffix('')
        folder.mkdir(exist_ok=True)
        for row in rows:
            if row['worst']:
                (folder / f'{row["name"]}.svg').write_text(picture_of(row))
    else:
        print(page([json.loads(line) for line in (RESULTS / 'engines.jsonl').read_text().splitlines()]), end='')


if __name__ == '__main__':
    main()
