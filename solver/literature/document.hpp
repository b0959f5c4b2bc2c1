// SPDX-License-Identifier: MIT
// The methods of the documents this project starts from, as printed and put right, one file a document part.
// They stand here to be compared and to be learnt from, not for speed. Sources: D. Eberly, "Intersection of
// Cylinders", the texts of 2008 and 2017, and P. Schneider and D. Eberly, "Geometric Tools for Computer
// Graphics", p. 656.
#pragma once

#include <cstdint>

#include "solver/cylinder.hpp"

namespace cyl::literature {

/// What the documents get wrong, numbered as in errata.md. Each is a switch of the mended method, so that it
/// can be shown alone; `printed` has all that its document has.
enum class Fault : unsigned char {
  // 2017
  kink_taken_for_convex,      ///< F is said to be convex, its last term is not; no verdict depends on it
  first_quarter_ends_all,     ///< the test of one quarter circle returns for both
  division_by_vanished_root,  ///< F' at t = 1 of perpendicular axes, the gradient of G at an axis
  one_octant,                 ///< the other directions are searched for s, t >= 0 alone
  cancelling_sine,            ///< sqrt(1 - c^2) for the sine of the axes' angle, and W0 x W1 as it comes
  coincident_centers,         ///< Delta = 0 is excluded in the text and not tested; NaN, but no
  ///< verdict
  touching_is_separated,   ///< <= 0 in some tests, < 0 in others
  stays_on_the_boundary,   ///< once a line search ends on the triangle's boundary, only that is searched
  cancelling_root,         ///< |D|^2 - (D.W)^2 for |P D|^2: next to an axis only half of the digits are left
  kinks_taken_for_smooth,  ///< G is minimised as if it were smooth where D is perpendicular to an axis
  // 2008, and the page of the book where it says the same
  radius_not_squared,            ///< section 7: r |W0 x W1|^2 < rho^2
  derivative_of_the_wrong_term,  ///< section 8: -sigma2 b2 in G'(x), where a2 belongs
  wrong_b_squared,               ///< section 11: (r1^2 - e0 r0^2 det^2)/(e1 - e0)
  equal_eigenvalues,             ///< section 11: e0 = e1 divides by zero
  tangent_line_misses_u0,        ///< section 8: x U0 + V0 never is U0
  negated_pair_ignored,          ///< section 10: half of the critical points are thrown away
  vanished_derivative_term,      ///< section 8: |A0 x + B0| = 0 is said to be W0 x W1, and is not looked at
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
  constexpr bool has(Fault f) const { return (bits_ >> static_cast<unsigned>(f)) & 1; }

 private:
  std::uint32_t bits_ = 0;
};

/// How much work the searches may do, and which faults are in.
struct Options {
  Faults faults;
  int step_cap = 60;     ///< of every search along a line; of Newton's steps where something is polished
  double tolerance = 0;  ///< of a search's parameter, at which it ends; of a real root's imaginary part
  int line_cap = 60;     ///< of lines, or rounds of lines, in a search of two dimensions
};

/// `disjoint` with a direction D for which the method found f(D) < 0; else `intersecting`: the method found
/// none.
struct Separation {
  Verdict verdict = Verdict::undecided;
  Vector3 direction{0, 0, 0};
};

}  // namespace cyl::literature
