// SPDX-License-Identifier: MIT
// Checks with the referee whether a pair is within a clearance.
#pragma once

#include <cstddef>
#include <optional>

#include "solver/solid.hpp"

namespace cyl {

/// Returns whether the referee proves a pair within the clearance; nothing if it proves neither.
std::optional<bool> referee_within(const Pair& pair, double clearance);

/// Models answer by intersect(), which may be wrong so near to touching, as a multiple of the size.
inline constexpr double yes_or_no_tol = 1e-13;

struct Verification {
  std::size_t asked = 0, wrong = 0, tolerated = 0, undecided = 0;
  /// Checks with the referee whether the answer about the clearance is right. A false alarm up to `tolerance`
  /// beyond the clearance is tolerated, and so is any answer within yes_or_no_tol of the clearance.
  void add(const Pair& pair, double clearance, double tolerance, bool said);
  void add(const Verification& other);
};

}  // namespace cyl
