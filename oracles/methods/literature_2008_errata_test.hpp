// SPDX-License-Identifier: MIT
// The errata of the text of 2008 and of the page of the book as switches, one at a time: what the program
// that looks for cases and the test that replays them share.
#pragma once

#include <span>
#include <string_view>

#include "solver/literature/separation_2008.hpp"

namespace cyl {

struct Erratum {
  std::string_view id;    ///< of its case
  std::string_view what;  ///< for the case's source
  literature::Fault fault;
  literature::CircleWay circle;
  literature::CriticalWay critical;
};

/// Most work, smallest tolerance at which roots are still recognised.
inline literature::Options careful(literature::Faults faults) {
  return {.faults = faults, .step_cap = 60, .tolerance = 1e-3};
}

inline std::span<const Erratum> errata_2008() {
  using literature::CircleWay;
  using literature::CriticalWay;
  using literature::Fault;
  static constexpr Erratum errata[] = {
      {"errata-2008-radius-not-squared", "section 7, r1 instead of r1^2", Fault::radius_not_squared,
       CircleWay::polynomial, CriticalWay::normalised},
      {"errata-2008-parallel-distance-cancels", "section 7, |Delta|^2 - (W0.Delta)^2 of parallel axes",
       Fault::cancelling_distance, CircleWay::polynomial, CriticalWay::normalised},
      {"errata-2008-derivative-of-the-wrong-term", "section 8, b2 instead of a2 in G'",
       Fault::derivative_of_the_wrong_term, CircleWay::polynomial, CriticalWay::normalised},
      {"errata-2008-tangent-line-misses-u0", "section 8, the tangent line never reaches U0",
       Fault::tangent_line_misses_u0, CircleWay::polynomial, CriticalWay::normalised},
      {"errata-2008-vanished-derivative-term", "section 8, |A0 x + B0| = 0 is not W0 x W1",
       Fault::vanished_derivative_term, CircleWay::polynomial, CriticalWay::normalised},
      {"errata-2008-negated-pair-ignored", "section 10, half of the critical points",
       Fault::negated_pair_ignored, CircleWay::polynomial, CriticalWay::normalised},
      {"errata-2008-wrong-b-squared", "section 11, b^2", Fault::wrong_b_squared, CircleWay::polynomial,
       CriticalWay::normalised},
      {"errata-2008-equal-eigenvalues", "section 11, e0 = e1", Fault::equal_eigenvalues,
       CircleWay::polynomial, CriticalWay::normalised},
      {"errata-book-wrong-b-squared", "page 656, b^2", Fault::wrong_b_squared, CircleWay::minimise,
       CriticalWay::adjugate},
      {"errata-book-equal-eigenvalues", "page 656, e0 = e1", Fault::equal_eigenvalues, CircleWay::minimise,
       CriticalWay::adjugate},
  };
  return errata;
}

inline Verdict with_fault(const Erratum& e, const Pair& pair) {
  return literature::separation_2008(pair.a, pair.b, e.circle, e.critical, careful(e.fault)).verdict;
}
inline Verdict without_fault(const Erratum& e, const Pair& pair) {
  return literature::separation_2008(pair.a, pair.b, e.circle, e.critical, careful({})).verdict;
}

}  // namespace cyl
