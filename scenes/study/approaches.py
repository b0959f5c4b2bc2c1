#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What `daylight scene` should count in a robot, found without a line of its code: shapes by kind, places of solids,
pairs to check, and for each pair in how many configurations its solids come within a clearance. Reads URDF (with an
SRDF beside it) and MJCF as XML. Boxes and meshes are asked about by the solids of --bounds, and as they are. Prints
JSON."""
import argparse
import collections
import json
import math
import pathlib
import xml.etree.ElementTree

from approaches_mjcf import Hand
from approaches_shapes import (FOLD, Draw, Solid, about, are_within, block_of, corners, held, kind, moved, norm,
                               numbers, outside, plus, product, really_within, turned, vertices)
from approaches_tree import Tree


def origin_of(element):
    """(rotation, place) of the <origin> in an element."""
    origin = element.find('origin')
    xyz, rpy = ('0 0 0',) * 2 if origin is None else (origin.get('xyz', '0 0 0'), origin.get('rpy', '0 0 0'))
    roll, pitch, yaw = numbers(rpy)
    return product(about([0, 0, 1], yaw), product(about([0, 1, 0], pitch), about([1, 0, 0], roll))), numbers(xyz)


def fold(solids):
    """Each cylinder with a sphere at both ends becomes the capsule that holds all three. -> solids, how many"""
    left, folded = list(solids), 0
    for c in [s for s in solids if s.radius > 0]:
        ends = []
        for side in (-0.5, 0.5):
            end = plus(c.center, c.axis, side * c.height)
            near = [(norm(plus(s.center, end, -1)), s) for s in left if not s.block and s.radius == 0 and s.height == 0]
            near = [(off, s) for off, s in near
                    if off <= FOLD * c.radius and abs(s.rounding - c.radius) <= FOLD * c.radius]
            ends += [min(near, key=lambda pair: pair[0])] if near else []
        if len(ends) == 2 and ends[0][1] is not ends[1][1]:
            wider = max(0, *(off + s.rounding - c.radius for off, s in ends))
            left = [s for s in left if s is not ends[0][1] and s is not ends[1][1]]
            left[left.index(c)] = c._replace(radius=0, rounding=c.radius + wider)
            folded += 1
    return left, folded


class Robot(Tree):

    def __init__(self, file):
        root = xml.etree.ElementTree.parse(file).getroot()
        self.solids, self.folded, self.others = [], 0, collections.Counter()
        self.shapes = collections.Counter()
        self.folder = pathlib.Path(file).parent
        for link in root.findall('link'):
            self.read_link(link)
        self.joints = {j.find('child').get('link'): j for j in root.findall('joint')}
        self.parent = {link: j.find('parent').get('link') for link, j in self.joints.items()}
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

    def block(self, shape, rotation, place):
        """A box or a mesh; nothing of what cannot be read."""
        if shape.tag == 'box':
            return block_of('box', corners([x / 2 for x in numbers(shape.get('size'))]), rotation, place)
        name, scale = shape.get('filename'), numbers(shape.get('scale', '1 1 1'))
        package = name.removeprefix('package://')
        sought = [self.folder / name] if package == name else [up / package for up in self.folder.resolve().parents]
        for file in sought:
            if points := vertices(file):
                return block_of('mesh', [[x * s for x, s in zip(p, scale)] for p in points], rotation, place)
        return None

    def read_link(self, link):
        name, solids = link.get('name'), []
        kept = [c for c in link.findall('collision') if c.find('geometry/*') is not None]
        kept = [c for c in kept if c.find('geometry/*').tag in ('cylinder', 'sphere', 'capsule', 'box', 'mesh')]
        for number, collision in enumerate(kept, 1):
            shape = collision.find('geometry/*')
            rotation, place = origin_of(collision)
            own = collision.get('name') or (str(number) if len(kept) > 1 else '')
            whole = f'{name}/{own}' if own else name
            if shape.tag in ('box', 'mesh'):
                block = self.block(shape, rotation, place)
                solids += [held(whole, name, block)] if block else []
                self.others['mesh'] += not block
                continue
            wide, long = float(shape.get('radius')), float(shape.get('length', 0))
            solids.append(Solid(whole, name, place, [row[2] for row in rotation],
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
        return [moved(s, *poses[s.link]) for s in self.solids]

    def joined(self, link):
        return link in self.joints and self.joints[link].get('type') == 'fixed'

    def stands(self, link):
        world = self.parent[link]
        while self.joined(world):
            world = self.parent[world]
        return world not in self.parent and self.joints[link].get('type') not in ('fixed', 'revolute', 'continuous')


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('file')
    parser.add_argument('--clearance', type=float, default=0.02)
    parser.add_argument('--configurations', type=int, default=400)
    parser.add_argument('--seed', type=int, default=1)
    parser.add_argument('--each-link', action='store_true')
    parser.add_argument('--bounds', help='JSON: by name of a box or mesh [center, axis, radius, height, rounding]')
    parser.add_argument('--places', type=int, default=0, help='configurations of which all places are printed')
    told = parser.parse_args()
    robot = (Hand if told.file.endswith('.xml') else Robot)(told.file)
    if told.bounds:
        bounds = json.loads(pathlib.Path(told.bounds).read_text())
        robot.solids = [s._replace(**dict(zip(('center', 'axis', 'radius', 'height', 'rounding'), bounds[s.name])))
                        if s.block else s for s in robot.solids]
    pairs = list(robot.pairs(told.each_link))
    within, really, places = collections.Counter(), collections.Counter(), []
    for k in range(told.configurations):
        placed = robot.place(robot.draw(told.seed, k))
        if k < told.places:
            places.append({s.name: [s.block.center, [row[2] for row in s.block.rotation]] if s.block
                           else [s.center, s.axis] for s in placed})
        for i, j in pairs:
            within[i, j] += are_within(placed[i], placed[j], told.clearance)
            if told.bounds and (placed[i].block or placed[j].block):
                really[i, j] += really_within(placed[i], placed[j], told.clearance)
    names = [s.name for s in robot.solids]
    by_name = lambda counts: {' - '.join(sorted((names[i], names[j]))): n for (i, j), n in counts.items()}
    print(json.dumps({'shapes': dict(collections.Counter(map(kind, robot.solids)) + robot.others),
                      'not_looked_at': sum(robot.others.values()), 'folded': robot.folded, 'pairs': len(pairs),
                      'asked': len(pairs) * told.configurations, 'within': sum(within.values()),
                      'by_pair': by_name(within), 'really': by_name(really), 'places': places,
                      'outside': sum(outside(s) for s in robot.solids if s.block) if told.bounds else 0}))


if __name__ == '__main__':
    main()
