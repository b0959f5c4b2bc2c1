#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Proves facts of two solids in rational arithmetic, with nothing but Python's standard library.

    exact.py                            proves the CLAIMS below; exit status 1 if that fails
    exact.py PAIRS.jsonl ANSWERS.jsonl  checks answers of `daylight check`; exit status 2 if a certificate fails

A cylinder is solid and closed. It has center, axis (of any length), radius, full height, and rounding. It is all
points within the rounding of the cylinder proper, its core. A sphere and a capsule are rounded points and segments. A
half-space has a point of its plane and the outward normal. A box has center, edges (three full lengths), a quaternion
(of any length) and rounding. Floats are taken exactly. A coordinate of a certificate may also be a list of floats
(their exact sum) or a string "n/d".

A direction proves that two solids are apart if planes square to it show a gap. A point proves that they meet if it lies
in both cores. Two `points` prove it if one lies in each core, no farther apart than both roundings together. A point
with `hulls` stands for the point nearest to it in the hulls of both solids, which are subspaces. A flat box always has
the hull of its edges that are not 0. They touch if they meet there and a plane through the point has one solid on each
side: the solids have opposite normals there. `near` proves touching to within 2^-200 of the size.

A `clearance` is added to the rounding of a. If it is negative, a direction proves that the overlap is not deeper than
tolerated. A deeper overlap has no certificate: only the sign of the interval is checked, and the last line counts such
answers. An interval of the distance must have the right order and sign, and agree with the direction. An answer with a
part of another verdict's certificate is refused. A pair that is not valid has no other answer than `invalid`.
"""
import json
import re
import sys
from collections import Counter
from fractions import Fraction
from math import isfinite, isqrt

CLAIMS = []

DIGITS = (400, 2000, 9000)  # bits of a square root; more are tried only where fewer show nothing
SPACE = ('space', 'space')
# What a certificate consists of, one of the sets, by verdict; hulls come with a point or points.
CERTIFICATES = {'disjoint': [{'direction'}], 'intersecting': [{'point'}, {'points'}],
                'touching': [{'point'}, {'points'}, {'near'}]}
PARTS = {'direction', 'point', 'points', 'near'}
# A decimal or a fraction. An exponent of more digits would take all memory. The common points of boxes with
# quaternions at both ends of the range have 20,000 digits.
NUMBER = re.compile(r'-?[0-9]{1,50000}(\.[0-9]{0,4000})?(e[+-]?[0-9]{1,3})?(/[0-9]{1,50000})?')
if hasattr(sys, 'set_int_max_str_digits'):
    sys.set_int_max_str_digits(50000)


def exact(value):
    if isinstance(value, list):
        if len(value) > 8:
            raise ValueError('a sum of more than 8 numbers')
        return sum(map(exact, value), Fraction(0))
    if isinstance(value, str) and not NUMBER.fullmatch(value):
        raise ValueError(f'not a number: {value[:40]!r}')
    return Fraction(float(value) if isinstance(value, int) else value)


def vector(values):
    x, y, z = values
    return [exact(x), exact(y), exact(z)]


def minus(u, v):
    return [x - y for x, y in zip(u, v)]


def dot(u, v):
    return sum(x * y for x, y in zip(u, v))


def cross(u, v):
    return [u[i - 2] * v[i - 1] - u[i - 1] * v[i - 2] for i in range(3)]


def root(square, bits, above):
    """The square root if it is rational, else a number relatively within 2^-bits: above it if `above`, else below."""
    top, bottom = square.numerator, square.denominator
    if isqrt(top)**2 == top and isqrt(bottom)**2 == bottom:
        return Fraction(isqrt(top), isqrt(bottom))
    shift = max(0, 2 * bits + 2 - (top.bit_length() - bottom.bit_length())) // 2
    return Fraction(isqrt((top << 2 * shift) // bottom) + above, 1 << shift)


def plain(solid):
    """A box with all its fields, another solid with the fields of a cylinder. The point of a half-space becomes its
    center, and the normal its axis."""
    if not isinstance(solid, dict):
        return solid
    shape, solid = solid.get('shape', 'cylinder'), dict(solid)
    if shape == 'box':
        return {'quaternion': [1, 0, 0, 0], **solid}
    if 'quaternion' in solid and 'axis' not in solid:
        w, x, y, z = map(float, solid.pop('quaternion'))
        solid['axis'] = [2 * (x * z + w * y), 2 * (y * z - w * x), w * w - x * x - y * y + z * z]
    if shape == 'half_space':
        return {'shape': shape, 'center': solid.get('point'), 'axis': solid.get('normal'), 'radius': 0, 'height': 0}
    if shape == 'sphere':
        solid.update(axis=[0, 0, 1], height=0)
    if shape in ('sphere', 'capsule'):
        solid.update(rounding=solid.get('radius'), radius=0)
    return {key: value for key, value in solid.items() if key != 'shape'}


def is_half_space(solid):
    return solid.get('shape') == 'half_space'


def is_box(solid):
    return solid.get('shape') == 'box'


def edges(solid):
    """The unit vector along each edge of a box, and half its length. The quaternion (w, v) turns e to
    e + 2 (w (v x e) + v x (v x e)) / (w^2 + v.v), which is rational."""
    w, *v = map(exact, solid['quaternion'])
    for i, length in enumerate(solid['edges']):
        e = [Fraction(i == j) for j in range(3)]
        once, share = cross(v, e), 2 / (w * w + dot(v, v))
        yield [c + share * (w * x + y) for c, x, y in zip(e, once, cross(v, once))], exact(length) / 2


def size(pair):
    """The sum of all radii, heights, roundings and edges."""
    return sum(exact(x) for k in 'ab' for x in (*(pair[k].get(key, 0) for key in ('radius', 'height', 'rounding')),
                                                *pair[k].get('edges', ())))


def beyond(plane, x):
    """How far x is beyond the plane of a half-space, times the length of the normal."""
    return dot(vector(plane['axis']), minus(x, vector(plane['center'])))


def contact_distance(pair):
    return sum(exact(pair[k].get('rounding', 0)) for k in 'ab')


def reach(solid, d, bits, above):
    """How far the core extends along d from its centre, times |d|: of a box exactly, else a bound. The core of a
    half-space is taken as the point."""
    if is_box(solid):
        return sum(half * abs(dot(d, e)) for e, half in edges(solid))
    w = vector(solid['axis'])
    across = cross(d, w)
    return (exact(solid['radius']) * root(dot(across, across) / dot(w, w), bits, above)
            + exact(solid['height']) / 2 * root(dot(d, w)**2 / dot(w, w), bits, above))


def gap(pair, direction, bits, above=False):
    """A lower bound of the gap that planes square to the direction show, with `above` an upper one. It is below 0 if
    they cut both solids. The signed distance is never below the gap."""
    d = vector(direction)
    if not any(d):
        return Fraction(-1)
    width = dot(d, minus(vector(pair['b']['center']), vector(pair['a']['center'])))
    planes = [(sign, vector(pair[k]['axis'])) for sign, k in ((1, 'a'), (-1, 'b')) if is_half_space(pair[k])]
    if any(any(cross(d, n)) or sign * dot(d, n) < 0 for sign, n in planes):
        return Fraction(-1)  # a half-space ends in one direction only
    width = width if planes else abs(width)
    width -= reach(pair['a'], d, bits, not above) + reach(pair['b'], d, bits, not above)
    width -= contact_distance(pair) * root(dot(d, d), bits, not above)
    return width / root(dot(d, d), bits, above == (width < 0))


def separates(pair, direction, clearance=0):
    return any(gap(pair, direction, bits) > clearance for bits in DIGITS)


def equations(solid, hull):
    """The equations n.x = k of the points of a hull, as rows (n, k). A box always has its own hull."""
    c = vector(solid['center'])
    if is_box(solid):
        return [(e, dot(e, c)) for e, half in edges(solid) if half == 0]
    if hull == 'space' or is_half_space(solid):
        return []
    w = vector(solid['axis'])
    if hull == 'plane':
        return [(w, dot(w, c))]
    units = [[Fraction(i == j) for j in range(3)] for i in range(3)]
    normals = [n for n in (cross(w, unit) for unit in units) if any(n)] if hull == 'line' else units
    return [(n, dot(n, c)) for n in normals]


def nearest(point, rows):
    """The point nearest to `point` that satisfies the equations, or None if none does."""
    basis = []  # square to each other
    x = list(point)
    for n, k in rows:
        for m in basis:
            n, k = minus(n, [dot(n, m) / dot(m, m) * c for c in m]), k - dot(n, m) / dot(m, m) * dot(m, x)
        if not any(n):
            if k != 0:
                return None
            continue
        share = (k - dot(n, x)) / dot(n, n)
        x = [a + share * b for a, b in zip(x, n)]
        basis.append(n)
    return x


def in_core(solid, x):
    """Decided exactly: squares instead of square roots."""
    if is_half_space(solid):
        return beyond(solid, x) <= 0
    from_center = minus(x, vector(solid['center']))
    if is_box(solid):
        return all(abs(dot(from_center, e)) <= half for e, half in edges(solid))
    w = vector(solid['axis'])
    across = cross(from_center, w)
    return (dot(from_center, w)**2 <= (exact(solid['height']) / 2)**2 * dot(w, w)
            and dot(across, across) <= exact(solid['radius'])**2 * dot(w, w))


def in_both(pair, point, hulls=SPACE):
    x = nearest(vector(point), equations(pair['a'], hulls[0]) + equations(pair['b'], hulls[1]))
    return x is not None and in_core(pair['a'], x) and in_core(pair['b'], x)


def come_near(pair, points, hulls=SPACE, extra=0):
    """Whether a point lies in each core and the two are no farther apart than both roundings and the extra. Then the
    distance of the solids is at most the extra."""
    x, y = (nearest(vector(p), equations(pair[k], hull)) for k, p, hull in zip('ab', points, hulls))
    between, reach = minus(x, y), contact_distance(pair) + exact(extra)
    return in_core(pair['a'], x) and in_core(pair['b'], y) and reach >= 0 and dot(between, between) <= reach**2


def normals(solid, x):
    """Vectors that span the cone of the outward normals of the core at its point x, and the normals of the planes of
    the cone's faces. Inner points have none."""
    if is_half_space(solid):
        return [vector(solid['axis'])] if beyond(solid, x) == 0 else [], []
    out = minus(x, vector(solid['center']))
    if is_box(solid):
        all_edges = list(edges(solid))
        ends = [[[sign * c for c in e] for sign in (1, -1) if sign * dot(out, e) == half] for e, half in all_edges]
        return sum(ends, []), [e for i, (e, _) in enumerate(all_edges) if ends[i - 1] and ends[i - 2]]
    w = vector(solid['axis'])
    along, height, radius = dot(out, w), exact(solid['height']), exact(solid['radius'])
    across = minus(out, [along / dot(w, w) * c for c in w])
    on_cap, on_wall = along**2 == (height / 2)**2 * dot(w, w), dot(across, across) == radius**2
    ends = [[sign * c for c in w] for sign in (1, -1) if height == 0 or sign * along > 0] if on_cap else []
    if not on_wall:
        return ends, []
    if radius > 0:
        return [*ends, across], [cross(w, across)] if ends else []
    units = ([Fraction(i == j) for j in range(3)] for i in range(3))
    sides = [n for n in (cross(w, unit) for unit in units) if any(n)]
    return [*ends, *sides, *([-c for c in n] for n in sides)], [w]


