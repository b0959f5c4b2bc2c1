# SPDX-License-Identifier: MIT
"""Puts vectors to a function and judges what it returns; the same for the command line and for pytest.

The function gets two solids as dictionaries (center, axis, radius, height, rounding; often quaternion) and returns a
bool (do they meet?), a number (the signed distance), one of the words disjoint, touching, intersecting and invalid, or
None (it has no such solids). For an invalid pair it may raise ValueError instead.
"""
import json
import math
import numbers
import pathlib

from . import flags as known_flags
from .asking import Asker

WORDS = ('disjoint', 'touching', 'intersecting', 'invalid')
STORE = '.daylight-vectors.json'
LIMIT = 10.0  # seconds that an answer may take


def exclusions(path):
    """{id: reason} of a file with an id and a reason a line."""
    excluded = {}
    for number, line in enumerate(pathlib.Path(path).read_text(encoding='utf-8').splitlines() if path else (), 1):
        name, _, reason = line.strip().partition(' ')
        if not name or name.startswith('#'):
            continue
        if not reason.strip():
            raise ValueError(f'{path}:{number}: {name} is excluded without a reason')
        excluded[name] = reason.strip()
    return excluded


def failed_before(path=STORE):
    try:
        return json.loads(pathlib.Path(path).read_text(encoding='utf-8'))
    except (OSError, ValueError):
        return []


def remember(failed, path=STORE):
    if failed or pathlib.Path(path).exists():
        pathlib.Path(path).write_text(json.dumps(sorted(failed), indent=0) + '\n', encoding='utf-8')


def solid_of(solid):
    """A copy with numbers where JSON has words."""
    def number(x):
        return [number(y) for y in x] if isinstance(x, list) else float(x)
    return dict({'rounding': 0.0}, **{name: number(x) for name, x in solid.items()})


def judge(v, said, tolerance=0.0):
    """'right', 'acceptable' (within the tolerance that the library states), 'declined', or in words what is wrong."""
    if said is None:
        return 'declined'
    if isinstance(said, str) and said not in WORDS:
        return f'said {said!r}, which is none of {", ".join(WORDS)}'
    if v['result'] == 'invalid' or said == 'invalid':
        return 'right' if v['result'] == said else f'said {said!r} of a pair that is {v["result"]}'
    low, high = v['distance']
    within = tolerance > v['acceptable_below']
    if isinstance(said, numbers.Real) and not isinstance(said, bool):
        if math.isfinite(said) and low <= said <= high:
            return 'right'
        if math.isfinite(said) and low - tolerance <= said <= high + tolerance:
            return 'acceptable'
        return f'said a distance of {said!r}; it is from {low!r} to {high!r}'
    meets = said if isinstance(said, bool) else said != 'disjoint'
    if meets == (v['result'] != 'disjoint') and (said != 'touching' or v['result'] == 'touching'):
        return 'right'
    return 'acceptable' if within else f'said {said!r}; they are {v["result"]}, at a distance of {low!r} to {high!r}'


class Run:
    """Asks about each vector once, at first about those that failed last time."""

    def __init__(self, name, vectors, tolerance=0.0, excluded=None, store=STORE, limit=LIMIT):
        self.asker, self.tolerance, self.store = Asker(name, limit), tolerance, store
        self.excluded = excluded or {}
        self.before = set(failed_before(store))
        asked = [v for v in vectors if v['id'] not in self.excluded]
        self.vectors = sorted(asked, key=lambda v: v['id'] not in self.before)
        self.results = {}

    def result(self, v):
        first = [] if self.results else [w for w in self.vectors if w['id'] in self.before]
        for w in [*first, v]:
            if w['id'] not in self.results:
                said, failure = self.asker.ask(solid_of(w['a']), solid_of(w['b']), w['result'] == 'invalid')
                self.results[w['id']] = failure or judge(w, said, self.tolerance)
        return self.results[v['id']]

    def is_wrong(self, v):
        return self.result(v) not in ('right', 'acceptable', 'declined')

    def finish(self):
        """Stores the ids that fail; those that were not asked this time keep what they were."""
        self.asker.close()
        asked = {v['id']: v for v in self.vectors if v['id'] in self.results}
        remember([i for i, v in asked.items() if self.is_wrong(v)] + sorted(self.before - set(asked)), self.store)

    def cells(self):
        """{(flag, decade): vectors}: a vector is in the cell of each of its flags; what failed last time is first."""
        cells = {}
        for v in self.vectors:
            for flag in v['flags'] or ['General']:
                cells.setdefault((flag, decade_of(v)), []).append(v)
        return cells


def decade_of(v):
    """1e-03: a margin of 1e-3 to 1e-2 of the size."""
    if v['result'] in ('invalid', 'touching'):
        return v['result']
    return f'1e{math.floor(math.log10(v["margin"])):+03d}' if v['margin'] else 'unknown'


def simplest(vectors):
    return min(vectors, key=lambda v: (len(json.dumps([v['a'], v['b']])), v['id']))


def report(flag, failing, results):
    """What a reader of a failure needs: how many, the simplest pair and what is known of the class of bug."""
    v = simplest(failing)
    about = known_flags().get(flag, {})
    pair = json.dumps({k: {name: x for name, x in v[k].items() if name != 'quaternion'} for k in 'ab'})
    lines = [f'{len(failing)} wrong. The simplest, {v["id"]}: {results[v["id"]]}', pair]
    if about:
        lines.append(f'{flag}: {about["means"]} Class of bug: {", ".join(about["bugs"])}.')
        lines += [f'Met by {met}' for met in about['met_by'][:3]]
    return '\n  '.join(lines)
