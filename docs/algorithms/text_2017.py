# SPDX-License-Identifier: MIT
"""The text of 2017 put right: five kinds of directions, the last by a minimiser (docs/algorithms.md)."""
import math

from solids import (PARALLEL, Solid, add, common_normal, cross, dot, f, length, scale, separates_in_parallel, sub, unit)

STEPS = LINES = 60


def disjoint(a, b):
    """Whether a direction was found along which a and b are apart."""
    delta = sub(b.c, a.c)
    if delta == (0, 0, 0):
        return False
    n = common_normal(a, b)
    if length(n) < PARALLEL:
        return separates_in_parallel(a, b)
    return (any(f(a, b, d) < 0 for d in (a.w, b.w, n)) or perpendiculars(a, b) or perpendiculars(b, a)
            or other_directions(a, b, delta))


def bisect(low, high, value, slope):
    """Whether the convex function falls below 0 between low and high; all arguments are looked at by `value`."""
    if value(low) or value(high):
        return True
    if slope(low) >= 0 or slope(high) <= 0:
        return False
    for _ in range(STEPS):
        t = (low + high) / 2
        if value(t):
            return True
        rise = slope(t)
        if rise == 0:
            break
        low, high = (low, t) if rise > 0 else (t, high)
    return False


def sign(x):
    return (x > 0) - (x < 0)


def perpendiculars(a, b):
    """The directions square to a's axis: two quarter circles, D(t) = (1-t) U + t V and the same with -U."""
    delta, n = sub(b.c, a.c), common_normal(a, b)
    b1 = length(n)
    c1 = dot(a.w, b.w)
    u = scale(math.copysign(1 / b1, -c1), n)
    v = cross(a.w, u)
    for u in (u, scale(-1, u)):
        a2, b2 = dot(delta, u), dot(delta, v)
        if sign(a2) * sign(b2) < 0 and a2 and b2:  # a kink between: F is not convex, but the ends are enough
            if f(a, b, u) < 0 or f(a, b, v) < 0:
                return True
            continue

        def slope(t, a2=a2, b2=b2):
            s = 1 - t
            q = math.hypot(s, c1 * t)
            fall = (c1 * c1 * t - s) / q if q > 0 else -1
            return (a.r * (2 * t - 1) / math.hypot(s, t) + b.r * fall + b.half * b1 - (b2 - a2) * sign(s * a2 + t * b2))

        if bisect(0, 1, lambda t, u=u: f(a, b, add(scale(1 - t, u), scale(t, v))) < 0, slope):
            return True
    return False


def other_directions(a, b, delta):
    """D(s, t) = s U + t V + (1-s-t) W on four octants about W = Delta/|Delta|, each in the cells where neither
    D.W_0 nor D.W_1 changes its sign: there G(s, t) = f(D(s, t)) is convex and smooth."""
    w = unit(delta)
    v = max(cross(w, a.w), cross(w, b.w), key=length)
    v = unit(v)
    u = cross(v, w)
    for u, v in ((u, v), (scale(-1, u), v), (scale(-1, u), scale(-1, v)), (u, scale(-1, v))):
        frame = [tuple(dot(x, axis) for axis in (u, v, w)) for x in (a.w, b.w)]
        octant = [Solid((0, 0, 0), frame[0], a.r, a.half), Solid((0, 0, length(delta)), frame[1], b.r, b.half)]
        for sign0 in (1, -1):
            for sign1 in (1, -1):
                corners = [(0, 0), (1, 0), (0, 1)]
                for solid, side in zip(octant, (sign0, sign1)):
                    corners = cut(corners, lambda x, w=solid.w, side=side: side * dot(at(x), w))
                if corners and Cell(octant, (sign0, sign1), corners).separates():
                    return True
    return False


def at(x):
    return (x[0], x[1], 1 - x[0] - x[1])


def cut(corners, side):
    """The part of a convex polygon where the linear function `side` is >= 0; none where it has no inside."""
    kept, inside = [], False
    for p, q in zip(corners, corners[1:] + corners[:1]):
        here, there = side(p), side(q)
        inside = inside or here > 0
        if here >= 0:
            kept.append(p)
        if here * there < 0:
            k = here / (here - there)
            kept.append((p[0] + k * (q[0] - p[0]), p[1] + k * (q[1] - p[1])))
    return kept if inside else []