def supports(solid, x, n):
    """Whether no point of the core lies farther along n than its point x."""
    if is_half_space(solid):
        w = vector(solid['axis'])
        return beyond(solid, x) == 0 and not any(cross(n, w)) and dot(n, w) > 0
    out = minus(x, vector(solid['center']))
    if is_box(solid):
        return dot(n, out) == reach(solid, n, 0, False)
    w = vector(solid['axis'])
    across = minus(n, [dot(n, w) / dot(w, w) * c for c in w])
    along, beside = dot(n, w) * dot(out, w), dot(across, out)
    return (along >= 0 and along**2 == dot(n, w)**2 * (exact(solid['height']) / 2)**2 * dot(w, w)
            and beside >= 0 and beside**2 == dot(across, across) * exact(solid['radius'])**2)


def touch_at(pair, x, y):
    """Whether the solids, which meet, share no inner point. Either x and y, points of the cores, are nearest to each
    other and as far apart as both roundings. Or they are one point in which the cores have opposite normals."""
    between = minus(y, x)
    if any(between) or contact_distance(pair) > 0:
        return (dot(between, between) == contact_distance(pair)**2 and supports(pair['a'], x, between)
                and supports(pair['b'], y, minus(x, y)))
    (spans_a, planes_a), (spans_b, planes_b) = normals(pair['a'], x), normals(pair['b'], x)
    tried = spans_a + [[-c for c in n] for n in spans_b]
    tried += [n for p in planes_a for q in planes_b for n in (cross(p, q), cross(q, p))]
    return any(any(n) and supports(pair['a'], x, n) and supports(pair['b'], x, [-c for c in n]) for n in tried)


