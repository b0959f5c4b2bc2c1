// SPDX-License-Identifier: MIT
// The faults of the text of 2017 that change a verdict, one at a time: what the program that looks for cases
// and the test that replays them share.
#pragma once

#include <span>
#include <string_view>

#include "oracles/referee/referee.hpp"
#include "solver/literature/separation_2017.hpp"

namespace cyl {

/// A fault that changes a verdict, and of what.
struct Fault2017 {
  std::string_view name;
  literature::Fault fault;
  bool of_the_whole;          ///< else of the perpendiculars to a's axis alone, which the rest would mend
  literature::Faults beside;  ///< that are in both times
};

inline std::span<const Fault2017> faults_2017() {
  using literature::Fault;
  static constexpr Fault2017 faults[] = {
      {"kink-taken-for-convex", Fault::kink_taken_for_convex, false, {}},
      {"first-quarter-ends-all", Fault::first_quarter_ends_all, false, {}},
      {"division-by-vanished-root", Fault::division_by_vanished_root, true, {}},
      {"one-octant", Fault::one_octant, true, {}},
      {"cancelling-sine", Fault::cancelling_sine, false, {}},
      {"touching-is-separated", Fault::touching_is_separated, true, {}},
      {"stays-on-the-boundary", Fault::stays_on_the_boundary, true, {}},
      {"cancelling-root", Fault::cancelling_root, true, Fault::stays_on_the_boundary},
      {"kinks-taken-for-smooth", Fault::kinks_taken_for_smooth, true, Fault::stays_on_the_boundary},
  };
  return faults;
}

/// In sizes: below it the text put right is rounding too.
inline constexpr double rounding_margin_2017 = 1e-12;

inline literature::Separation ask_2017(const Pair& pair, bool of_the_whole, literature::Faults faults) {
  literature::Options options;
  options.faults = faults;
  const Prepared a = prepare(pair.a), b = prepare(pair.b);
  return of_the_whole ? separated_cylinders(a, b, literature::Minimiser::conjugate_gradients, options)
                      : separated_by_perpendiculars_of_a(a, b, options);
}

inline MethodAnswer offered_2017(const literature::Separation& found) {
  MethodAnswer answer;
  answer.status = Status::answered;
  answer.verdict = found.verdict;
  answer.set_direction(found.direction);
  return answer;
}

/// Wrong with the fault, right without, by certificate. For a part of the text: it denies the direction that
/// proves the pair disjoint and that the part finds without the fault.
inline bool shows(const Fault2017& shown, const Pair& pair) {
  const literature::Separation right = ask_2017(pair, shown.of_the_whole, shown.beside);
  const literature::Separation wrong = ask_2017(pair, shown.of_the_whole, shown.beside | shown.fault);
  if (right.verdict == wrong.verdict || right.verdict == Verdict::undecided) return false;
  if (right.verdict == Verdict::disjoint)
    return check_witness(pair, offered_2017(right)) == Verdict::disjoint &&
           enclose_distance(pair, judge(pair)).lo >= rounding_margin_2017 * size_of(pair);
  if (!shown.of_the_whole) return false;
  // Rounding may say disjoint of what touches; only one fault says it on principle.
  const Verdict truth = judge(pair).verdict;
  return truth == (shown.fault == literature::Fault::touching_is_separated ? Verdict::touching
                                                                           : Verdict::intersecting);
}

}  // namespace cyl
