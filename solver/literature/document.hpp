// SPDX-License-Identifier: MIT
// The methods of the documents this project starts from, as printed and put right, one file a document part.
// They stand here to be compared and to be learnt from, not for speed. Sources: D. Eberly, "Intersection of
// Cylinders", the texts of 2008 and 2017, and P. Schneider and D. Eberly, "Geometric Tools for Computer
// Graphics", p. 656.
#pragma once

#include <cstdint>

#include "solver/decide.hpp"

namespace cyl::literature {

/// Errors that a program can make that follows the documents. Each is a switch of the mended method. So it
/// can be shown alone or be removed from the printed text. See errata.md, which oracles/methods/errata.cpp
/// writes.
enum class Fault : unsigned char {
  // 2017
  kink_taken_for_convex,      ///< the text calls F convex, but its last term is not; no verdict depends on it
  first_quarter_ends_all,     ///< the test of one quarter circle returns for both
  division_by_vanished_root,  ///< F' at t = 1 of perpendicular axes, the gradient of G at an axis
  one_octant,                 ///< the other directions are searched for s, t >= 0 alone, as section 8 has it
  cancelling_sine,            ///< sqrt(1 - c^2) for the sine of the axes' angle, and W0 x W1 as it comes
  coincident_centers,         ///< section 7 is used for Delta = 0; NaN, but no verdict
  mixed_strictness,           ///< touching is apart, but not for the axes and for parallel solids
  stays_on_the_boundary,      ///< once a line search ends on the triangle's boundary, only that is searched
  cancelling_root,         ///< |D|^2 - (D.W)^2 for |P D|^2: next to an axis only half of the digits are left
  kinks_taken_for_smooth,  ///< G is minimised as if it were smooth for D perpendicular to an axis
  // 2008, and the page of the book if it has the same
  radius_not_squared,            ///< section 7: r |W0 x W1|^2 < rho^2
  derivative_of_the_wrong_term,  ///< section 8: -sigma2 b2 in G'(x) instead of a2
  wrong_b_squared,               ///< section 11: (r1^2 - e0 r0^2 det^2)/(e1 - e0)
  equal_eigenvalues,             ///< section 11: e0 = e1 divides by zero
  tangent_line_misses_u0,        ///< section 8: x U0 + V0 never is U0
  negated_pair_ignored,          ///< section 10: half of the critical points are thrown away
  sign_of_p0,                    ///< section 11: P_0 = r0 det(B0) eta0 points against eta0 if det(B0) < 0
  cancelling_distance            ///< section 7: |Delta|^2 - (W0.Delta)^2, parallel axes' distance squared
};

/// A set of them.
class Faults {
 public:
  constexpr Faults() = default;
  constexpr Faults(Fault f) : bits_(std::uint32_t{1} << static_cast<unsigned>(f)) {}
  constexpr friend Faults operator|(Faults x, Faults y) {
    x.bits_ |= y.bits_;
    return x;
  }
  constexpr Faults without(Fault f) const {
    Faults rest = *this;
    rest.bits_ &= ~Faults(f).bits_;
    return rest;
  }
  constexpr bool has(Fault f) const { return (bits_ >> static_cast<unsigned>(f)) & 1; }

 private:
  std::uint32_t bits_ = 0;
};

/// How much work the searches may do, which faults are in, and how the text is read.
struct Options {
  Faults faults{};
  int step_cap = 60;     ///< of every search along a line, and of Newton's steps of every polish
  double tolerance = 0;  ///< of a search's parameter, at which it ends; of a real root's imaginary part
  int line_cap = 60;     ///< of lines, or rounds of lines, in a search of two dimensions
  /// Only the text, without additions. Roles and axes stay as given (prepare_as_given). No found direction is
  /// checked again. No search ends early because it cannot succeed. No root or critical point is polished,
  /// and each must have the signs that were assumed.
  bool literal = false;
  bool touching_apart = false;  ///< f(D) <= 0 separates, as the text of 2017 has it; else f(D) < 0
};

/// Returns the options with one fault more.
constexpr Options with(Options options, Fault fault) noexcept {
  options.faults = options.faults | fault;
  return options;
}

/// Does the same as prepare(), except that the axis points as given.
inline Prepared prepare_as_given(const Solid& c) noexcept {
  Prepared p = prepare(c);
  const double first = c.axis.x() != 0 ? c.axis.x() : c.axis.y() != 0 ? c.axis.y() : c.axis.z();
  if (first < 0) p.unit_axis = -p.unit_axis;
  return p;
}

/// `disjoint` with a direction D for which the method found f(D) < 0. Else `intersecting`: the method found
/// none.
struct Separation {
  Verdict verdict = Verdict::undecided;
  Vector3 direction{0, 0, 0};
};

}  // namespace cyl::literature
