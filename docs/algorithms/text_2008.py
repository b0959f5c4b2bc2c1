# SPDX-License-Identifier: MIT
"""The text of 2008 put right: f where its gradient is undefined or 0; circles by projection to a plane or by a
polynomial of degree 8, critical points as on page 656 of the book (docs/algorithms.md)."""
import math

from solids import PARALLEL, add, common_normal, cross, dot, f, length, scale, separates_in_parallel, sub, unit

STEPS = 60


def disjoint(a, b, circle=None):
    """Whether a direction was found along which a and b are apart. `circle`: by_projection, or by_polynomial."""
    circle = circle or by_projection
    n = common_normal(a, b)
    if length(n) < PARALLEL:
        return separates_in_parallel(a, b)
    n = unit(n)
    return (any(f(a, b, d) < 0 for d in (a.w, b.w, n)) or circle(a, b, n) or circle(b, a, n) or inside(a, b, n))


def by_projection(a, b, n):
    """The directions square to a's axis: does the disk that a leaves on that plane meet what b leaves, a rectangle with
    two half ellipses? From the disk's middle, the vector to the nearest point of either is the one to try."""
    u, delta = cross(n, a.w), sub(b.c, a.c)
    c, s = abs(dot(a.w, b.w)), length(common_normal(a, b))
    side, a2, b2 = b.half * s, dot(delta, u), dot(delta, n)
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


def by_polynomial(a, b, _):
    """The directions square to a's axis once more: along x U + V, V along Delta's projection, the derivative of f is 0
    where r_0 x/sqrt(S_0) + r_1 L/sqrt(S_1) = k or -k; squared twice that is a polynomial of degree 8."""
    delta = sub(b.c, a.c)
    v = cross(a.w, cross(delta, a.w))
    if length(v) == 0:
        return False
    v = unit(v)
    u = cross(v, a.w)
    p, q = cross(u, b.w), cross(v, b.w)  # as long as P_1 U and P_1 V, at the same angle
    s0, s1, r0x = (1, 0, 1), (dot(q, q), 2 * dot(p, q), dot(p, p)), (0, a.r)
    line, k = (b.r * dot(p, q), b.r * dot(p, p)), b.half * dot(b.w, u)
    both, m0, m1 = product(s0, s1), product(product(r0x, r0x), s1), product(product(line, line), s0)
    rest = [k * k * x - y - z for x, y, z in zip(both, m0, m1)]
    xs = roots([4 * x - y for x, y in zip(product(m0, m1), product(rest, rest))])
    xs = [0] + [polished_root(x, sign * k, a.r, line, s1) for x in xs for sign in (1, -1)]
    return any(f(a, b, add(scale(x, u), v)) < 0 for x in xs)  # x = 0, as the polynomial of two segments may be 0


def product(p, q):
    """Of polynomials, as lists of coefficients from that of 1 on."""
    c = [0.0] * (len(p) + len(q) - 1)
    for i, x in enumerate(p):
        for j, y in enumerate(q):
            c[i + j] += x * y
    return c


def roots(c):
    """The real parts of all roots but 0, by Weierstrass' iteration."""
    while c and c[-1] == 0:
        c = c[:-1]
    while c and c[0] == 0:
        c = c[1:]
    n = len(c) - 1
    if n < 1:
        return []
    size = abs(c[0] / c[-1]) ** (1 / n)
    xs = [size * (0.4 + 0.9j) ** k for k in range(n)]
    for _ in range(STEPS):
        for i, x in enumerate(xs):
            value, others = 0, c[-1]
            for k in reversed(c):
                value = value * x + k
            for y in xs[:i] + xs[i + 1:]:
                others *= x - y
            if others != 0:
                xs[i] = x - value / others
    return [x.real for x in xs]


def polished_root(x, k, r0, line, s1):
    """Newton's steps on f'(x): squaring has blurred the roots."""
    for _ in range(16):
        q0, q1 = math.hypot(1, x), math.sqrt(max(0, (s1[2] * x + s1[1]) * x + s1[0]))
        if q1 == 0 or q0 > 1e50:
            break
        rise = r0 * x / q0 + (line[1] * x + line[0]) / q1 - k
        bend = r0 / q0 ** 3 + (line[1] * s1[0] - line[0] * s1[1] / 2) / q1 ** 3
        if not bend > 0:
            break
        x -= rise / bend
    return x


def inside(a, b, n):
    """Where no term of f has a kink: for each choice of the signs of D.W_0 and D.W_1, f(D) is r_0 |P_0 D| + r_1 |P_1 D|
    - D.phi, and D = x U + y V + W with W along phi is critical where r_0 B_0 eta_0 + r_1 B_1 eta_1 = 0, |eta_i| = 1."""
    delta = sub(b.c, a.c)
    frames = [(cross(n, solid.w), n) for solid in (a, b)]
    for sign0 in (1, -1):
        for sign1 in (1, -1):
            phi = sub(delta, add(scale(sign0 * a.half, a.w), scale(sign1 * b.half, b.w)))
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
                if along[0] * along[1] > 0 and separates_near(a, b, d, w, phi):
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


def below_by_squares(x2, y2, z2):
    """Section 13: whether x + y < z of lengths, from their squares and without a root."""
    rho = z2 - x2 - y2
    return rho > 0 and 4 * x2 * y2 < rho ** 2


def separates_near(a, b, d, w, phi):
    """D on D.W = 1, then Newton's steps while the smooth gap falls: the etas of nearly singular systems are blurred."""
    def gap(d):
        return a.r * length(cross(d, a.w)) + b.r * length(cross(d, b.w)) - dot(d, phi)

    def negative(d):
        x, y = scale(a.r, cross(d, a.w)), scale(b.r, cross(d, b.w))
        return below_by_squares(dot(x, x), dot(y, y), dot(phi, phi)) and f(a, b, d) < 0
    if dot(d, w) == 0:
        return False
    d = scale(1 / dot(d, w), d)
    u = unit(cross(w, a.w if abs(dot(w, a.w)) < abs(dot(w, b.w)) else b.w))
    v = cross(w, u)
    for _ in range(STEPS):
        if negative(d):
            return True
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
    return False