def fields(solid):
    """The lists of a solid, with how many numbers each has, and its lengths."""
    if is_box(solid):
        return {'center': 3, 'edges': 3, 'quaternion': 4}, ('rounding',)
    return {'center': 3, 'axis': 3}, ('radius', 'height', 'rounding')


def defect(pair):
    """Why a pair is not valid, in words, or None if it is."""
    if not isinstance(pair, dict):
        return 'it is no object'
    for side in 'ab':
        solid = pair.get(side)
        if not isinstance(solid, dict):
            return f'{side} is missing'
        lists, lengths = fields(solid)
        for key, count in lists.items():
            value = solid.get(key)
            if not isinstance(value, (list, tuple)) or len(value) != count or not all(map(is_number, value)):
                return f'{side}.{key} is not {count} numbers'
        turn = 'quaternion' if is_box(solid) else 'axis'
        if not any(solid[turn]):
            return f'{side}.{turn} is zero'
        given = [(key, solid.get(key, 0 if key == 'rounding' else None)) for key in lengths]
        for key, value in given + [('edges', x) for x in (solid['edges'] if is_box(solid) else ())]:
            if not is_number(value) or value < 0:
                return f'{side}.{key} is not a length'
    return 'both are half-spaces' if is_half_space(pair['a']) and is_half_space(pair['b']) else None


