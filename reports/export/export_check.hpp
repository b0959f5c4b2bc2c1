// SPDX-License-Identifier: MIT
// Writes a check for any reader: a Python program with a pair and its certificate, which proves the truth
// again in rational arithmetic.
#pragma once

#include <string>

#include "oracles/trial/trial.hpp"

namespace cyl {

/// The axes of a pair as a method gets them.
enum class AxesGiven : unsigned char { as_they_are, of_unit_length };  ///< the latter rounded

/// Returns exact.py, which needs the standard library only. It exits with 0 if it proves everything, else
/// with 1. It proves the verdict of the given pair and of the pair as the method gets it. For a wrong
/// distance it proves that the returned distance is impossible, if a direction or two points show that.
/// Throws std::runtime_error if rounded axes change the verdict, because then the library is right. The truth
/// of `asked` is decided.
std::string exact_check(const Trial& asked, const Claim& claim, AxesGiven axes = AxesGiven::of_unit_length);

/// Returns whether exact_check() proves that the returned distance is impossible.
bool shows_distance(const Trial& asked, const Claim& claim);

}  // namespace cyl
