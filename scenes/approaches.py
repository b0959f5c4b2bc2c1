#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What `daylight scene` should count in a robot, found without a line of its code: shapes by kind, pairs to check, and
for each pair in how many configurations its solids come within a clearance. Reads URDF (with an SRDF beside it) as XML;
of MJCF it counts the shapes. Prints JSON."""
import argparse
import collections
import itertools
import json
import math
import pathlib
import xml.etree.ElementTree

WORD = (1 << 64) - 1
FOLD = 0.01  # of the radius: how far a sphere may be off the end of the cylinder that it closes
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


def origin_of(element):
    """(rotation, place) of the <origin> in an element."""
    origin = element.find('origin')
    xyz, rpy = ('0 0 0',) * 2 if origin is None else (origin.get('xyz', '0 0 0'), origin.get('rpy', '0 0 0'))
    roll, pitch, yaw = numbers(rpy)
    return product(about([0, 0, 1], yaw), product(about([0, 1, 0], pitch), about([1, 0, 0], roll))), numbers(xyz)


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


Solid = collections.namedtuple('Solid', 'name link center axis radius height rounding')


def fold(solids):
    """Each cylinder with a sphere at both ends becomes the capsule that holds all three. -> solids, how many"""
    left, folded = list(solids), 0
    for c in [s for s in solids if s.radius > 0]:
        ends = []
        for side in (-0.5, 0.5):
            end = plus(c.center, c.axis, side * c.height)
            near = [(norm(plus(s.center, end, -1)), s) for s in left if s.radius == 0 and s.height == 0]
            near = [(off, s) for off, s in near
                    if off <= FOLD * c.radius and abs(s.rounding - c.radius) <= FOLD * c.radius]
            ends += [min(near, key=lambda pair: pair[0])] if near else []
        if len(ends) == 2 and ends[0][1] is not ends[1][1]:
            wider = max(0, *(off + s.rounding - c.radius for off, s in ends))
            left = [s for s in left if s is not ends[0][1] and s is not ends[1][1]]
            left[left.index(c)] = c._replace(radius=0, rounding=c.radius + (wider if wider > 1e-9 * c.radius else 0))
            folded += 1
    return left, folded


class Robot:

    def __init__(self, file):
        root = xml.etree.ElementTree.parse(file).getroot()
        self.solids, self.folded, self.others = [], 0, collections.Counter()
        self.shapes = collections.Counter()
        for link in root.findall('link'):
            self.read_link(link)
        self.joints = {j.find('child').get('link'): j for j in root.findall('joint')}
        children = collections.defaultdict(list)
        for joint in sorted(self.joints.values(), key=lambda j: j.get('name')):
            children[joint.find('parent').get('link')].append(joint.find('child').get('link'))
        (base, ) = (link.get('name') for link in root.findall('link') if link.get('name') not in self.joints)
        self.order = []
        left = [base]
        while left:
            self.order.append(left.pop())
            left += reversed(children[self.order[-1]])
        srdf = pathlib.Path(file).with_suffix('.srdf')
        self.disabled = set()
        if srdf.exists():
            for e in xml.etree.ElementTree.parse(srdf).getroot().findall('disable_collisions'):
                self.disabled.add(frozenset((e.get('link1'), e.get('link2'))))

    def read_link(self, link):
        name, solids = link.get('name'), []
        kept = [c for c in link.findall('collision') if c.find('geometry/*') is not None]
        kept = [c for c in kept if c.find('geometry/*').tag in ('cylinder', 'sphere', 'capsule')]
        for number, collision in enumerate(kept, 1):
            shape = collision.find('geometry/*')
            rotation, place = origin_of(collision)
            wide, long = float(shape.get('radius')), float(shape.get('length', 0))
            own = collision.get('name') or (str(number) if len(kept) > 1 else '')
            solids.append(Solid(f'{name}/{own}' if own else name, name, place, [row[2] for row in rotation],
                                *((wide, long, 0) if shape.tag == 'cylinder' else (0, long, wide))))
        for collision in link.findall('collision'):
            shape = collision.find('geometry/*')
            if collision not in kept:
                self.others['nothing' if shape is None else shape.tag] += 1
        solids, folded = fold(solids)
        if len(solids) == 1 and not any(c.get('name') for c in kept):
            solids = [solids[0]._replace(name=name)]
        self.solids += solids
        self.folded += folded
        self.shapes[name] = len(link.findall('collision'))

    def moves(self, link):
        return link in self.joints and self.joints[link].get('type') in ('revolute', 'continuous', 'prismatic')

    def draw(self, seed, index):
        """The values of all joints, by link."""
        draw, values = Draw('scene', seed, index), {}
        for link in self.order:
            if not self.moves(link) or self.joints[link].find('mimic') is not None:
                continue
            limit = self.joints[link].find('limit')
            turns = self.joints[link].get('type') == 'continuous'
            low, high = (-math.pi, math.pi) if turns else (float(limit.get(k, 0)) for k in ('lower', 'upper'))
            values[link] = draw.between(min(low, high), max(low, high))
        by_name = {j.get('name'): link for link, j in self.joints.items()}
        waiting = [link for link in self.order if self.moves(link) and link not in values]
        while waiting:
            link = waiting.pop(0)
            mimic = self.joints[link].find('mimic')
            leader = by_name[mimic.get('joint')]
            if leader in values:
                values[link] = float(mimic.get('multiplier', 1)) * values[leader] + float(mimic.get('offset', 0))
            else:
                waiting.append(link)
        return values

    def place(self, values):
        """The solids in the frame of the base."""
        poses = {}
        for link in self.order:
            joint = self.joints.get(link)
            if joint is None:
                poses[link] = about([0, 0, 1], 0), [0, 0, 0]
                continue
            rotation, place = origin_of(joint)
            axis = numbers(joint.find('axis').get('xyz')) if joint.find('axis') is not None else [1, 0, 0]
            if link in values and joint.get('type') == 'prismatic':
                place = plus(place, turned(rotation, axis), values[link] / norm(axis))
            elif link in values:
                rotation = product(rotation, about(axis, values[link]))
            above, there = poses[joint.find('parent').get('link')]
            poses[link] = product(above, rotation), plus(there, turned(above, place))
        return [s._replace(center=plus(poses[s.link][1], turned(poses[s.link][0], s.center)),
                           axis=turned(poses[s.link][0], s.axis)) for s in self.solids]

    def rigid(self, each_link):
        """By link the first link of its rigid body."""
        first = {}
        for link in self.order:
            joined = not each_link and link in self.joints and self.joints[link].get('type') == 'fixed'
            first[link] = first[self.joints[link].find('parent').get('link')] if joined else link
        return first

    def pairs(self, each_link):
        first = self.rigid(each_link)
        solid = {first[link] for link, count in self.shapes.items() if count}
        near = collections.defaultdict(set)  # graph of rigid bodies that joints join
        for link in self.order:
            if link in self.joints and first[link] == link:
                parent = first[self.joints[link].find('parent').get('link')]
                near[link].add(parent)
                near[parent].add(link)

        def adjacent(a, b):
            seen, left = {a}, [a]
            while left:
                for c in near[left.pop()] - seen:
                    if c == b:
                        return True
                    seen.add(c)
                    left += [c] * (c not in solid)
            return False

        for i, j in itertools.combinations(range(len(self.solids)), 2):
            a, b = self.solids[i].link, self.solids[j].link
            if first[a] != first[b] and frozenset((a, b)) not in self.disabled and not adjacent(first[a], first[b]):
                yield i, j


def nearest(s, x):
    """The point of a solid without its rounding that is nearest to x."""
    way = plus(x, s.center, -1)
    along = dot(way, s.axis)
    across = plus(way, s.axis, -along)
    far = norm(across)
    at = plus(s.center, s.axis, max(-s.height / 2, min(s.height / 2, along)))
    return plus(at, across, min(1, s.radius / far) if far > 0 else 0)


def reach(s, n):
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
    raise SystemExit(f'{a.name} - {b.name}: too near to {clearance} to be told')


def kind(s):
    return 'cylinder' if s.rounding == 0 else 'capsule' if s.height > 0 else 'sphere'


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('file')
    parser.add_argument('--clearance', type=float, default=0.02)
    parser.add_argument('--configurations', type=int, default=400)
    parser.add_argument('--seed', type=int, default=1)
    parser.add_argument('--each-link', action='store_true')
    told = parser.parse_args()
    if told.file.endswith('.xml'):
        geoms = xml.etree.ElementTree.parse(told.file).getroot().findall('.//worldbody//geom')
        seen = [g for g in geoms if g.get('contype') != '0' or g.get('conaffinity') != '0']
        print(json.dumps({'shapes': collections.Counter(g.get('type', 'sphere') for g in seen)}))
        return
    robot = Robot(told.file)
    pairs = list(robot.pairs(told.each_link))
    within = collections.Counter()
    for k in range(told.configurations):
        placed = robot.place(robot.draw(told.seed, k))
        for i, j in pairs:
            within[i, j] += are_within(placed[i], placed[j], told.clearance)
    names = [s.name for s in robot.solids]
    print(json.dumps({'shapes': dict(collections.Counter(map(kind, robot.solids)) + robot.others),
                      'folded': robot.folded, 'pairs': len(pairs), 'asked': len(pairs) * told.configurations,
                      'within': sum(within.values()),
                      'by_pair': {' - '.join(sorted((names[i], names[j]))): within[i, j] for i, j in pairs}}))


if __name__ == '__main__':
    main()
