// SPDX-License-Identifier: MIT
#include "oracles/trial/objective.hpp"

#include <algorithm>
#include <cmath>

#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/random_stream.hpp"
#include "oracles/referee/referee.hpp"
#include "oracles/trial/decidable_margin.hpp"
#include "oracles/trial/shown_distance.hpp"
#include "oracles/trial/trial.hpp"
#include "solver/distance.hpp"

namespace cyl {
namespace {

/// The relative width of enclosures of depths for `error`, a part of the error that a claim allows.
constexpr double error_width = 1e-14;

/// Returns the error of the distance that `claim` allows. Its length includes |Delta|, as in
/// solver/distance.hpp. If nothing is claimed, the whole length is allowed.
double allowed(const Claim& claim, const Pair& pair) {
  const double length = size_of(pair) + length_of(pair.b.center - pair.a.center);
  return claim.relative == 0 && claim.absolute == 0 ? length : reach(claim, length);
}

/// Returns the least and the greatest error of the distance over its bound. For a depth, the bound limits
/// how much deeper the solids are. No direction shows how much less deep they are, so the claim limits that.
Enclosure error_over_bound(Trial& trial, const Claim& claim, const MethodAnswer& answer, bool by_referee) {
  if (!trial.decided() || answer.verdict == Verdict::invalid) return {0, 0};
  const double said = answer.distance, most = allowed(claim, trial.pair);
  Enclosure real = shown_distance(trial.pair, distance(trial.pair.a, trial.pair.b));
  if (trial.truth.verdict == Verdict::touching)
    real = {0, 0};
  else if (trial.meets() || by_referee) {
    const Enclosure proved = trial.distance_at(error_width);
    real = {std::max(real.lo, proved.lo), std::min(real.hi, proved.hi)};
  }
  if (answer.error_bound == 0)
    return {std::max({0.0, real.lo - said, said - real.hi}) / most,
            std::max(real.hi - said, said - real.lo) / most};
  const double deeper_told = said > 0 ? 0 : std::max(0.0, real.lo - said) / most;
  const Enclosure told = error_bound_of(real, answer);
  return {std::max(deeper_told, told.lo / answer.error_bound),
          std::max(deeper_told, told.hi / answer.error_bound)};
}

class Judge final : public Method {
 public:
  std::string_view name() const override { return "judge"; }
  std::string_view version() const override { return ""; }
  Claim claim() const override { return {.source = "oracles/referee/referee.hpp: Proves the verdict."}; }
  bool foreign() const override { return false; }
  bool supports(SolidKind) const override { return true; }
  MethodAnswer answer(const Pair& pair) override { return answer_of(judge(pair)); }
};

}  // namespace

Badness badness_of(Objective objective, const Claim& claim, const Pair& pair, const MethodAnswer& answer,
                   Effort effort) {
  const bool proved = effort == Effort::proved;
  switch (objective) {
    case Objective::steps:
      return {static_cast<double>(answer.steps), answer.step_cap > 0 && answer.steps > answer.step_cap};
    case Objective::bound: {
      if (answer.verdict != Verdict::disjoint) return {};
      const double part = answer.error_bound / allowed(claim, pair);
      return {part, part > 1};
    }
    case Objective::undecided: {
      if (answer.verdict != Verdict::undecided) return {};
      if (!proved) return {estimated_margin(pair)};
      Trial trial(pair);
      const double slack = certified_margin(trial);
      return {slack, claim.decides == DecisionScope::above_1e13 && slack >= resolved_margin};
    }
    case Objective::error: {
      if (!answer.has_distance && !(answer.error_bound > 0)) return {};
      Trial trial = proved ? Trial(pair) : Trial(pair, judge_verdict(pair));
      const Enclosure ratio = error_over_bound(trial, claim, answer, proved);
      return {ratio.hi, proved && ratio.lo > 1};
    }
    case Objective::margin:
    case Objective::time:
      break;
  }
  return {};
}

MethodAnswer answer_of(const Truth& truth) {
  MethodAnswer answer;
  answer.status = Status::answered;
  answer.verdict = truth.verdict;
  answer.steps = truth.bits;
  answer.step_cap = precision_cap;
  return answer;
}

std::unique_ptr<Method> judge_method() { return std::make_unique<Judge>(); }

}  // namespace cyl
