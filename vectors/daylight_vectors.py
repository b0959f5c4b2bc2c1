# SPDX-License-Identifier: MIT
"""The test vectors: reads them, asks a function about them, and judges its answers. Also a plug-in of pytest:

    PYTHONPATH=vectors python3 -m pytest -p daylight_vectors --daylight mine:collide

It adds a test for each flag and decade of margin. The function gets two solids as dictionaries (center, axis, radius,
height, rounding, often quaternion). In v2 it also gets boxes and half-spaces, which have a shape. It returns one of
these:

* a bool (do they meet?),
* a number (the signed distance),
* one of the words disjoint, touching, intersecting and invalid,
* None (it has no such solids).

For an invalid pair it may raise ValueError instead. It runs in a process of its own, so that a hang or a crash is an
answer too.
"""
import importlib
import json
import math
import numbers
import os
import pathlib
import queue
import subprocess
import sys
import threading

try:
    from pytest import Collector, Item, UsageError, skip
except ImportError:  # to judge takes the standard library only
    Collector = Item = object

FOLDER = pathlib.Path(__file__).parent / 'v1'
V2 = FOLDER.parent / 'v2'
WORDS = ('disjoint', 'touching', 'intersecting', 'invalid')
LIMIT = 10.0  # seconds that an answer may take


def load(tier='smoke'):
    """The tier's JSON, {"vectors": [...], ...}. `tier` may also be v2, or a path of a file of `daylight vectors`."""
    path = V2 / 'vectors.jsonl' if tier == 'v2' else FOLDER / f'{tier}.json'
    text = (path if path.exists() else pathlib.Path(tier)).read_text(encoding='utf-8')
    if text.startswith('{"schema"'):
        return json.loads(text)
    return {'vectors': [with_names_of_v1(json.loads(line)) for line in text.splitlines()]}


def with_names_of_v1(v):
    low, high = v['answer']['distance']
    return dict(v, result=v['truth'], distance=[low, high], acceptable_below=max(high, -low))


def known_flags():
    """The meaning of each flag, its class of bug, and the projects that met it."""
    return {flag: about for folder in (FOLDER, V2)
            for flag, about in json.loads((folder / 'flags.json').read_text(encoding='utf-8')).items()}


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


def solid_of(solid):
    """A copy with numbers instead of the words of JSON."""
    def number(x):
        return [number(y) for y in x] if isinstance(x, list) else float(x)
    return dict({'rounding': 0.0}, **{name: x if name == 'shape' else number(x) for name, x in solid.items()})


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


def function_of(name):
    """`mine:collide`, from the folder that this runs in or from what is installed."""
    module, _, attribute = name.partition(':')
    if not attribute:
        raise ValueError(f'{name}: not MODULE:FUNCTION')
    if os.getcwd() not in sys.path:
        sys.path.insert(0, os.getcwd())
    return getattr(importlib.import_module(module), attribute)


class Asker:
    """Keeps a process that answers, and starts another after one that hung or ended."""

    def __init__(self, name, limit):
        self.name, self.limit, self.process = name, limit, None
        self.start()  # a function that is not there is noticed at once

    def start(self):
        path = os.pathsep.join(filter(None, sys.path))
        self.process = subprocess.Popen([sys.executable, '-c', f'from {__name__} import serve; serve({self.name!r})'],
                                        stdin=subprocess.PIPE, stdout=subprocess.PIPE, encoding='utf-8',
                                        env=dict(os.environ, PYTHONPATH=path))
        self.lines = queue.Queue()
        threading.Thread(target=self.listen, args=(self.process.stdout, self.lines), daemon=True).start()
        error = self.reply(None).get('failure')
        if error:
            self.close()
            raise ValueError(error)

    @staticmethod
    def listen(stream, lines):
        for line in stream:
            lines.put(line)
        lines.put(json.dumps({'failure': 'ended its process'}))

    def reply(self, seconds):
        try:
            return json.loads(self.lines.get(timeout=seconds))
        except queue.Empty:
            return {'failure': f'gave no answer within {seconds:g} s'}

    def ask(self, a, b, may_refuse):
        """Returns (the answer, None), or (None, why there is none)."""
        if self.process is None:
            self.start()
        try:
            self.process.stdin.write(json.dumps([a, b, may_refuse]) + '\n')
            self.process.stdin.flush()
        except OSError:  # it ended; the reply is why
            pass
        reply = self.reply(self.limit)
        if reply.get('ends', True) and 'said' not in reply:
            self.close()
        return reply.get('said'), reply.get('failure')

    def close(self):
        if self.process is not None:
            self.process.kill()
            self.process.wait()
            self.process.stdin.close()
            self.process = None


