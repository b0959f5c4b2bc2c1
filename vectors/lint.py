#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""lint.py FILE.. proves vectors: each verdict, each end of a distance that has a certificate, each quaternion and prism.
Exit status: 0 if nothing is wrong, else 2."""
import itertools
import math
import struct
import sys
from fractions import Fraction

import exact
from daylight_vectors import known_flags, load
from exact import DIGITS, cross, dot, minus, vector


def numbers(solid):
    return [*solid['center'], *solid['axis'], solid['radius'], solid['height'], solid.get('rounding', 0)]


def id_of(v):
    """FNV-1a of the 16 numbers of the cores as doubles, and of the roundings if there are any."""
    of_a, of_b = ([float(x) for x in numbers(v[k])] for k in 'ab')
    state = 0xcbf29ce484222325
    for byte in struct.pack('<16d', *of_a[:8], *of_b[:8]) + (
            struct.pack('<2d', of_a[8], of_b[8]) if of_a[8] or of_b[8] else b''):
        state = ((state ^ byte) * 0x100000001b3) & (1 << 64) - 1
    return f'v1-{state:016x}'


def defect(solid):
    """Whether a solid is none."""
    values = [float(x) for x in numbers(solid)]
    return not all(map(math.isfinite, values)) or min(values[6:]) < 0 or not any(values[3:6])


def is_float32(x):
    return x == 0 or 2**-126 <= abs(x) < 2**128 and struct.unpack('<f', struct.pack('<f', x))[0] == x


def is_ordinary(solid):
    return (all(x == 0 or 0.1 <= x <= 10 for x in numbers(solid)[6:]) and max(map(abs, solid['center'])) <= 100
            and abs(math.hypot(*solid['axis']) - 1) <= 1e-6)


def off(solid):
    """How far the solid whose axis is the quaternion's is from the one given, at most: an angle is at most 11/7 of its
    sine."""
    w, x, y, z = map(exact.exact, solid['quaternion'])
    got, axis = [2 * (x * z + w * y), 2 * (y * z - w * x), w * w - x * x - y * y + z * z], vector(solid['axis'])
    between = cross(got, axis)
    sine = exact.root(dot(between, between) / dot(got, got) / dot(axis, axis), 60, True)
    return Fraction(11, 7) * sine * (exact.exact(solid['radius']) + exact.exact(solid['height']) / 2)


def within_corners(corners, point):
    """Whether some four of the corners have the point between them."""
    for four in itertools.combinations(corners, 4):
        u, v, w, x = (minus(p, four[0]) for p in (*four[1:], point))
        volume = dot(u, cross(v, w))
        if volume == 0:
            continue
        parts = [dot(x, cross(v, w)) / volume, dot(u, cross(x, w)) / volume, dot(u, cross(v, x)) / volume]
        if min(parts) >= 0 and sum(parts) <= 1:
            return True
    return False


def wrong_prisms(v):
    a, b = ([vector(p) for p in v['prisms'][k]] for k in 'ab')
    proof = v['certificate']
    if v['result'] == 'disjoint':
        if not all(exact.in_core(v[k], p) for k, corners in (('a', a), ('b', b)) for p in corners):
            return 'a corner of a prism is not inside'
        d = vector(proof['direction'])
        of_a, of_b = ([dot(d, p) for p in corners] for corners in (a, b))
        return None if max(of_a) < min(of_b) or max(of_b) < min(of_a) else 'the direction does not separate the prisms'
    point, hulls = vector(proof['point']), proof.get('hulls', exact.SPACE)
    point = exact.nearest(point, exact.equations(v['a'], hulls[0]) + exact.equations(v['b'], hulls[1]))
    return None if within_corners(a, point) and within_corners(b, point) else 'the point is not in both prisms'


def wrong_distance(v, low, high):
    proof = v['certificate']
    if v['result'] == 'touching':
        if low or high:
            return 'touching at a distance'
        if 'near' not in proof and exact.gap(v, proof['direction'], DIGITS[0]) < 0:
            return 'the direction does not show that they only touch'
        return None
    if not any(exact.gap(v, proof['direction'], bits) >= low for bits in DIGITS):
        return 'the direction does not prove the lower end of the distance'
    if 'nearest' in proof:
        near = proof['nearest']
        if not exact.come_near(v, near['points'], near.get('hulls', exact.SPACE), high):
            return 'the nearest points do not prove the upper end of the distance'
    return None


def wrong(v, flags):
    """The fault of a vector in words, or None."""
    if v['id'] != id_of(v):
        return 'the id is not that of these numbers'
    unknown = [flag for flag in v['flags'] if flag not in flags]
    if unknown:
        return f'no such flag: {unknown}'
    invalid = defect(v['a']) or defect(v['b'])
    if invalid != (v['result'] == 'invalid'):
        return 'legal but called invalid, or the reverse'
    if invalid:
        return None
    if v['result'] not in ('disjoint', 'intersecting', 'touching'):
        return 'no result'
    low, high = map(exact.exact, v['distance'])
    proof = v['certificate']
    of_distance = {'disjoint': {'nearest'}, 'intersecting': {'direction', 'nearest'},
                   'touching': set() if 'near' in proof else {'direction'}}[v['result']]
    answer = {part: proof[part] for part in proof.keys() - of_distance}
    if 'nearest' in answer:
        return 'nearest points, which do not belong to the result'
    answer |= {'verdict': v['result'], 'distance': v['distance']}
    why = exact.fault(v, answer) or wrong_distance(v, low, high)
    if why:
        return why
    values = numbers(v['a']) + numbers(v['b'])
    if (v['precision'] == 'float32') != all(map(is_float32, values)):
        return 'the precision is not that of the numbers'
    if (v['sizes'] == 'ordinary') != (is_ordinary(v['a']) and is_ordinary(v['b'])):
        return 'the sizes are not those of the numbers'
    least, most = max(low, -high, 0), max(abs(low), abs(high))
    size = sum(exact.exact(x) for k in 'ab' for x in numbers(v[k])[6:])
    if v['acceptable_below'] != most or size and abs(exact.exact(v['margin']) * size - least) > least / 2**40:
        return 'margin or acceptable_below do not fit the distance'
    if 'quaternion_off' in v:
        bound = exact.exact(v['quaternion_off'])
        if off(v['a']) + off(v['b']) > bound or bound and bound >= least:
            return 'the quaternion is another solid'
    return wrong_prisms(v) if 'prisms' in v else None


def lint(document, flags):
    """A line for each vector that is wrong, and for what is wrong with all."""
    vectors = document['vectors']
    if 'schema' not in document:  # of v2
        yield from (f'{v["id"]}: {why}' for v in vectors if (why := exact.fault(v, v['answer'])))
        return
    if document['count'] != len(vectors):
        yield f'{len(vectors)} vectors, not {document["count"]}'
    seen = {}
    for v in vectors:
        try:
            why = 'the id is there twice' if v['id'] in seen else wrong(v, flags)
            if not why and v['kind'] == 'changed':
                base = seen.get(v['like'])
                times = 8 if v['change'] == 'scaled by 8' else 1
                if not base or base['result'] != v['result']:
                    why = 'not like the vector before it'
                elif base['distance'][0] * times > v['distance'][1] or base['distance'][1] * times < v['distance'][0]:
                    why = 'another distance than the vector that it is like'
        except (KeyError, TypeError, ValueError, ZeroDivisionError, OverflowError, struct.error) as error:
            why = f'malformed: {error!r}'
        seen[v.get('id')] = v
        if why:
            yield f'{v.get("id")}: {why}'


def main(files):
    found = [f'{file}: {line}' for file in files for line in lint(load(file), known_flags())]
    print(*found, f'{len(found)} wrong', sep='\n')
    return 2 if found else 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]) if sys.argv[1:] else __doc__)
