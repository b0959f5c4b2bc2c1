#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks every certificate in a file of answers in exact rational arithmetic, with nothing but Python's standard library.

    verify_answers.py PAIRS.jsonl ANSWERS.jsonl

PAIRS holds a pair a line, ANSWERS what `daylight check` said of each. Coordinates of a certificate are doubles, lists of
doubles (their exact sum) or strings "n/d". Solids are closed; a direction proves that they are apart where its support gap
f(D) is below 0, a point that they meet where it lies in both. A solid with `rounding` is its core grown by a ball: then f
has the roundings times |D|, a point lies in both cores, and `points` show that they meet where one lies in each core and
they are no farther apart than both roundings. An answer with a `clearance` has it in the rounding of a. `hulls` names with a point the subspaces that it is to be
taken to: the point of the first solid's hull and the second's that is nearest to it, exactly. Of an enclosure of the
distance only its order and its sign are checked. Prints each certificate that fails; exit status 2 where one does.
"""
import json
import sys
from collections import Counter
from fractions import Fraction
from math import isqrt

DIGITS = (400, 2000, 9000)  # bits of a square root, one after the other where fewer show nothing


def exact(value):
    if isinstance(value, list):
        return sum(map(exact, value), Fraction(0))
    return Fraction(value)


def vector(values):
    x, y, z = values
    return [exact(x), exact(y), exact(z)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def root_above(square, bits):
    """Not below the root, by a relative 2^-bits at most."""
    if square == 0:
        return Fraction(0)
    shift = max(0, 2 * bits - (square.numerator.bit_length() - square.denominator.bit_length()))
    shift += shift % 2
    return Fraction(isqrt((square.numerator << shift) // square.denominator) + 1, 1 << (shift // 2))


def room(pair):
    return exact(pair['a'].get('rounding', 0)) + exact(pair['b'].get('rounding', 0))


def separates(pair, direction):
    d = vector(direction)
    between = [q - p for p, q in zip(vector(pair['a']['center']), vector(pair['b']['center']))]
    for bits in DIGITS:
        reach = Fraction(0)
        for solid in (pair['a'], pair['b']):
            w = vector(solid['axis'])
            across = cross(d, w)
            reach += exact(solid['radius']) * root_above(dot(across, across) / dot(w, w), bits)
            reach += exact(solid['height']) / 2 * root_above(dot(d, w) ** 2 / dot(w, w), bits)
        reach += room(pair) * root_above(dot(d, d), bits)
        if any(d) and reach < abs(dot(d, between)):
            return True
    return False


def equations(solid, hull):
    """Of the points of a hull: rows (n, k), n.x = k."""
    w, c = vector(solid['axis']), vector(solid['center'])
    if hull == 'space':
        return []
    if hull == 'plane':
        return [(w, dot(w, c))]
    units = [[Fraction(i == j) for j in range(3)] for i in range(3)]
    normals = [n for n in (cross(w, unit) for unit in units) if any(n)] if hull == 'line' else units
    return [(n, dot(n, c)) for n in normals]


def nearest(point, rows):
    """The point nearest to `point` that satisfies the equations; None where none does."""
    basis = []  # square to each other
    x = list(point)
    for n, k in rows:
        for m in basis:
            n, k = [a - dot(n, m) / dot(m, m) * b for a, b in zip(n, m)], k - dot(n, m) / dot(m, m) * dot(m, x)
        if not any(n):
            if k != 0:
                return None
            continue
        share = (k - dot(n, x)) / dot(n, n)
        x = [a + share * b for a, b in zip(x, n)]
        basis.append(n)
    return x


def in_both(pair, point, hulls):
    x = nearest(vector(point), equations(pair['a'], hulls[0]) + equations(pair['b'], hulls[1]))
    return x is not None and in_core(pair['a'], x) and in_core(pair['b'], x)


def in_core(solid, x):
    w = vector(solid['axis'])
    from_center = [p - q for p, q in zip(x, vector(solid['center']))]
    across = cross(from_center, w)
    return (dot(from_center, w) ** 2 <= (exact(solid['height']) / 2) ** 2 * dot(w, w)
            and dot(across, across) <= exact(solid['radius']) ** 2 * dot(w, w))


def come_near(pair, points, hulls, slack=0):
    """Whether a point of each core, grown by the slack already, is as near to the other as both roundings and the slack."""
    x, y = (nearest(vector(p), equations(pair[k], hull)) for k, p, hull in zip('ab', points, hulls))
    between = [p - q for p, q in zip(x, y)]
    return (in_core(pair['a'], x) and in_core(pair['b'], y)
            and dot(between, between) <= (room(pair) + slack) ** 2)


def nearly_touch(pair, near):
    """Whether they do within 2^-200 of their size, which is all that a certificate of an irrational point says."""
    slack = (sum(exact(pair[k][length]) for k in 'ab' for length in ('radius', 'height')) + room(pair)) / 2**200

    def resized(by):
        return {k: dict(pair[k], radius=max(Fraction(0), exact(pair[k]['radius']) + by),
                        height=max(Fraction(0), exact(pair[k]['height']) + 2 * by)) for k in 'ab'}
    space = ('space', 'space')
    met = (come_near(resized(slack), near['points'], space, slack) if 'points' in near
           else in_both(resized(slack), near['point'], space))
    if not met:
        return False
    shrunk = resized(-slack)
    if room(pair) == 0:
        return separates(shrunk, near['direction'])
    side = 'a' if exact(pair['a'].get('rounding', 0)) > 0 else 'b'
    shrunk[side] = dict(shrunk[side], rounding=exact(pair[side]['rounding']) - slack)
    return separates(shrunk, near['direction'])


def widened(pair, clearance):
    """The pair that an answer with a clearance speaks of: with that in the rounding of a, rounded to a double."""
    return dict(pair, a=dict(pair['a'], rounding=float(pair['a'].get('rounding', 0)) + float(clearance)))


def fault(pair, answer):
    """What is wrong with an answer's certificate, in words; None where nothing is."""
    pair = widened(pair, answer.get('clearance', 0))
    verdict = answer.get('verdict')
    if verdict == 'invalid':
        return None if answer.get('error') else 'invalid without an error'
    if verdict not in ('disjoint', 'intersecting', 'touching', 'undecided'):
        return f'no verdict: {verdict!r}'
    if verdict == 'disjoint' and not separates(pair, answer['direction']):
        return 'the direction does not separate'
    if verdict == 'touching' and 'near' in answer:
        if not nearly_touch(pair, answer['near']):
            return 'not within 2^-200 of touching'
    elif 'points' in answer and verdict in ('intersecting', 'touching'):
        if not come_near(pair, answer['points'], answer.get('hulls', ('space', 'space'))):
            return 'the points are not in the cores, or farther apart than the roundings'
    elif verdict in ('intersecting', 'touching') and not in_both(pair, answer['point'], answer.get('hulls', ('space', 'space'))):
        return 'the point is not in both solids'
    if 'distance' in answer:
        low, high = map(exact, answer['distance'])
        if low > high or verdict == 'disjoint' and high <= 0 or verdict == 'intersecting' and low > 0:
            return 'the distance contradicts the verdict'
    return None


def read(path):
    with open(path, encoding='utf-8') as file:
        return [json.loads(line) for line in file if line.strip()]


def main(pairs, answers):
    if len(pairs) != len(answers):
        sys.exit(f'{len(pairs)} pairs, {len(answers)} answers')
    failed = 0
    for number, (pair, answer) in enumerate(zip(pairs, answers), 1):
        try:
            why = fault(pair, answer)
        except (KeyError, TypeError, ValueError, ZeroDivisionError, OverflowError) as error:
            why = f'malformed: {error!r}'
        if why:
            failed += 1
            print(f'line {number}: {answer.get("verdict")}: {why}')
    print(dict(Counter(answer.get('verdict') for answer in answers)), f'{failed} certificates fail')
    return 2 if failed else 0


if __name__ == '__main__':
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    sys.exit(main(read(sys.argv[1]), read(sys.argv[2])))
