#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""lint.py FILE.. proves vectors: each verdict, and in v1 each end of a distance that has a certificate. Exit status: 0
if nothing is wrong, else 2."""
import sys

import exact
from daylight_vectors import load
from exact import DIGITS


def wrong_distance(v):
    """The fault of an end of a distance of v1, or None."""
    proof, (low, high) = v['certificate'], map(exact.exact, v['distance'])
    if v['result'] == 'touching':
        if low or high:
            return 'touching at a distance'
        if 'near' not in proof and exact.gap(v, proof['direction'], DIGITS[0]) < 0:
            return 'the direction does not show that they only touch'
        return None
    if not any(exact.gap(v, proof['direction'], bits) >= low for bits in DIGITS):
        return 'the direction does not prove the lower end of the distance'
    near = proof.get('nearest')
    if near and not exact.come_near(v, near['points'], near.get('hulls', exact.SPACE), high):
        return 'the nearest points do not prove the upper end of the distance'
    return None


def wrong(v):
    """The fault of a vector in words, or None."""
    if 'answer' in v:
        return exact.fault(v, v['answer'])
    if v['result'] == 'invalid':
        return None if exact.defect(v) else 'the pair is valid'
    proof = v['certificate']
    of_distance = {'disjoint': {'nearest'}, 'intersecting': {'direction', 'nearest'},
                   'touching': set() if 'near' in proof else {'direction'}}.get(v['result'], set())
    answer = {part: proof[part] for part in proof.keys() - of_distance}
    return exact.fault(v, answer | {'verdict': v['result'], 'distance': v['distance']}) or wrong_distance(v)


def lint(vectors):
    """Yields a line for each vector that is wrong."""
    for v in vectors:
        try:
            why = wrong(v)
        except (KeyError, TypeError, ValueError, ZeroDivisionError, OverflowError) as error:
            why = f'malformed: {error!r}'
        if why:
            yield f'{v.get("id")}: {why}'


def main(files):
    found = [f'{file}: {line}' for file in files for line in lint(load(file)['vectors'])]
    print(*found, f'{len(found)} wrong', sep='\n')
    return 2 if found else 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]) if sys.argv[1:] else __doc__)
