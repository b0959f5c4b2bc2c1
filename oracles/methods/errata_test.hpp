// SPDX-License-Identifier: MIT
// Whether a pair shows an erratum. The program that searches for cases and the test that replays them share
// this code.
#pragma once

#include <algorithm>
#include <memory>
#include <string>

#include "oracles/methods/errata.hpp"
#include "oracles/referee/referee.hpp"

namespace cyl {

/// The two methods that differ by one fault alone.
struct ShownErratum {
  explicit ShownErratum(const Erratum& e)
      : erratum(e), wrong(method_named(wrong_method(e))), right(method_named(right_method(e))) {}

  static std::unique_ptr<Method> method_named(const std::string& name) {
    for (auto methods : {literature_2008_methods, literature_2017_methods, errata_methods})
      for (auto& method : methods())
        if (method->name() == name) return std::move(method);
    return nullptr;
  }

  /// Returns whether the pair is at least `margin` sizes from touching, the right method gives the proved
  /// verdict, and the wrong method gives the opposite. For touching pairs the convention of section 3.1 is
  /// the truth.
  bool on(const Pair& pair, double margin) const {
    const Verdict said = wrong->ask(pair).verdict, known = right->ask(pair).verdict;
    if (said == known) return false;
    const Truth truth = judge(pair);
    if (truth.verdict == Verdict::undecided) return false;
    if (erratum.fault == literature::Fault::mixed_strictness)
      return truth.verdict == Verdict::touching && known == Verdict::disjoint;
    if ((truth.verdict == Verdict::disjoint) != (known == Verdict::disjoint)) return false;
    if ((truth.verdict == Verdict::disjoint) == (said == Verdict::disjoint)) return false;
    const Enclosure distance = enclose_distance(pair, truth);
    return std::max(distance.lo, -distance.hi) >= margin * size_of(pair);
  }

  const Erratum& erratum;
  std::unique_ptr<Method> wrong, right;
};

}  // namespace cyl
