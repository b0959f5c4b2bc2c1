// SPDX-License-Identifier: MIT
// A check for everybody: a Python program that holds a pair and what proves the truth about it, literally,
// and proves it again in rational arithmetic.
#pragma once

#include <optional>
#include <string>

#include "oracles/trial/trial.hpp"

namespace cyl {

/// What a method gets for the axes of a pair.
enum class AxesGiven : unsigned char { as_they_are, of_unit_length };  ///< the latter rounded

/// Returns exact.py, which needs the standard library only and exits with 0 where all is proved, else with 1.
/// It proves the verdict of the pair as asked and of the pair as the method gets it, and, of a wrong
/// distance, that the distance said is impossible, where a direction or two points show that. Throws
/// std::runtime_error where the rounding of the axes turns the verdict: then the library is not to blame.
/// `asked` is of decided truth.
std::string exact_check(const Trial& asked, const Claim& claim, AxesGiven axes = AxesGiven::of_unit_length);

/// Returns whether exact_check() shows the distance said to be impossible.
bool shows_distance(const Trial& asked, const Claim& claim);

}  // namespace cyl
