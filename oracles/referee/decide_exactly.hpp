// SPDX-License-Identifier: MIT
// The exact predicate for users: the solver where its rounding bound decides, the referee where it does not.
#pragma once

#include <array>

#include "oracles/referee/referee.hpp"
#include "solver/decide.hpp"

namespace cyl {

/// Returns the certificate that the solver's answer carries.
inline Certificate certificate_of(const Answer& answer) {
  const auto doubles = [](const Vector3& v) { return std::array<double, 3>{v[0], v[1], v[2]}; };
  switch (answer.proof) {
    case Proof::none:
      break;
    case Proof::direction:
      return {CertificateKind::direction, {doubles(answer.direction), {}, {}}, {}};
    case Proof::point:
      return {CertificateKind::point,
              {doubles(answer.point_head), doubles(answer.point_tail), {}},
              {},
              {answer.hull_a, answer.hull_b}};
  }
  return {};
}

/// Do the two meet? Lengths of both in one unit, any; doubles are taken exactly. Proved, with certificate;
/// `touching` where the distance is exactly 0 and that could be proved; `undecided` as judge() is. Typical
/// cost: that of decide(); 15 us for flat solids that meet, 0.1 ms within rounding of touching, below 1 ms
/// for exact ties. Never throws. Thread-safe.
Truth decide_exactly(const Cylinder& a, const Cylinder& b);

}  // namespace cyl
