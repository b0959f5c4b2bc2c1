#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draws configurations of a URDF. The exit code is 1 if links touch that an SRDF disables as "Never", or come nearer
than their proof states. It has its own kinematics and distances, and shares no line with daylight."""
import argparse
import html
import math
import re
import xml.etree.ElementTree

import numpy as np

FEW, MANY = 4, 60  # projections from solid to solid: of all configurations, and more of the nearest tenth


def numbers(text):
    return np.array([float(x) for x in text.split()])


def origin_of(element):
    attributes = {} if element.find('origin') is None else element.find('origin').attrib
    roll, pitch, yaw = numbers(attributes.get('rpy', '0 0 0'))
    turn = about([0, 0, 1], yaw) @ about([0, 1, 0], pitch) @ about([1, 0, 0], roll)
    return turn, numbers(attributes.get('xyz', '0 0 0'))


def about(axis, angle):
    """Rotations by one angle or many."""
    x, y, z = np.asarray(axis, float) / np.linalg.norm(axis)
    k = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    angle = np.asarray(angle)[..., None, None]
    return np.eye(3) + np.sin(angle) * k + (1 - np.cos(angle)) * (k @ k)


class Solid:
    """A core (a point, segment, cylinder or box along its own axes), grown by a rounding."""
    def __init__(self, collision):
        shape = collision.find('geometry/*')
        self.turn, self.place = origin_of(collision)
        self.box, self.radius, self.half, self.rounding = None, 0.0, 0.0, 0.0
        if shape.tag == 'box':
            self.box = numbers(shape.get('size')) / 2
        elif shape.tag == 'sphere':
            self.rounding = float(shape.get('radius'))
        elif shape.tag == 'mesh':
            self.rounding = math.inf  # of what is not read nothing may be said
        else:
            self.half = float(shape.get('length')) / 2
            setattr(self, 'radius' if shape.tag == 'cylinder' else 'rounding', float(shape.get('radius')))
        self.reach = np.linalg.norm(self.box) if self.box is not None else math.hypot(self.radius, self.half)

    def nearest(self, frames, points):
        """The points of the core that are nearest to others."""
        turn, place = frames
        own = np.einsum('nji,nj->ni', turn, points - place)
        if self.box is not None:
            own = np.clip(own, -self.box, self.box)
        else:
            wide = np.linalg.norm(own[:, :2], axis=1)
            own[:, :2] *= np.minimum(1, self.radius / np.maximum(wide, 1e-300))[:, None]
            own[:, 2] = np.clip(own[:, 2], -self.half, self.half)
        return place + np.einsum('nij,nj->ni', turn, own)


def least_distance(a, b, of_a, of_b, floor):
    """The least over all configurations; those whose balls are farther apart than `floor` are not looked at."""
    a_at, b_at = [(turn @ s.turn, place + turn @ s.place) for s, (turn, place) in ((a, of_a), (b, of_b))]
    balls = np.linalg.norm(a_at[1] - b_at[1], axis=1) - a.reach - b.reach - a.rounding - b.rounding
    near = balls <= floor
    if not near.any():
        return float(balls.min())
    a_at, b_at = [[v[near] for v in frames] for frames in (a_at, b_at)]
    x = a_at[1]
    for step in range(FEW + MANY):
        y = b.nearest(b_at, x)
        x = a.nearest(a_at, y)
        if step == FEW:
            far = np.linalg.norm(x - y, axis=1)
            nearest = np.argsort(far)[:max(100, len(far) // 10)]
            x, a_at, b_at = x[nearest], [v[nearest] for v in a_at], [v[nearest] for v in b_at]
    return float(np.linalg.norm(x - b.nearest(b_at, x), axis=1).min()) - a.rounding - b.rounding


class Robot:
    def __init__(self, file):
        root = xml.etree.ElementTree.parse(file).getroot()
        self.joints = {j.find('child').get('link'): j for j in root.findall('joint')}
        self.solids = {link.get('name'): [Solid(c) for c in link.findall('collision')] for link in root.findall('link')}

    def draw(self, rng, count):
        """Values by joint; a continuous one turns many times. Joints mimic those that mimic none."""
        values = {}
        for joint in self.joints.values():
            limits = [-64 * math.pi, 64 * math.pi]
            if joint.get('type') in ('revolute', 'prismatic'):
                limits = sorted(float(joint.find('limit').get(key, 0)) for key in ('lower', 'upper'))
            values[joint.get('name')] = rng.uniform(*limits, count)
        for joint in (j for j in self.joints.values() if j.find('mimic') is not None):
            times, offset = (float(joint.find('mimic').get(*key)) for key in (('multiplier', 1), ('offset', 0)))
            values[joint.get('name')] = times * values[joint.find('mimic').get('joint')] + offset
        return values

    def place(self, values, rng, count):
        poses = {}
        while len(poses) < len(self.solids):
            for link in self.solids:
                if (joint := self.joints.get(link)) is None:
                    poses[link] = np.broadcast_to(np.eye(3), (count, 3, 3)), np.zeros((count, 3))
                elif link not in poses and joint.find('parent').get('link') in poses:
                    (above, there), (turn, place) = poses[joint.find('parent').get('link')], origin_of(joint)
                    poses[link] = self.moved(joint, above @ turn, there + above @ place, values, rng)
        return poses

    def moved(self, joint, turn, place, values, rng):
        axis = numbers('1 0 0' if joint.find('axis') is None else joint.find('axis').get('xyz'))
        value, kind = values[joint.get('name')], joint.get('type')
        if kind == 'prismatic':
            place = place + turn @ (axis / np.linalg.norm(axis)) * value[:, None]
        if kind in ('planar', 'floating'):  # wherever it likes, within 2 m
            by = rng.uniform(-2, 2, (len(value), 3)) * ([1, 1, 0] if kind == 'planar' else 1)
            place = place + np.einsum('nij,nj->ni', turn, by)
        return turn @ about(axis, value * (kind not in ('prismatic', 'fixed'))), place


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('files', nargs=2, metavar='FILE', help='a URDF, its SRDF')
    parser.add_argument('--configurations', type=int, default=1_000_000)
    arguments = parser.parse_args()
    robot, rng = Robot(arguments.files[0]), np.random.default_rng(1)
    told_never = re.findall(r'link1="(.*?)" link2="(.*?)" reason="Never"/>(?:.*?at least ([-0-9.e]+))?',
                            open(arguments.files[1], encoding='utf-8').read())
    bounds = {(html.unescape(a), html.unescape(b)): float(bound or 0) for a, b, bound in told_never}
    least = dict.fromkeys(bounds, math.inf)
    for begin in range(0, arguments.configurations, 100_000):
        count = min(100_000, arguments.configurations - begin)
        poses = robot.place(robot.draw(rng, count), rng, count)
        for (a, b), before in least.items():
            seen = [least_distance(x, y, poses[a], poses[b], before) for x in robot.solids[a] for y in robot.solids[b]]
            least[a, b] = min([before, *seen])
    wrong = [(a, b, seen, bounds[a, b]) for (a, b), seen in least.items() if seen <= bounds[a, b]]
    for a, b, seen, bound in wrong:
        print(f'WRONG: {a} - {b}: {seen:.6g} seen, more than {bound} proved')
    print(f'{len(least)} pairs "Never", {len(wrong)} wrong in {arguments.configurations} configurations; one comes as near '
          f'to its bound as {min((least[pair] - bounds[pair] for pair in least), default=math.inf):.3g}')
    raise SystemExit(bool(wrong) or not least)


if __name__ == '__main__':
    main()
