# SPDX-License-Identifier: MIT
"""Vectors, draws, solids, boxes and meshes of scenes/study/approaches.py: nothing of daylight is in them."""
import collections
import itertools
import math
import pathlib
import struct

WORD = (1 << 64) - 1
FOLD = 1e-9  # of the radius: how far a sphere may be off the end of the cylinder that it closes
STEPS = 20000  # projections from solid to solid


def numbers(text):
    return [float(x) for x in text.split()]


def dot(u, v):
    return sum(x * y for x, y in zip(u, v))


def plus(u, v, times=1):
    return [x + times * y for x, y in zip(u, v)]


def norm(v):
    return math.sqrt(dot(v, v))


def turned(rotation, v):
    return [dot(row, v) for row in rotation]


def product(m, n):
    return [[sum(m[i][k] * n[k][j] for k in range(3)) for j in range(3)] for i in range(3)]


def about(axis, angle):
    """Rodrigues' rotation."""
    x, y, z = (a / norm(axis) for a in axis)
    c, s = math.cos(angle), math.sin(angle)
    d = 1 - c
    return [[c + x * x * d, x * y * d - z * s, x * z * d + y * s],
            [y * x * d + z * s, c + y * y * d, y * z * d - x * s],
            [z * x * d - y * s, z * y * d + x * s, c + z * z * d]]


class Draw:
    """The numbers of corpus/pairs/random_stream.hpp."""

    def __init__(self, name, seed, index):
        state = 0xcbf29ce484222325
        for byte in name.encode():
            state = ((state ^ byte) * 0x100000001b3) & WORD
        self.state = self.mix(self.mix(state ^ self.mix(seed)) ^ index)

    @staticmethod
    def mix(x):
        x = ((x ^ (x >> 30)) * 0xbf58476d1ce4e5b9) & WORD
        x = ((x ^ (x >> 27)) * 0x94d049bb133111eb) & WORD
        return x ^ (x >> 31)

    def between(self, low, high):
        self.state = (self.state + 0x9e3779b97f4a7c15) & WORD
        return low + (high - low) * ((self.mix(self.state) >> 11) * 2.0**-53)


Block = collections.namedtuple('Block', 'kind center rotation half points rounding', defaults=(0, ))
Block.__doc__ = """A box, or a mesh with its box: what a solid only holds."""
Solid = collections.namedtuple('Solid', 'name link center axis radius height rounding block bits',
                               defaults=(None, (1, 1)))


def block_of(kind, corners, rotation, place):
    """Of points in a shape's own frame."""
    low, high = ([f(p[i] for p in corners) for i in range(3)] for f in (min, max))
    middle = [(a + b) / 2 for a, b in zip(low, high)]
    return Block(kind, plus(turned(rotation, middle), place), rotation, [(b - a) / 2 for a, b in zip(low, high)],
                 [plus(turned(rotation, p), place) for p in corners])


def corners(half):
    return [[s * h for s, h in zip(signs, half)] for signs in itertools.product((-1, 1), repeat=3)]


def held(name, link, block, bits=(1, 1)):
    """A shape whose solid is not known before somebody says what bounds it."""
    return Solid(name, link, block.center, [0, 0, 1], 0, 0, 0, block, bits)


def moved(s, rotation, place):
    """A solid and its block, carried along."""
    to = lambda p: plus(place, turned(rotation, p))
    block = s.block and s.block._replace(center=to(s.block.center), rotation=product(rotation, s.block.rotation),
                                         points=[to(p) for p in s.block.points])
    return s._replace(center=to(s.center), axis=turned(rotation, s.axis), block=block)


def vertices(file):
    """Of a mesh; none where it cannot be read."""
    path = pathlib.Path(file)
    if not path.is_file() or path.suffix not in ('.stl', '.obj'):
        return []
    data = path.read_bytes()
    if path.suffix == '.stl' and len(data) >= 84 and len(data) == 84 + 50 * struct.unpack('<I', data[80:84])[0]:
        facets = [struct.unpack('<12fH', data[at:at + 50]) for at in range(84, len(data), 50)]
        return [list(f[i:i + 3]) for f in facets for i in (3, 6, 9)]
    word = 'vertex' if path.suffix == '.stl' else 'v'
    lines = [line.split() for line in data.decode().splitlines()]
    return [[float(x) for x in line[1:4]] for line in lines if line and line[0] == word]


def outside(s):
    """How many points of a block its solid does not hold."""
    count = 0
    for p in s.block.points:
        way = plus(p, s.center, -1)
        along = dot(way, s.axis)
        beyond, beside = abs(along) - s.height / 2, norm(plus(way, s.axis, -along)) - s.radius
        count += math.hypot(max(0, beyond), max(0, beside)) > s.rounding
    return count


def really_within(a, b, clearance):
    """As far as it is easily told: boxes are asked as they are, of meshes the vertices; more may be within."""
    for one, other in ((a, b), (b, a)):
        if one.block and one.block.kind != 'box':
            solid = other.block if other.block and other.block.kind == 'box' else other
            if other.block and other.block.kind != 'box':
                return False
            return any(norm(plus(p, nearest(solid, p), -1)) <= clearance + solid.rounding for p in one.block.points)
    return are_within(a.block or a, b.block or b, clearance)


def nearest(s, x):
    """The point of a solid without its rounding, or of a block, that is nearest to x."""
    if isinstance(s, Block):
        at = s.center
        for side, half in zip(zip(*s.rotation), s.half):
            at = plus(at, side, max(-half, min(half, dot(plus(x, s.center, -1), side))))
        return at
    way = plus(x, s.center, -1)
    along = dot(way, s.axis)
    across = plus(way, s.axis, -along)
    far = norm(across)
    at = plus(s.center, s.axis, max(-s.height / 2, min(s.height / 2, along)))
    return plus(at, across, min(1, s.radius / far) if far > 0 else 0)


def reach(s, n):
    if isinstance(s, Block):
        return sum(half * abs(dot(side, n)) for side, half in zip(zip(*s.rotation), s.half))
    along = abs(dot(s.axis, n))
    return s.height / 2 * along + s.radius * math.sqrt(max(0, 1 - along * along))


def are_within(a, b, clearance):
    """From the one to the nearest point of the other and back: two points prove that they are, a plane that not."""
    room = clearance + a.rounding + b.rounding
    x = a.center
    for _ in range(STEPS):
        y = nearest(b, x)
        way = plus(x, y, -1)
        far = norm(way)
        if far <= room:
            return True
        n = [c / far for c in way]
        if dot(n, plus(a.center, b.center, -1)) - reach(a, n) - reach(b, n) > room:
            return False
        x = nearest(a, y)
    raise SystemExit(f'{a} - {b}: too near to {clearance} to be told')


def kind(s):
    if s.block:
        return s.block.kind
    return 'cylinder' if s.rounding == 0 else 'capsule' if s.height > 0 else 'sphere'
