# SPDX-License-Identifier: MIT
"""Ours: slices parallel to both axes (docs/algorithms.md; the proofs: solver/derivation.md)."""
import math

from solids import PARALLEL, common_normal, cross, dot, length, separates_in_parallel, sub, unit


def root(x):
    return math.sqrt(max(0.0, x))


def disjoint(a, b):
    """Whether the solids a and b have no point in common."""
    n = common_normal(a, b)
    s = length(n)
    if s < PARALLEL:
        return separates_in_parallel(a, b)
    n = unit(n)
    c = abs(dot(a.w, b.w))
    delta = sub(b.c, a.c)
    z = abs(dot(delta, n))
    if z > a.r + b.r:
        return True
    # A slice cuts a in the half widths h_0 along W_0 and x across, b in h_1 and y. What the four normals of the two
    # rectangles demand: x >= x0, y >= y0, x + c y >= k2, c x + y >= k3.
    x0 = max(0.0, (abs(dot(delta, b.w)) - b.half - a.half * c) / s)
    y0 = max(0.0, (abs(dot(delta, a.w)) - a.half - b.half * c) / s)
    k2 = abs(dot(delta, cross(a.w, n))) - b.half * s
    k3 = abs(dot(delta, cross(b.w, n))) - a.half * s
    if x0 > a.r or y0 > b.r or k2 > a.r + c * b.r or k3 > c * a.r + b.r:
        return True

    # The slices with half widths x and y or more: |u| <= sqrt(r_0^2 - x^2), |z - u| <= sqrt(r_1^2 - y^2). There is one
    # if and only if H(x, y) >= 0, and H is greatest on the lower left boundary of the demands: look at its corner.
    crossing = (k2 - c * k3) / (s * s)
    x = max(crossing, x0)
    on3 = k3 - c * x > y0
    y = k3 - c * x if on3 else y0
    if not on3:
        x = max(x0, k2 - c * y0)
    on2 = crossing > x0 and (on3 or k2 - c * y0 > x0)
    u, v = root(a.r ** 2 - x ** 2), root(b.r ** 2 - y ** 2)
    if x <= a.r and y <= b.r and u + v >= z:
        return False
    # H falls with x at the rate x/u, with y at y/v: does it rise up the first line, or down the second?
    if on2 and y * u < c * x * v:
        return not edge_meets(a.r, b.r, c, z, k2, x0)
    if on3 and c * y * u > x * v:
        return not edge_meets(b.r, a.r, c, z, k3, y0)
    return True


def edge_meets(ra, rb, c, z, k, least):
    """Along x + c y = k, x the width of the solid with radius ra, at least `least`: is H >= 0 anywhere?"""
    y = (k - least) / c if c > 0 else math.inf
    if y <= rb:
        u, v = root(ra ** 2 - least ** 2), root(rb ** 2 - y ** 2)
        if y * u <= c * least * v:  # H rises up to the line's end
            return u + v >= z
    # Inside, H >= 0 somewhere if and only if no direction cos(p) e + sin(p) n has a gap below 0; over p there is one
    # valley, since in t = tan(p) the gap is convex.
    low, high = 0.0, math.pi / 2
    for _ in range(60):
        p = (low + high) / 2
        t, q = math.sin(p), math.hypot(c * math.cos(p), math.sin(p))
        if ra + rb * q - k * math.cos(p) - z * t < 0:
            return False
        if t * (ra + (rb / q if q > 0 else 0)) > z:
            high = p
        else:
            low = p
    return True
