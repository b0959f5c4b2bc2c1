// SPDX-License-Identifier: MIT
// What the searches for steps, errors and undecided pairs make the most of: a number of one answer to one
// pair.
#pragma once

#include "fuzz/worst/worst.hpp"

namespace cyl {

/// Returns the score by the solver, or by an enclosure of the distance; 0 where the answer has none. Costs a
/// few us, for `error` up to 0.1 ms and of overlapping rods more.
double likely_score(Search search, const Claim& claim, const Pair& pair, const MethodAnswer& answer);

/// Returns the score that is proved, and whether that is beyond what the method promises: a told error that
/// is exceeded, or told beyond the claim; undecided beyond rounding. Steps are no promise, but for their cap.
ScoredPair proved_score(Search search, const Claim& claim, const Pair& pair, const MethodAnswer& answer);

/// The referee as a method, for searches for its slowest call: `steps` are the bits it took.
std::unique_ptr<Method> judge_method();

}  // namespace cyl
