# SPDX-License-Identifier: MIT
# The types of the Python module; installed as the stub package daylight-stubs.
from enum import IntEnum
from typing import Any, Mapping, NamedTuple

from numpy import float64, int8
from numpy.typing import ArrayLike, NDArray

class Verdict(IntEnum):
    disjoint = 0
    intersecting = 1
    touching = 2
    undecided = 3
    invalid = 4

class Distance(NamedTuple):
    value: float | NDArray[float64]
    error: float | NDArray[float64]
    direction: NDArray[float64]
    on_a: NDArray[float64]
    on_b: NDArray[float64]

Solid = ArrayLike | Mapping[str, Any]

def check(a: Solid, b: Solid) -> Verdict | NDArray[int8]: ...
def distance(a: Solid, b: Solid) -> Distance: ...
