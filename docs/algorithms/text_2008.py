# SPDX-License-Identifier: MIT
"""The text of 2008 put right: f where its gradient is undefined or 0; circles by projection to a plane, critical points
as on page 656 of the book (docs/algorithms.md)."""
import math

from solids import PARALLEL, add, common_normal, cross, dot, f, length, scale, separates_in_parallel, sub, unit

STEPS = 60


def disjoint(a, b):
    """Whether a direction was found along which a and b are apart."""
    n = common_normal(a, b)
    if length(n) < PARALLEL:
        return separates_in_parallel(a, b)
    n = unit(n)
    return (any(f(a, b, d) < 0 for d in (a.w, b.w, n)) or circle(a, b, n) or circle(b, a, n) or inside(a, b, n))


def circle(a, b, n):
    """The directions square to a's axis: does the disk that a leaves on that plane meet what b leaves, a rectangle with
    two half ellipses? From the disk's middle, the vector to the nearest point of either is the one to try."""
    u, delta = cross(n, a.w), sub(b.c, a.c)
    c, s = abs(dot(a.w, b.w)), length(common_normal(a, b))
    side, a2, b2 = b.h * s, dot(delta, u), dot(delta, n)
    vectors = [(math.copysign(max(abs(a2) - side, 0), a2), math.copysign(max(abs(b2) - b.r, 0), b2))]
    x, y = abs(a2) - side, abs(b2)
    if c > 0 and x > 0 and b.r > 0:
        # In the unit r_1 the ellipse has half axes c and 1; its point nearest to (x, y) is (c^2 x/(t + c^2), y/(t + 1))
        # for the t > 0 that puts it there. What t solves is convex and falls: Newton's steps from 0 never pass it.
        x, y, t = x / b.r, y / b.r, 0.0
        for _ in range(STEPS):
            m, k = 1 / (t + c * c), 1 / (t + 1)
            p, q = (c * x * m) ** 2, (y * k) ** 2
            if p + q <= 1:
                break
            t += (p + q - 1) / (2 * (p * m + q * k))
        vectors.append((math.copysign(x / (t + c * c), a2), math.copysign(y / (t + 1), b2)))
    return any(f(a, b, add(scale(x, u), scale(y, n))) < 0 for x, y in vectors)


def inside(a, b, n):
    """Where no term of f has a kink: for each choice of the signs of D.W_0 and D.W_1, f(D) is r_0 |P_0 D| + r_1 |P_1 D|
    - D.phi, and D = x U + y V + W with W along phi is critical where r_0 B_0 eta_0 + r_1 B_1 eta_1 = 0, |eta_i| = 1."""
    delta = sub(b.c, a.c)
    frames = [(cross(n, solid.w), n) for solid in (a, b)]
    for sign0 in (1, -1):
        for sign1 in (1, -1):
            phi = sub(delta, add(scale(sign0 * a.h, a.w), scale(sign1 * b.h, b.w)))
            if phi == (0, 0, 0):
                return False  # two rims have one centre
            w = unit(phi)
            dets = dot(w, a.w), dot(w, b.w)
            if dets == (0, 0):
                return f(a, b, w) < 0  # a common perpendicular joins the rims' centres: it decides
            u = unit(cross(w, min(((1, 0, 0), (0, 1, 0), (0, 0, 1)), key=lambda e: abs(dot(e, w)))))
            v = cross(w, u)
            bs = [[[dot(p, q) for q in frame] for p in (u, v)] for frame in frames]
            for p0, p1 in critical_pairs(bs, dets, (a.r, b.r)):
                # D is square to both A_i eta_i^perp, and eta_i . A_i^T D must have one sign for both i.
                d = cross(*(add(scale(p[1], frame[0]), scale(-p[0], frame[1])) for p, frame in zip((p0, p1), frames)))
                along = [p[0] * dot(frame[0], d) + p[1] * dot(frame[1], d) for p, frame in zip((p0, p1), frames)]
                if along[0] * along[1] > 0 and f(a, b, d) < 0:
                    return True
                if along[0] * along[1] > 0 and polished(a, b, d, w, phi):
                    return True
            if f(a, b, w) < 0:  # where e_0 = e_1, the least is there
                return True
    return False


def times(m, p):
    return (m[0][0] * p[0] + m[0][1] * p[1], m[1][0] * p[0] + m[1][1] * p[1])


def transposed(m):
    return [[m[0][0], m[1][0]], [m[0][1], m[1][1]]]


