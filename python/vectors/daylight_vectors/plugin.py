# SPDX-License-Identifier: MIT
"""The plug-in of pytest: pytest --daylight MODULE:FUNCTION adds a test for each flag and decade of margin."""
import pytest

from . import load
from .runner import LIMIT, STORE, Run, exclusions, report


def pytest_addoption(parser):
    group = parser.getgroup('daylight', 'vectors of cylinders, capsules and spheres')
    group.addoption('--daylight', metavar='MODULE:FUNCTION', help='ask this function about each vector')
    group.addoption('--daylight-tier', default='smoke', help='smoke, standard, or a file of `daylight vectors`')
    group.addoption('--daylight-tolerance', type=float, default=0.0, help='a length that the library states')
    group.addoption('--daylight-limit', type=float, default=LIMIT, help='seconds that an answer may take')
    group.addoption('--daylight-exclude', metavar='FILE', help='an id and a reason a line')
    group.addoption('--daylight-store', default=STORE, help='file of the ids that failed, which are asked first')


def pytest_collection_modifyitems(session, config, items):
    name = config.getoption('--daylight')
    if not name:
        return
    option = config.getoption
    try:
        config.daylight_run = run = Run(name, load(option('--daylight-tier'))['vectors'],
                                        option('--daylight-tolerance'), exclusions(option('--daylight-exclude')),
                                        option('--daylight-store'), option('--daylight-limit'))
    except (ValueError, OSError) as error:
        raise pytest.UsageError(f'--daylight: {error}') from error
    group = Group.from_parent(session, name='daylight', nodeid='daylight')
    items += [Cell.from_parent(group, name=f'{flag}[{decade}]', run=run, flag=flag, vectors=vectors)
              for (flag, decade), vectors in run.cells().items()]


def pytest_sessionfinish(session):
    if hasattr(session.config, 'daylight_run'):
        session.config.daylight_run.finish()


class Group(pytest.Collector):
    def collect(self):
        return []


class Wrong(Exception):
    pass


class Cell(pytest.Item):
    """All vectors with one flag and a margin in one decade."""

    def __init__(self, run, flag, vectors, **rest):
        super().__init__(**rest)
        self.vectors_run, self.flag, self.vectors = run, flag, vectors

    def runtest(self):
        failing = [v for v in self.vectors if self.vectors_run.is_wrong(v)]
        if failing:
            raise Wrong(report(self.flag, failing, self.vectors_run.results))
        if all(self.vectors_run.result(v) == 'declined' for v in self.vectors):
            pytest.skip('declined')

    def repr_failure(self, excinfo, style=None):
        return str(excinfo.value) if isinstance(excinfo.value, Wrong) else super().repr_failure(excinfo, style)

    def reportinfo(self):
        return self.path, None, f'{self.flag}, margin {self.name}'
