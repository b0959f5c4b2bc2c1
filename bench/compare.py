#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compares the speed of two executables of daylight, timed by turns.

    bench/compare.py OLD_DAYLIGHT [NEW_DAYLIGHT] [--turns N] [-- OPTIONS OF bench]

Each turn runs `bench` of the old one, twice of the new one, and of the old one again, so that other work of the
machine falls on both. It prints the ratio new/old of the medians for each method, query and family: its geometric mean
over the turns, and the 95 % interval of the mean (Student's t). The exit code is 2 if the interval shows that a method
and query is slower by more than 5 % in the mean over its families. More than 15 % on one family suffices too. The exit
code is 1 if a run failed.
"""
import argparse
import json
import math
import os
import statistics
import subprocess
import sys
import tempfile

SLOWER_MEAN = 1.05  # of the geometric mean over families: what two turns of one executable differ by, and as much again
SLOWER_ROW = 1.15   # of one family, whose 2,000 pairs may fall otherwise in the cache
# Student's t for 95 %, by degrees of freedom; the last for more.
STUDENT = [12.71, 4.30, 3.18, 2.78, 2.57, 2.45, 2.36, 2.31, 2.26, 2.23, 2.20, 2.18, 2.16, 2.14, 2.13, 2.12, 2.11]


def times_of(daylight, options):
    """Returns the medians of one run, by method, query and family."""
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, 'bench.json')
        done = subprocess.run([daylight, 'bench', *options, '--json', file], stdout=subprocess.DEVNULL,
                              stderr=subprocess.PIPE, text=True, check=False)
        if not os.path.exists(file):
            sys.exit(f'{daylight} bench wrote nothing:\n{done.stderr[-2000:]}')
        with open(file, encoding='utf-8') as text:
            rows = json.load(text)['results']
    return {(row['method'], row['query'], row['family']): row['median_ns'] for row in rows if row['median_ns']}


def interval(logarithms):
    """Returns the geometric mean and its 95 % interval."""
    mean, n = statistics.fmean(logarithms), len(logarithms)
    if n < 2:
        return math.exp(mean), 0.0, math.inf
    off = STUDENT[min(n - 1, len(STUDENT)) - 1] * statistics.stdev(logarithms) / math.sqrt(n)
    return math.exp(mean), math.exp(mean - off), math.exp(mean + off)


def main():
    arguments, options = sys.argv[1:], []
    if '--' in arguments:
        cut = arguments.index('--')
        arguments, options = arguments[:cut], arguments[cut + 1:]
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('old')
    here = os.path.dirname(os.path.abspath(__file__))
    parser.add_argument('new', nargs='?', default=os.path.join(here, '..', 'daylight'))
    parser.add_argument('--turns', type=int, default=5)
    given = parser.parse_args(arguments)
    options = options or ['--methods', 'intersect,decide,distance', '--families', 'all', '--passes', '3',
                          '--min-time', '0.01']
    turns = []
    for i in range(given.turns):
        print(f'turn {i + 1} of {given.turns}', file=sys.stderr, flush=True)
        runs = [times_of(daylight, options) for daylight in (given.old, given.new, given.new, given.old)]
        turns.append(((runs[0], runs[3]), (runs[1], runs[2])))
    keys = [key for key in turns[0][0][0] if all(key in run for turn in turns for runs in turn for run in runs)]
    if not keys:
        sys.exit('the two have no row in common')
    slower = []
    print(f'{"method":24} {"query":12} {"family":24} {"old ns":>8} {"new/old":>8}  95 % interval')
    for what in dict.fromkeys(key[:2] for key in keys):
        rows = [key for key in keys if key[:2] == what]
        logs = {key: [sum(math.log(new[key] / old[key]) for old, new in zip(*turn)) / 2 for turn in turns]
                for key in rows}
        for key in [None, *rows]:
            values = logs[key] if key else [statistics.fmean(logs[k][i] for k in rows) for i in range(len(turns))]
            ratio, low, high = interval(values)
            bad = low > (SLOWER_ROW if key else SLOWER_MEAN)
            old = f'{statistics.median(run[key] for turn in turns for run in turn[0]):8.1f}' if key else ' ' * 8
            name = key[2] if key else f'({len(rows)} families)'
            verdict = '  slower' if bad else ''
            print(f'{what[0]:24} {what[1]:12} {name:24} {old} {ratio:8.3f}  [{low:.3f}, {high:.3f}]{verdict}')
            slower += [f'{what[0]} ({what[1]}), {name}'] if bad else []
    print('slower: ' + '; '.join(slower) if slower else 'nothing is slower')
    return 2 if slower else 0


if __name__ == '__main__':
    sys.exit(main())
