// SPDX-License-Identifier: MIT
#include "scenes/study/verification.hpp"

#include <algorithm>

#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/referee/referee.hpp"

namespace cyl {

std::optional<bool> referee_within(const Pair& pair, double clearance) {
  if (clearance == 0) {
    const Verdict verdict = judge_verdict(pair).verdict;
    if (verdict == Verdict::undecided || verdict == Verdict::invalid) return std::nullopt;
    return verdict != Verdict::disjoint;
  }
  // If a solid has no rounding, the clearance can be its rounding exactly. Then a verdict is enough.
  for (const bool of_b : {false, true}) {
    Pair wider = pair;
    double& rounding = of_b ? wider.b.rounding : wider.a.rounding;
    if (rounding != 0) continue;
    rounding = clearance;
    if (is_legal(wider)) return referee_within(wider, 0);
  }
  const Enclosure distance = enclose_distance(pair, judge(pair));
  if (distance.lo > clearance) return false;
  return distance.hi <= clearance ? std::optional<bool>(true) : std::nullopt;
}

void Verification::add(const Verification& other) {
  asked += other.asked;
  wrong += other.wrong;
  tolerated += other.tolerated;
  undecided += other.undecided;
}

void Verification::add(const Pair& pair, double clearance, double tolerance, bool said) {
  ++asked;
  const auto truth = referee_within(pair, clearance);
  if (!truth) {
    ++undecided;
  } else if (said != *truth) {
    const Enclosure distance = enclose_distance(pair, judge(pair));
    const double claim = yes_or_no_tol * (size_of(pair) + clearance);
    ++((said ? distance.lo <= clearance + std::max(tolerance, claim) : distance.hi >= clearance - claim)
           ? tolerated
           : wrong);
  }
}

}  // namespace cyl