class Cell:
    """One search for the least G: along the sides first, then by conjugate gradients from the lowest point there."""

    def __init__(self, octant, signs, corners):
        self.octant, self.signs, self.corners = octant, signs, corners
        self.best, self.lowest = None, math.inf

    def value(self, x):
        """Whether G < 0; remembers the lowest point."""
        d = at(x)
        g = f(*self.octant, d)
        if g < self.lowest:
            self.best, self.lowest = x, g
        return g < 0

    def gradient(self, x, but=None):
        d, g = at(x), (0, 0, -self.octant[1].c[2])
        for solid, side in zip(self.octant, self.signs):
            across = cross(d, solid.w)
            size = length(across)
            if size > 0 and solid is not but:  # at the tip of a cone 0 is a subgradient
                g = add(g, scale(solid.r / size, cross(solid.w, across)))
            g = add(g, scale(solid.half * side, solid.w))
        return (g[0] - g[2], g[1] - g[2])

    def line(self, x, d, low, high):
        def point(r):
            return (x[0] + r * d[0], x[1] + r * d[1])

        def slope(r):
            g = self.gradient(point(r))
            return g[0] * d[0] + g[1] * d[1]
        return bisect(low, high, lambda r: self.value(point(r)), slope)

    def in_vain(self, x):
        """G > 0 in the whole cell: its tangent plane at x is, at every corner."""
        g, value = self.gradient(x), f(*self.octant, at(x))
        return all(value + g[0] * (c[0] - x[0]) + g[1] * (c[1] - x[1]) > 0 for c in self.corners)

    def descend(self, d):
        """One line from the lowest point, from side to side of the cell. Whether it separates."""
        low, high, x = -math.inf, math.inf, self.best
        for p, q in zip(self.corners, self.corners[1:] + self.corners[:1]):
            sx, sy = q[0] - p[0], q[1] - p[1]
            room = max(0.0, sx * (x[1] - p[1]) - sy * (x[0] - p[0]))
            drift = sx * d[1] - sy * d[0]
            if drift > 0:
                low = max(low, -room / drift)
            elif drift < 0:
                high = min(high, -room / drift)
        return low <= high and high - low < math.inf and self.line(x, d, low, high)

    def separates(self):
        middle = tuple(sum(c[i] for c in self.corners) / len(self.corners) for i in (0, 1))
        if self.value(middle):
            return True
        if self.in_vain(middle):
            return False
        for p, q in zip(self.corners, self.corners[1:] + self.corners[:1]):
            if self.line(p, (q[0] - p[0], q[1] - p[1]), 0, 1):
                return True
        for solid in self.octant:  # next to an axis the gradient says nothing: the one line that leads down
            if length(cross(at(self.best), solid.w)) < 1 / 8 and self.off_axis(solid):
                return True
        return self.conjugate_gradients()

    def off_axis(self, solid):
        """The line along which G without |P_i D| falls most for each unit of |P_i D|."""
        g, w = self.gradient(self.best, but=solid), solid.w
        ac, bc = w[0] - w[2], w[1] - w[2]
        ss, st, tt = 2 - ac * ac, 1 - ac * bc, 2 - bc * bc
        return self.descend((st * g[1] - tt * g[0], st * g[0] - ss * g[1]))

    def conjugate_gradients(self):
        g = self.gradient(self.best)
        d, steepest = (-g[0], -g[1]), True
        for _ in range(LINES):
            before = self.lowest
            if self.descend(d):
                return True
            if not self.lowest < before:
                if steepest:
                    return False
                d, steepest = (-g[0], -g[1]), True
                continue
            if self.in_vain(self.best):
                return False
            new = self.gradient(self.best)
            beta = (new[0] * (new[0] - g[0]) + new[1] * (new[1] - g[1])) / (g[0] ** 2 + g[1] ** 2)
            turned = (beta * d[0] - new[0], beta * d[1] - new[1])
            steepest = not (beta > 0 and turned[0] * new[0] + turned[1] * new[1] < 0)
            d = (-new[0], -new[1]) if steepest else turned
            g = new
        return False
