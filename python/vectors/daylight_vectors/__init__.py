# SPDX-License-Identifier: MIT
"""Pairs of cylinders, capsules and spheres with what is proved of them, and a runner that puts them to a function.

    for v in daylight_vectors.load('smoke')['vectors']: ...
"""
import json
import pathlib

FOLDER = pathlib.Path(__file__).parent / 'v1'


def load(tier='smoke'):
    """The tier's JSON: {"vectors": [...], ...}. `tier` may also be a path, e.g. of what `daylight vectors` wrote."""
    path = FOLDER / f'{tier}.json'
    return json.loads((path if path.exists() else pathlib.Path(tier)).read_text(encoding='utf-8'))


def flags():
    """What each flag means, which class of bug it is and who met it."""
    return json.loads((FOLDER / 'flags.json').read_text(encoding='utf-8'))
