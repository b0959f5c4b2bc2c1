// SPDX-License-Identifier: MIT
// The answers of the solver's methods, for callers that have called the solver already.
#pragma once

#include "oracles/methods/method.hpp"
#include "solver/distance.hpp"

namespace cyl {

/// Returns the answer of the method `decide`, if `decided` is decide(pair.a, pair.b).
MethodAnswer answer_of(const Pair& pair, const Answer& decided);

/// Returns the answer of the method `distance`, if `measured` is distance(pair.a, pair.b).
MethodAnswer answer_of(const Pair& pair, const Distance& measured);

}  // namespace cyl