def critical_pairs(bs, dets, radii):
    """Solutions, one of each pair (eta, -eta), of any length but 0."""
    if dets[0] == 0:
        return [(p0, p1) for p1, p0 in critical_pairs(bs[::-1], dets[::-1], radii[::-1])]
    (b0, b1), (r0, r1) = bs, radii
    if dets[1] == 0:
        # psi spans the columns of B_1, zeta is square to it: zeta . B_0 eta_0 = 0, and eta_1 is on a line and a circle.
        psi = max(transposed(b1), key=lambda column: math.hypot(*column))
        g = times(transposed(b0), (psi[1], -psi[0]))
        p0 = (g[1], -g[0])
        m = [r1 * x for x in times(transposed(b1), psi)]
        offset = -r0 * sum(x * y for x, y in zip(times(transposed(b0), psi), p0))
        square = m[0] ** 2 + m[1] ** 2
        rest = square * (p0[0] ** 2 + p0[1] ** 2) - offset ** 2
        if not square > 0 or rest < 0:
            return []
        side = math.sqrt(rest)
        return [(p0, ((offset * m[0] + k * m[1]) / square, (offset * m[1] - k * m[0]) / square)) for k in (side, -side)]
    # P_0 = r_0 |det B_0| eta_0, P_1 = r_1 eta_1: P_0 = -+C P_1 with C = Adj(B_0) B_1, |P_0| and |P_1| known.
    adjugate = [[b0[1][1], -b0[0][1]], [-b0[1][0], b0[0][0]]]
    c = [list(times(adjugate, column)) for column in transposed(b1)]  # transposed
    c = transposed(c)
    xx, yy = c[0][0] ** 2 + c[1][0] ** 2, c[0][1] ** 2 + c[1][1] ** 2
    xy = c[0][0] * c[0][1] + c[1][0] * c[1][1]
    e1 = (xx + yy + math.hypot(xx - yy, 2 * xy)) / 2
    e0 = (dets[0] * dets[1]) ** 2 / e1
    if not e1 - e0 > 2.0 ** -50 * e1:
        return []
    # The eigenvector of e1, from the row that is longer; that of e0 is square to it.
    q = max(((xy, e1 - xx), (e1 - yy, xy)), key=lambda p: math.hypot(*p))
    q = tuple(x / math.hypot(*q) for x in q)
    p0_square, p1_square = (r0 * dets[0]) ** 2, r1 ** 2
    a2, b2 = (e1 * p1_square - p0_square) / (e1 - e0), (p0_square - e0 * p1_square) / (e1 - e0)
    if a2 < 0 or b2 < 0:
        return []
    pairs = []
    for k in (1, -1):
        x, y = k * math.sqrt(a2), math.sqrt(b2)
        p1 = (x * -q[1] + y * q[0], x * q[0] + y * q[1])
        turn = -math.copysign(1, dets[0])
        pairs.append((tuple(turn * x for x in times(c, p1)), p1))
    return pairs


def polished(a, b, d, w, phi):
    """Newton's steps on D.W = 1 while the smooth gap falls: the etas of nearly singular systems are blurred."""
    def gap(d):
        return a.r * length(cross(d, a.w)) + b.r * length(cross(d, b.w)) - dot(d, phi)
    if dot(d, w) == 0:
        return False
    d = scale(1 / dot(d, w), d)
    u = unit(cross(w, a.w if abs(dot(w, a.w)) < abs(dot(w, b.w)) else b.w))
    v = cross(w, u)
    for _ in range(STEPS):
        gx = gy = hxx = hxy = hyy = 0.0
        for solid in (a, b):
            across = cross(d, solid.w)
            size = length(across)
            if size == 0:
                return False
            tangent = scale(1 / size, across)
            normal = cross(solid.w, tangent)
            tu, tv = dot(tangent, u), dot(tangent, v)
            gx, gy = gx + solid.r * dot(normal, u), gy + solid.r * dot(normal, v)
            k = solid.r / size
            hxx, hxy, hyy = hxx + k * tu * tu, hxy + k * tu * tv, hyy + k * tv * tv
        det = hxx * hyy - hxy * hxy
        if not det > 0:
            return False
        new = sub(d, add(scale((hyy * gx - hxy * gy) / det, u), scale((hxx * gy - hxy * gx) / det, v)))
        if not gap(new) < gap(d):
            return False
        d = new
        if f(a, b, d) < 0:
            return True
    return False