def answer(function, a, b, may_refuse):
    try:
        said = function(a, b)
        if not isinstance(said, (str, numbers.Real)) and getattr(said, 'ndim', 1) == 0:
            said = said.item()  # of NumPy
        if isinstance(said, numbers.Real) and not isinstance(said, bool):
            said = float(said)
    except ValueError as error:
        return {'said': 'invalid'} if may_refuse else {'failure': f'raised {error!r}', 'ends': False}
    except Exception as error:  # what a library raises is a finding
        return {'failure': f'raised {error!r}', 'ends': False}
    if said is not None and not isinstance(said, (str, bool, float)):
        return {'failure': f'said {said!r}, which is no answer', 'ends': False}
    return {'said': said}


def serve(name):
    """The process: a pair a line, and an answer a line. The prints of the function go to standard error."""
    answers = os.fdopen(os.dup(1), 'w', encoding='utf-8')
    os.dup2(2, 1)
    try:
        function = function_of(name)
    except (ValueError, OSError, ImportError, AttributeError) as error:
        print(json.dumps({'failure': str(error)}), file=answers, flush=True)
        return
    print(json.dumps({'said': None}), file=answers, flush=True)
    for line in sys.stdin:
        print(json.dumps(answer(function, *json.loads(line))), file=answers, flush=True)


class Run:
    """Asks about each vector once."""

    def __init__(self, name, vectors, tolerance=0.0, excluded=(), limit=LIMIT):
        self.asker, self.tolerance = Asker(name, limit), tolerance
        self.vectors = [v for v in vectors if v['id'] not in excluded]
        self.results = {}

    def result(self, v):
        if v['id'] not in self.results:
            said, failure = self.asker.ask(solid_of(v['a']), solid_of(v['b']), v['result'] == 'invalid')
            self.results[v['id']] = failure or judge(v, said, self.tolerance)
        return self.results[v['id']]

    def is_wrong(self, v):
        return self.result(v) not in ('right', 'acceptable', 'declined')

    def cells(self):
        """{(flag, decade): vectors}. A vector is in the cells of its flags."""
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


def report(flag, failing, results):
    """The text of a failure: how many, the simplest pair, and the class of bug."""
    v = min(failing, key=lambda v: (len(json.dumps([v['a'], v['b']])), v['id']))
    about = known_flags().get(flag, {})
    pair = json.dumps({k: {name: x for name, x in v[k].items() if name != 'quaternion'} for k in 'ab'})
    lines = [f'{len(failing)} wrong. The simplest, {v["id"]}: {results[v["id"]]}', pair]
    if about:
        lines.append(f'{flag}: {about["means"]} Class of bug: {", ".join(about["bugs"])}.')
        lines += [f'Met by {met}' for met in about['met_by'][:3]]
    return '\n  '.join(lines)


def pytest_addoption(parser):
    group = parser.getgroup('daylight', 'vectors of solids')
    group.addoption('--daylight', metavar='MODULE:FUNCTION', help='ask this function about each vector')
    group.addoption('--daylight-tier', default='smoke', help='smoke, standard, v2, or a file of `daylight vectors`')
    group.addoption('--daylight-tolerance', type=float, default=0.0, help='a length that the library states')
    group.addoption('--daylight-limit', type=float, default=LIMIT, help='seconds that an answer may take')
    group.addoption('--daylight-exclude', metavar='FILE', help='an id and a reason a line')


def pytest_collection_modifyitems(session, config, items):
    name = config.getoption('--daylight')
    if not name:
        return
    option = config.getoption
    try:
        config.daylight_run = run = Run(name, load(option('--daylight-tier'))['vectors'],
                                        option('--daylight-tolerance'), exclusions(option('--daylight-exclude')),
                                        option('--daylight-limit'))
    except (ValueError, OSError) as error:
        raise UsageError(f'--daylight: {error}') from error
    group = Group.from_parent(session, name='daylight', nodeid='daylight')
    items += [Cell.from_parent(group, name=f'{flag}[{decade}]', run=run, flag=flag, vectors=vectors)
              for (flag, decade), vectors in run.cells().items()]


def pytest_sessionfinish(session):
    if hasattr(session.config, 'daylight_run'):
        session.config.daylight_run.asker.close()


class Group(Collector):
    def collect(self):
        return []


class Wrong(Exception):
    pass


class Cell(Item):
    """All vectors with one flag and a margin in one decade."""

    def __init__(self, run, flag, vectors, **rest):
        super().__init__(**rest)
        self.vectors_run, self.flag, self.vectors = run, flag, vectors

    def runtest(self):
        failing = [v for v in self.vectors if self.vectors_run.is_wrong(v)]
        if failing:
            raise Wrong(report(self.flag, failing, self.vectors_run.results))
        if all(self.vectors_run.result(v) == 'declined' for v in self.vectors):
            skip('declined')

    def repr_failure(self, excinfo, style=None):
        return str(excinfo.value) if isinstance(excinfo.value, Wrong) else super().repr_failure(excinfo, style)

    def reportinfo(self):
        return self.path, None, f'{self.flag}, margin {self.name}'
