// SPDX-License-Identifier: MIT
// What the methods of the solver say, for who has asked the solver already.
#pragma once

#include "oracles/methods/method.hpp"
#include "solver/distance.hpp"

namespace cyl {

/// What the method `decide` answers; `decided` is decide(pair.a, pair.b).
MethodAnswer answer_of(const Pair& pair, const Answer& decided);

/// What the method `distance` answers; `measured` is distance(pair.a, pair.b).
MethodAnswer answer_of(const Pair& pair, const Distance& measured);

}  // namespace cyl
