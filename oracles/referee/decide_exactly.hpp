// SPDX-License-Identifier: MIT
// The exact predicate for users. If the solver's rounding bound does not decide a pair, the referee does.
#pragma once

#include "oracles/referee/referee.hpp"
#include "solver/decide.hpp"

namespace cyl {

/// Returns the certificate that the solver's answer carries.
Certificate certificate_of(const Answer& answer, const Solid& a, const Solid& b);

/// Decides whether the two solids meet. All lengths are in one unit of your choice. Doubles are taken
/// exactly.
/// 1. The verdict is proved, and comes with a certificate.
/// 2. `touching`: the distance is proved to be exactly 0.
/// 3. `undecided` in the cases of judge().
/// 4. Throws nothing. Thread-safe.
/// Typical cost: that of decide(). 20 us for flat solids that meet, 0.1 ms within rounding of touching, below
/// 1 ms for exact ties.
Truth decide_exactly(const Solid& a, const Solid& b);

}  // namespace cyl