def is_number(value):
    """Whether the value is a number that a double holds."""
    try:
        return isinstance(value, (int, float)) and not isinstance(value, bool) and isfinite(float(value))
    except OverflowError:
        return False


def nearly_touch(pair, near):
    slack = size(pair) / 2**200

    def grown(solid, by):
        if is_half_space(solid):  # the plane moves by a little more
            n = vector(solid['axis'])
            share = by / root(dot(n, n), DIGITS[0], False)
            return dict(solid, center=[x + share * y for x, y in zip(vector(solid['center']), n)])
        if is_box(solid):
            return dict(solid, edges=[max(Fraction(0), exact(x) + 2 * by) for x in solid['edges']])
        return dict(solid, radius=max(Fraction(0), exact(solid['radius']) + by),
                    height=max(Fraction(0), exact(solid['height']) + 2 * by))

    def resized(by):
        return {k: grown(pair[k], by) for k in 'ab'}
    if not (come_near(resized(slack), near['points'], SPACE, slack) if 'points' in near
            else in_both(resized(slack), near['point'])):
        return False
    shrunk = resized(-slack)
    if contact_distance(pair) > 0:
        side = 'a' if exact(pair['a'].get('rounding', 0)) > 0 else 'b'
        shrunk[side]['rounding'] = exact(pair[side]['rounding']) - slack
    return separates(shrunk, near['direction'])


