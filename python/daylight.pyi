# SPDX-License-Identifier: MIT
# The types of the Python module; installed as the stub package daylight-stubs.
from collections.abc import Callable
from enum import IntEnum
from typing import Any, NamedTuple

from numpy import float64, int8
from numpy.typing import ArrayLike, NDArray

class Verdict(IntEnum):
    disjoint = 0
    intersecting = 1
    touching = 2
    undecided = 3
    invalid = 4

class Hull(IntEnum):
    space = 0
    plane = 1
    line = 2
    center = 3

class Proof(IntEnum):
    none = 0
    direction = 1
    point = 2
    points = 3

class Decision(NamedTuple):
    verdict: Verdict | NDArray[int8]
    direction: NDArray[float64]
    point_head: NDArray[float64]
    point_tail: NDArray[float64]
    hull_a: Hull | NDArray[int8]
    hull_b: Hull | NDArray[int8]
    proof: Proof | NDArray[int8]

class Distance(NamedTuple):
    value: float | NDArray[float64]
    error: float | NDArray[float64]
    direction: NDArray[float64]
    on_a: NDArray[float64]
    on_b: NDArray[float64]
    verdict: Verdict | NDArray[int8]

def intersect(a: ArrayLike, b: ArrayLike) -> Verdict | NDArray[int8]: ...
def within(a: ArrayLike, b: ArrayLike, clearance: float) -> Verdict | NDArray[int8]: ...
def decide(a: ArrayLike, b: ArrayLike) -> Decision: ...
def decide_exactly(a: ArrayLike, b: ArrayLike) -> Verdict | NDArray[int8]: ...
def distance(a: ArrayLike, b: ArrayLike) -> Distance: ...
def campaign(
    callable: Callable[[NDArray[float64], NDArray[float64]], Any],
    pairs: int = 1000,
    seed: int = 0,
    relative: float = 0.0,
    absolute: float = 0.0,
) -> list[dict[str, Any]]: ...
