# SPDX-License-Identifier: MIT
"""The bodies of an MJCF file for scenes/study/approaches.py, moved as MuJoCo's documentation says: joint after joint."""
import collections
import copy
import math
import pathlib
import xml.etree.ElementTree

from approaches_shapes import (Draw, Solid, about, block_of, corners, dot, held, moved, norm, numbers, plus, product,
                               turned, vertices)
from approaches_tree import Tree

STILL = about([0, 0, 1], 0)
TURNS = ('axisangle', 'xyaxes', 'zaxis', 'euler', 'quat')


def of_quaternion(w, x, y, z):
    length = norm([x, y, z])
    return about([x, y, z], 2 * math.atan2(length, w)) if length else STILL


def from_z(to):
    axis = [-to[1], to[0], 0]
    if norm(axis) == 0:
        return STILL if to[2] > 0 else about([1, 0, 0], math.pi)
    return about(axis, math.atan2(norm(axis), to[2]))


class Joint:

    def __init__(self, hand, element, frame):
        self.name = element.get('name')
        self.kind = 'free' if element.tag == 'freejoint' else element.get('type', 'hinge')
        angle = hand.angle if self.kind == 'hinge' else 1
        rotation, place = frame
        self.anchor = plus(place, turned(rotation, numbers(element.get('pos', '0 0 0'))))
        self.axis = turned(rotation, numbers(element.get('axis', '0 0 1')))
        self.rest = angle * float(element.get('ref', 0))
        told, limits = element.get('limited', 'auto'), numbers(element.get('range', ''))
        if limits and (told == 'true' or (told == 'auto' and hand.autolimits)):
            self.low, self.high = (angle * x for x in limits)
        else:
            self.low, self.high = (-math.pi, math.pi) if self.kind == 'hinge' else (self.rest, self.rest)
        self.follows = None  # whom, how