def is_uncertified(answer):
    """Whether the answer may have no certificate: it is to a negative clearance, and has none."""
    return answer.get('clearance', 0) < 0 and not PARTS & set(answer)


def fault(pair, answer):
    """The fault of an answer and its certificate in words, or None."""
    if isinstance(pair, dict):
        pair = {key: plain(value) if key in ('a', 'b') else value for key, value in pair.items()}
    verdict, why = answer.get('verdict'), defect(pair)
    if verdict == 'invalid':
        if not why and all(set(pair[k]) <= {'shape'}.union(*fields(pair[k])) for k in 'ab'):
            return 'the pair is valid'
        return None if answer.get('error') else 'invalid without an error'
    if why:
        return f'the pair is not valid: {why}'
    if verdict not in ('disjoint', 'intersecting', 'touching', 'undecided'):
        return f'no verdict: {verdict!r}'
    parts, possible = PARTS & set(answer), CERTIFICATES.get(verdict, [set()])
    if parts not in possible and (parts or not is_uncertified(answer)):
        return f'a certificate of {sorted(parts)}, which does not belong to the verdict' if parts else 'no certificate'
    if 'hulls' in answer and not parts & {'point', 'points'}:
        return 'hulls without a point'
    if 'clearance' in answer:
        if not is_number(answer['clearance']):
            return 'the clearance is not a length'
        if answer['clearance'] < 0:
            if 'distance' not in answer:
                return 'a negative clearance has no distance'
            low, high = map(exact, answer['distance'])
            tolerated = exact(answer['clearance'])
            if parts - ({'direction'} if verdict == 'disjoint' else set()):
                return f'a certificate of {sorted(parts)}, which does not prove how deep they overlap'
            if 'direction' in answer and not separates(pair, answer['direction'], tolerated):
                return 'the direction does not show that the overlap is tolerated'
            agrees = {'disjoint': 0 < low, 'intersecting': high < 0}.get(verdict, verdict == 'undecided')
            return None if low <= high and agrees else 'the distance contradicts the verdict'
        side = 'b' if is_half_space(pair['a']) else 'a'
        rounding = exact(pair[side].get('rounding', 0)) + exact(answer['clearance'])
        pair = {**pair, side: dict(pair[side], rounding=rounding)}
    hulls = answer.get('hulls', SPACE)
    if verdict == 'disjoint' and not separates(pair, answer['direction']):
        return 'the direction does not separate'
    if verdict == 'touching' and 'near' in answer:
        if not nearly_touch(pair, answer['near']):
            return 'not within 2^-200 of touching'
    elif 'points' in answer and verdict in ('intersecting', 'touching'):
        if not come_near(pair, answer['points'], hulls):
            return 'the points are not in the cores, or farther apart than the roundings'
        ends = [nearest(vector(p), equations(pair[k], hull)) for k, p, hull in zip('ab', answer['points'], hulls)]
        if verdict == 'touching' and not touch_at(pair, *ends):
            return 'they overlap at these points'
    elif verdict in ('intersecting', 'touching'):
        if not in_both(pair, answer['point'], hulls):
            return 'the point is not in both solids'
        meant = nearest(vector(answer['point']), equations(pair['a'], hulls[0]) + equations(pair['b'], hulls[1]))
        if verdict == 'touching' and not touch_at(pair, meant, meant):
            return 'they overlap at this point'
    return wrong_interval(pair, answer) if 'distance' in answer else None


def wrong_interval(pair, answer):
    """The fault of an interval of the distance that can be shown, or None."""
    low, high = map(exact, answer['distance'])
    signs = {'disjoint': high > 0, 'intersecting': low <= 0, 'touching': low <= 0 <= high}
    if low > high or not signs.get(answer['verdict'], True):
        return 'the distance contradicts the verdict'
    if answer['verdict'] == 'disjoint' and gap(pair, answer['direction'], DIGITS[0]) > high:
        return 'the distance is less than the gap that the direction shows'
    return None


