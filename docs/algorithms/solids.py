# SPDX-License-Identifier: MIT
"""What the three algorithms share: vectors as tuples, a pair in one notation, the support gap f.

    Solid i: centre C_i, unit axis W_i, radius r_i, height h_i (`half`: h_i/2). Delta = C_1 - C_0.
    f(D) = r_0 |P_0 D| + (h_0/2) |D.W_0| + r_1 |P_1 D| + (h_1/2) |D.W_1| - |D.Delta|, P_i D = D - (D.W_i) W_i.

The solids are apart if and only if f(D) < 0 for some D."""
import collections
import math

Solid = collections.namedtuple('Solid', 'c w r half')


def add(a, b):
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def scale(k, a):
    return (k * a[0], k * a[1], k * a[2])


def sub(a, b):
    return add(a, scale(-1, b))


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def length(a):
    return math.hypot(*a)


def unit(a):
    return scale(1 / length(a), a)


def solid(center, axis, radius, height):
    """A solid as the files of pairs have it: an axis of any length, the whole height."""
    return Solid(tuple(center), unit(unit(axis)), radius, height / 2)


def f(a, b, d):
    """The support gap; |P D| as |D x W|, which loses no digits next to W."""
    return sum(s.r * length(cross(d, s.w)) + s.half * abs(dot(d, s.w)) for s in (a, b)) - abs(dot(d, sub(b.c, a.c)))


def common_normal(a, b):
    """W_0 x W_1 up to sign, accurate at any angle: from the axes' difference and sum, one axis turned if need be."""
    w1 = b.w if dot(a.w, b.w) >= 0 else scale(-1, b.w)
    return scale(0.5, cross(sub(a.w, w1), add(a.w, w1)))


PARALLEL = 2.0 ** -49
"""A smaller sine of the axes' angle may be a rounding of their lengths: they count as parallel."""


def separates_in_parallel(a, b):
    """Whether solids with parallel axes are apart: along the axis, or across it."""
    w = unit(add(a.w, b.w if dot(a.w, b.w) >= 0 else scale(-1, b.w)))
    delta = sub(b.c, a.c)
    return abs(dot(delta, w)) > a.half + b.half or length(cross(delta, w)) > a.r + b.r
