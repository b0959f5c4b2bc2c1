// SPDX-License-Identifier: MIT
// The text of 2017 tries five kinds of directions D for f(D) < 0, in closed form if possible, else by a
// minimiser. It is corrected, except for the faults that the options switch on. Faults and cases: errata.md.
// Nothing here prints, throws, allocates or keeps state. Only + - * / sqrt.
#pragma once

#include "solver/decide.hpp"
#include "solver/detail/sections.hpp"
#include "solver/literature/document.hpp"

namespace cyl::literature {

/// Everything the text gets wrong.
inline constexpr Faults printed_2017 =
    Faults(Fault::kink_taken_for_convex) | Fault::first_quarter_ends_all | Fault::division_by_vanished_root |
    Fault::one_octant | Fault::cancelling_sine | Fault::coincident_centers | Fault::mixed_strictness |
    Fault::stays_on_the_boundary | Fault::cancelling_root | Fault::kinks_taken_for_smooth;

/// The whole test (section 8). `disjoint` with D, f(D) < 0 as computed and D.Delta >= 0; else `intersecting`,
/// or `invalid`. Without faults and not literal: the same bits for swapped roles, reversed axes and lengths
/// times 2^k, and wrong only below the margins of readings.md. Cost: 0.1 us if a closed form separates, and
/// some 20 us at the default caps if nothing does.
Separation separated_cylinders(const Prepared& a, const Prepared& b, const Options& options) noexcept;

// The parts. A Couple has unit axes and half heights; Delta points from the first centre to the second.

/// Equation (6), for D of any length.
double f(const Couple<double>& p, const Vector3& d) noexcept;

/// A direction D with f(D) < 0 as computed (literal: by the function that was searched), or none.
struct Direction {
  Direction() = default;
  Direction(const Vector3& d) noexcept : vector(d), found(true) {}
  explicit operator bool() const noexcept { return found; }

  Vector3 vector{0, 0, 0};
  bool found = false;
};

/// Section 6: D perpendicular to W0. The axes are not parallel.
Direction separated_by_cylinder_perpendiculars(const Couple<double>& p, const Options& options) noexcept;
/// Section 7, for any D. Delta must not be 0. Call it after the others, which handle the kinks of f.
Direction separated_by_other_directions(const Couple<double>& p, const Options& options) noexcept;

/// F of Equation (8): f on the quarter circle (1-t) U0 + t V0, 0 <= t <= 1.
struct Quarter {
  double r0, r1;
  double h1b1;       ///< half height of 1 times the sine of the axes' angle
  double c1_square;  ///< squared cosine
  double a2, b2;     ///< Delta along U0 and V0

  double value(double t) const noexcept;
  /// Sign((1-t) a2 + t b2): Delta's side of D.
  double sign(double t) const noexcept;
  /// F', Equation (9); at t = 1 of perpendicular axes from below.
  double slope(double t) const noexcept;
  /// To the letter: 0/0 there.
  double printed_slope(double t) const noexcept;
};

}  // namespace cyl::literature
