// SPDX-License-Identifier: MIT
#include "scenes/study/verification.hpp"

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

void Verification::add(const Pair& pair, double clearance, double tolerance, bool said) {
  ++asked;
  const auto truth = referee_within(pair, clearance);
  if (!truth)
    ++undecided;
  else if (said != *truth)
    ++(said && enclose_distance(pair, judge(pair)).lo <= clearance + tolerance ? tolerated : wrong);
}

}  // namespace cyl
