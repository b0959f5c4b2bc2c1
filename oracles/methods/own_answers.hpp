// SPDX-License-Identifier: MIT
// The answers of the solver's methods, for callers that have called the solver already.
#pragma once

#include "oracles/methods/method.hpp"
#include "oracles/referee/referee.hpp"
#include "solver/distance.hpp"

namespace cyl {

/// Returns the answer of the method `decide`, if `decided` is decide(pair.a, pair.b).
MethodAnswer answer_of(const Pair& pair, const Answer& decided);

/// The distance that the solver measured, in the referee's words.
inline MeasuredDistance measured_of(const Distance& d) { return {d.value, d.direction, d.on_a, d.on_b}; }

/// Returns the answer of the method `distance`, if `measured` is distance(pair.a, pair.b).
MethodAnswer answer_of(const Pair& pair, const Distance& measured);

}  // namespace cyl
