#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What `bench --json` measured of our methods, a row of Markdown for each family.

    bench/family_table.py BENCH.json

Times are medians in nanoseconds a pair; x is their ratio. Last come the geometric means over the families.
"""
import json
import math
import sys

HEAD = ['family', 'yes/no', 'p99', 'x fastest right', 'batch', 'certificate', 'x yes/no', 'batch', 'distance', 'depth']


def number(x, digits=0):
    """Returns a dash where nothing was measured."""
    return '-' if x is None else f'{x:.{digits}f}'


def tables(document):
    """Yields each family with its rows, and how many times as long as ours the fastest right library takes."""
    against = {c['family']: c['right']['ratio'] for c in document['summary']['verdict']['families']
               if c['method'] == 'intersect' and c['right']}
    families = {}
    for row in document['results']:
        families.setdefault(row['family'], {})[row['method'], row['query']] = row
    for family, rows in families.items():
        yield family, rows, against.get(family)


def mean(ratios):
    """Returns the geometric mean of what is not None."""
    logs = [math.log(x) for x in ratios if x]
    return math.exp(sum(logs) / len(logs)) if logs else None


def lines(document):
    """Yields the table."""
    yield '| ' + ' | '.join(HEAD) + ' |'
    yield '| --- |' + ' ---: |' * (len(HEAD) - 1)
    certified, faster = [], []
    for family, rows, against in tables(document):
        def time(method, query):
            return rows.get((method, query), {}).get('median_ns')  # pylint: disable=cell-var-from-loop
        verdict, certificate = time('intersect', 'verdict'), time('decide', 'certificate')
        certified.append(certificate / verdict if certificate else None)
        faster.append(against)
        cells = [number(verdict, 1), number(rows['intersect', 'verdict']['p99_ns']), number(against, 1),
                 number(time('intersect', 'batch'), 1), number(certificate), number(certified[-1], 1),
                 number(time('decide', 'batch')), number(time('distance', 'distance')), number(time('distance', 'depth'))]
        yield f'| {family} | ' + ' | '.join(cells) + ' |'
    yield f'| geometric mean | | | {number(mean(faster), 1)} | | | {number(mean(certified), 1)} | | | |'


if __name__ == '__main__':
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    with open(sys.argv[1], encoding='utf-8') as file:
        print('\n'.join(lines(json.load(file))))
