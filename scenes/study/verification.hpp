// SPDX-License-Identifier: MIT
// Checks with the referee whether a pair is within a clearance.
#pragma once

#include <cstddef>
#include <optional>

#include "solver/solid.hpp"

namespace cyl {

/// Returns whether the referee proves a pair within the clearance; nothing if it proves neither.
std::optional<bool> referee_within(const Pair& pair, double clearance);

struct Verification {
  std::size_t asked = 0, wrong = 0, tolerated = 0, undecided = 0;
  /// Checks with the referee whether the answer about the clearance is right.
  void add(const Pair& pair, double clearance, double tolerance, bool said);
};

}  // namespace cyl
