# SPDX-License-Identifier: MIT
"""Draws a pair of cylinders as SVG, in parallel projection: a is blue, b is orange."""
import math

COLOURS = {'a': '#1f77b4', 'b': '#d45500'}
WIDTH, MARGIN, CORNERS = 320, 8, 72


def dot(x, y):
    return sum(s * t for s, t in zip(x, y))


def cross(x, y):
    return [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]]


def unit(x):
    return [s / math.hypot(*x) for s in x]


def square_to(x):
    """A unit vector at right angles to x, from the coordinate axis that is farthest from x."""
    return unit(cross(x, [float(i == min(range(3), key=lambda k: abs(x[k]))) for i in range(3)]))


def rims(solid):
    axis = unit(solid['axis'])
    u = square_to(axis)
    v = cross(axis, u)
    return [[[c + end * solid['height'] / 2 * n + solid['radius'] * (math.cos(t) * p + math.sin(t) * q)
              for c, n, p, q in zip(solid['center'], axis, u, v)]
             for t in (i * 2 * math.pi / CORNERS for i in range(CORNERS))] for end in (-1, 1)]


def hull(points):
    """The convex hull (Andrew's monotone chain)."""
    def half(ordered):
        kept = []
        for p in ordered:
            while len(kept) > 1 and ((kept[-1][0] - kept[-2][0]) * (p[1] - kept[-2][1]) <=
                                     (kept[-1][1] - kept[-2][1]) * (p[0] - kept[-2][0])):
                kept.pop()
            kept.append(p)
        return kept[:-1]
    ordered = sorted(points)
    return half(ordered) + half(ordered[::-1])


def svg(pair, title):
    """The eye looks along the common normal of both axes, tilted so that the rims show."""
    axes = [unit(pair[k]['axis']) for k in 'ab']
    side = cross(*axes)
    side = unit(side) if math.hypot(*side) > 1e-3 else square_to(axes[0])
    eye = unit([s + 0.3 * t for s, t in zip(side, axes[0])])
    right = unit(cross(axes[0], eye))
    up = cross(eye, right)
    flat = {k: [[(dot(p, right), -dot(p, up)) for p in rim] for rim in rims(pair[k])] for k in 'ab'}
    every = [p for both in flat.values() for rim in both for p in rim]
    low = [min(p[i] for p in every) for i in (0, 1)]
    wide, high = (max(p[i] for p in every) - low[i] for i in (0, 1))
    scale = (WIDTH - 2 * MARGIN) / max(wide, high)
    size = ' '.join(f'{extent * scale + 2 * MARGIN:.0f}' for extent in (wide, high))

    def path(points):
        return 'M' + 'L'.join(f'{MARGIN + (x - low[0]) * scale:.1f} {MARGIN + (y - low[1]) * scale:.1f}'
                              for x, y in points) + 'Z'
    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {size}" role="img">',
             f'<title>{title}</title>', '<rect width="100%" height="100%" fill="#fff"/>']
    for k in 'ab':
        lines.append(f'<path d="{path(hull(flat[k][0] + flat[k][1]))}" fill="{COLOURS[k]}" fill-opacity=".3"/>')
        lines += [f'<path d="{path(rim)}" fill="none" stroke="{COLOURS[k]}"/>' for rim in flat[k]]
    return '\n'.join([*lines, '</svg>']) + '\n'