def refuted(pair, said):
    """A claim in words that refutes an answer about a pair, and whether it holds."""
    pair = {k: plain(pair[k]) for k in 'ab'}
    if 'distance' not in said:
        if 'direction' in said:
            return 'the direction said does not separate them', gap(pair, said['direction'], DIGITS[0], True) <= 0
        if 'points' in said:
            return 'the points said do not show that they meet', not come_near(pair, said['points'])
        return 'the point said is not in both', not in_both(pair, said['point'], said.get('hulls', SPACE))
    distance, tolerance = said['distance'], said['tolerance']
    what = f'the distance said, {distance}, is too '
    if 'points' in said:
        shown = come_near(pair, said['points'], SPACE, exact(distance) - exact(tolerance))
        return f'{what}large by more than {tolerance}', shown
    width = gap(pair, said['direction'], DIGITS[0])
    shown = width > exact(distance) + exact(tolerance)
    if width > 0:
        return f'{what}small by more than {tolerance}', shown
    return (f'{what}deep by more than {tolerance}: one along {said["direction"]} ends at depth {in_digits(-width)}',
            shown)


def in_digits(length):
    """The length in nine digits; the largest double for one that no double holds."""
    return f'{float(min(length, Fraction(sys.float_info.max))):.9g}'


def prove(claims):
    """Prints each claim and whether it is proved; returns the exit status."""
    status = 0
    for claim in claims:
        pair, answer = claim['pair'], claim.get('answer')
        if answer is None:
            what, shown = refuted(pair, claim['said'])
        else:
            shown = not fault(pair, answer)
            what = claim['name'] + ': they ' + ('touch, to within 2^-200 of their size' if 'near' in answer else 'meet')
            if answer['verdict'] == 'disjoint':
                width = gap({k: plain(pair[k]) for k in 'ab'}, answer['direction'], DIGITS[0])
                what = f'{claim["name"]}: disjoint, at least {in_digits(width)} apart'
        status |= not shown
        print(what + ':', 'proved' if shown else 'NOT PROVED')
    return int(status)


def read(path):
    """The values of the lines; the error of one that is not JSON, or that has a key twice."""
    def once(fields):
        if len(dict(fields)) < len(fields):
            raise ValueError('a key twice')
        return dict(fields)

    def parsed(line):
        try:
            return json.loads(line, object_pairs_hook=once)
        except (ValueError, RecursionError) as error:
            return f'malformed: {type(error).__name__}'
    with open(path, encoding='utf-8', errors='replace') as file:
        return [parsed(line) for line in file if line.strip()]


def check(pairs, answers):
    """Prints each certificate that fails; returns the exit status."""
    if len(pairs) != len(answers):
        sys.exit(f'{len(pairs)} pairs, {len(answers)} answers')
    failed = unproved = 0
    verdicts = Counter()
    for number, (pair, answer) in enumerate(zip(pairs, answers), 1):
        try:
            verdicts[answer.get('verdict')] += 1
            unproved += is_uncertified(answer)
            why = fault(pair, answer)
        except (AttributeError, KeyError, TypeError, ValueError, ZeroDivisionError, OverflowError) as error:
            why = f'malformed: {error!r}'
        if why:
            failed += 1
            print(ascii(f'line {number}: {answer.get("verdict") if isinstance(answer, dict) else answer}: {why}')[1:-1])
    none = f', {unproved} answers to a negative clearance have none' if unproved else ''
    print(ascii(dict(verdicts)), f'{failed} certificates fail{none}')
    return 2 if failed else 0


if __name__ == '__main__':
    if len(sys.argv) == 3:
        sys.exit(check(read(sys.argv[1]), read(sys.argv[2])))
    if len(sys.argv) > 1 or not CLAIMS:
        sys.exit(__doc__)
    sys.exit(prove(CLAIMS))
