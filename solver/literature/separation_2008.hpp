// SPDX-License-Identifier: MIT
// The text of 2008 evaluates the gap f(D) at directions with a zero or undefined gradient. Sections 6 and 7
// are here, 5 and 8 in separation_2008_circle.hpp, 9 to 13 in separation_2008_interior.hpp. No allocation.
#pragma once

#include "solver/decide.hpp"
#include "solver/literature/document.hpp"

namespace cyl::literature {

/// The ways in which section 8 looks at the directions perpendicular to an axis.
enum class CircleWay : unsigned char {
  polynomial,  ///< along the tangent line, roots of a polynomial of degree 8
  projection   ///< distance of a point to the other solid's projection, by a polynomial of degree 4
};

/// The text as printed, and the page of the book. equal_eigenvalues changes no verdict. sign_of_p0 is a way
/// in which a reader may continue, but neither text has it. See errata.md.
inline constexpr Faults printed_2008 = Faults(Fault::radius_not_squared) |
                                       Fault::derivative_of_the_wrong_term | Fault::wrong_b_squared |
                                       Fault::equal_eigenvalues | Fault::tangent_line_misses_u0 |
                                       Fault::negated_pair_ignored | Fault::cancelling_distance;
inline constexpr Faults printed_book = Faults(Fault::wrong_b_squared) | Fault::equal_eigenvalues;

/// `disjoint` with a direction of negative f, `intersecting` if none was found, `invalid`. Without faults
/// `disjoint` is as sure as the rounding of f (some 1e-15 of the lengths), and `intersecting` as sure as the
/// options allow. The square-root-free tests of section 7 are not checked, so with the fault
/// radius_not_squared the direction may be wrong. Cost: a circle 0.5 us (projection) or 20 us
/// (polynomial), critical points 3 us. Most pairs end in section 7.
Separation separation_2008(const Prepared& a, const Prepared& b, CircleWay circle,
                           const Options& options) noexcept;

}  // namespace cyl::literature