class Hand(Tree):
    welds = True

    def __init__(self, file):
        self.root = xml.etree.ElementTree.parse(file).getroot()
        compiler = self.root.find('compiler')
        told = {} if compiler is None else compiler.attrib
        self.angle = 1 if told.get('angle') == 'radian' else math.pi / 180
        self.autolimits = told.get('autolimits') != 'false'
        self.eulerseq = told.get('eulerseq', 'xyz')
        self.folder = pathlib.Path(file).parent / told.get('meshdir', '')
        self.classes = {}
        for top in self.root.findall('default'):
            self.read_class(top, 'main', {})
        self.classes.setdefault('main', {})
        self.order, self.parent, self.at, self.joints = ['world'], {}, {}, {'world': []}
        self.solids, self.folded, self.others, self.shapes = [], 0, collections.Counter(), collections.Counter()
        self.count = collections.Counter(body=1)
        self.read_body(self.root.find('worldbody'), 'world', None)
        self.disabled = {frozenset((e.get('body1'), e.get('body2'))) for e in self.root.findall('contact/exclude')}
        by_name = {joint.name: joint for joints in self.joints.values() for joint in joints}
        for e in self.root.findall('equality/joint'):
            c = numbers(e.get('polycoef', '0 1 0 0 0'))
            by_name[e.get('joint1')].follows = by_name[e.get('joint2')], c

    def read_class(self, node, name, given):
        given = copy.deepcopy(given)
        for child in node:
            if child.tag != 'default':
                given.setdefault(child.tag, {}).update(child.attrib)
        self.classes[name] = given
        for child in node.findall('default'):
            self.read_class(child, child.get('class'), given)

    def full(self, element, childclass):
        """With what its class gives it; how it is turned comes from one of both."""
        given = dict(self.classes[element.get('class', childclass)].get(element.tag, {}))
        if set(TURNS) & set(element.attrib):
            given = {key: value for key, value in given.items() if key not in TURNS}
        return xml.etree.ElementTree.Element(element.tag, {**given, **element.attrib})

    def pose(self, element):
        place = numbers(element.get('pos', '0 0 0'))
        if element.get('axisangle'):
            x = numbers(element.get('axisangle'))
            return about(x[:3], self.angle * x[3]), place
        if element.get('xyaxes'):
            x, y = numbers(element.get('xyaxes'))[:3], numbers(element.get('xyaxes'))[3:]
            x = [c / norm(x) for c in x]
            y = plus(y, x, -dot(x, y))
            y = [c / norm(y) for c in y]
            z = [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]]
            return [list(row) for row in zip(x, y, z)], place
        if element.get('zaxis'):
            return from_z(numbers(element.get('zaxis'))), place
        if element.get('euler'):
            rotation = STILL
            for letter, x in zip(self.eulerseq, numbers(element.get('euler'))):
                step = about([float(letter.lower() == axis) for axis in 'xyz'], self.angle * x)
                rotation = product(rotation, step) if letter.islower() else product(step, rotation)
            return rotation, place
        return of_quaternion(*numbers(element.get('quat', '1 0 0 0'))), place

    def name(self, element):
        """Its own, or what MuJoCo counts it as."""
        kind = 'joint' if element.tag == 'freejoint' else element.tag
        self.count[kind] += 1
        return element.get('name') or f'{kind} {self.count[kind] - 1}'

    def parts(self, node, frame, childclass):
        """Joints, geoms and bodies, out of their frames: (element, frame, class)."""
        for child in node:
            inner = child.get('childclass', childclass)
            if child.tag == 'frame':
                rotation, place = self.pose(child)
                below = product(frame[0], rotation), plus(frame[1], turned(frame[0], place))
                yield from self.parts(child, below, inner)
            elif child.tag in ('joint', 'freejoint', 'geom', 'body'):
                yield child, frame, inner

    def read_body(self, node, name, parent, childclass='main'):
        parts = list(self.parts(node, (STILL, [0, 0, 0]), childclass))
        self.joints[name] = []
        for element, frame, inner in parts:
            if element.tag in ('joint', 'freejoint'):
                element.set('name', self.name(element))
                self.joints[name].append(Joint(self, self.full(element, inner), frame))
        for element, frame, inner in parts:
            if element.tag == 'geom':
                self.read_geom(self.full(element, inner), frame, name)
        for element, frame, inner in parts:
            if element.tag == 'body':
                below = self.name(element)
                rotation, place = self.pose(element)
                self.order.append(below)
                self.parent[below] = name
                self.at[below] = product(frame[0], rotation), plus(frame[1], turned(frame[0], place))
                self.read_body(element, below, name, inner)

    def read_geom(self, geom, frame, body):
        own, shape = self.name(geom), geom.get('type', 'sphere')
        name, bits = f'{body}/{own}', (int(geom.get('contype', 1)), int(geom.get('conaffinity', 1)))
        if bits == (0, 0):
            return
        self.shapes[body] += 1
        size, (rotation, place) = numbers(geom.get('size', '')), self.pose(geom)
        if geom.get('fromto') and shape != 'sphere':
            start, end = numbers(geom.get('fromto'))[:3], numbers(geom.get('fromto'))[3:]
            way = plus(start, end, -1)
            rotation, place = from_z(way), plus(end, way, 0.5)
            size = [size[0]] * (2 if shape in ('box', 'ellipsoid') else 1) + [norm(way) / 2]
        rotation, place = product(frame[0], rotation), plus(frame[1], turned(frame[0], place))
        points = []
        if shape == 'box':
            points = corners(size)
        elif shape == 'ellipsoid':
            points = [[s * x / norm(c) for s, x in zip(size, c)] for c in corners([1, 2, 3]) + corners([3, 1, 2])]
            points += [[s * x for s, x in zip(size, c)] for n in range(3) for c in ([float(i == n) for i in range(3)],)]
            points += [[-x for x in p] for p in points]
        elif shape == 'mesh':
            meshes = self.root.findall('asset/mesh')
            (asset, ) = (self.full(m, 'main') for m in meshes if m.get('name') == geom.get('mesh'))
            scale = numbers(asset.get('scale', '1 1 1'))
            points = [[x * s for x, s in zip(p, scale)] for p in vertices(self.folder / asset.get('file'))]
        if points:
            self.solids.append(held(name, body, block_of(shape, points, rotation, place), bits))
        elif shape in ('sphere', 'capsule', 'cylinder'):
            height = 0 if shape == 'sphere' else 2 * size[1]
            wide = (size[0], height, 0) if shape == 'cylinder' else (0, height, size[0])
            self.solids.append(Solid(name, body, place, [row[2] for row in rotation], *wide, None, bits))
        else:
            self.others[shape] += 1

    def joined(self, link):
        return link != 'world' and not self.joints[link]

    def welded(self, link):
        return link == 'world' or (self.joined(link) and self.welded(self.parent[link]))

    def stands(self, link):
        return self.welded(self.parent[link]) and not self.welded(link)

    def draw(self, seed, index):
        """The values of all joints, by name."""
        draw, values = Draw('scene', seed, index), {}
        joints = [j for body in self.order for j in self.joints[body] if j.kind in ('hinge', 'slide')]
        for j in joints:
            if not j.follows:
                values[j.name] = draw.between(j.low, j.high)
        while len(values) < len(joints):
            for j in joints:
                if j.follows and j.follows[0].name in values:
                    leader, c = j.follows
                    values[j.name] = c[0] + j.rest + c[1] * (values[leader.name] - leader.rest)
        return values

    def place(self, values):
        """The solids in the frame of the world."""
        poses = {'world': (STILL, [0, 0, 0])}
        for body in self.order[1:]:
            above, there = poses[self.parent[body]]
            rotation, place = self.at[body]
            rotation, place = product(above, rotation), plus(there, turned(above, place))
            for j in self.joints[body]:
                anchor, axis = plus(place, turned(rotation, j.anchor)), turned(rotation, j.axis)
                by = values.get(j.name, 0) - j.rest
                if j.kind == 'slide':
                    place = plus(place, axis, by / norm(axis))
                elif j.kind == 'hinge':
                    rotation = product(about(axis, by), rotation)
                    place = plus(anchor, turned(rotation, j.anchor), -1)
            poses[body] = rotation, place
        return [moved(s, *poses[s.link]) for s in self.solids]
