// SPDX-License-Identifier: MIT
// The exact predicate for users: the solver where its rounding bound decides, the referee where it does not.
#pragma once

#include "oracles/referee/referee.hpp"
#include "solver/decide.hpp"

namespace cyl {

/// Returns the certificate that the solver's answer carries.
Certificate certificate_of(const Answer& answer, const Cylinder& a, const Cylinder& b);

/// Do the two meet? Lengths of both in one unit, any; doubles are taken exactly. Proved, with certificate;
/// `touching` where the distance is exactly 0 and that could be proved; `undecided` as judge() is. Typical
/// cost: that of decide(); 20 us for flat solids that meet, 0.1 ms within rounding of touching, below 1 ms
/// for exact ties. Never throws. Thread-safe.
Truth decide_exactly(const Cylinder& a, const Cylinder& b);

}  // namespace cyl
