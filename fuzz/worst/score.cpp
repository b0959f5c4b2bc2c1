// SPDX-License-Identifier: MIT
#include "fuzz/worst/score.hpp"

#include <algorithm>
#include <cmath>

#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/referee/referee.hpp"
#include "oracles/trial/room.hpp"
#include "oracles/trial/shown_distance.hpp"
#include "oracles/trial/trial.hpp"
#include "solver/distance.hpp"

namespace cyl {
namespace {

/// Relative width at which depths are enclosed for `error`, a part of what is claimed of them.
constexpr double error_width = 1e-14;

/// The length that `claim` allows the error of the distance: of |Delta| as well, as solver/distance.hpp does.
double allowed(const Claim& claim, const Pair& pair) {
  const double size = size_of(pair);
  return claim.relative == 0 && claim.absolute == 0
             ? size
             : reach(claim, size + (pair.b.center - pair.a.center).norm());
}

/// The distance's error over its bound, at least and at most. Of a depth what is told bounds how much deeper
/// the solids are; how much less deep, which no direction shows, the claim.
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
  if (answer.told_error == 0)
    return {std::max({0.0, real.lo - said, said - real.hi}) / most,
            std::max(real.hi - said, said - real.lo) / most};
  const double deeper_told = said > 0 ? 0 : std::max(0.0, real.lo - said) / most;
  const Enclosure told = told_error_of(real, answer);
  return {std::max(deeper_told, told.lo / answer.told_error),
          std::max(deeper_told, told.hi / answer.told_error)};
}

double bound_over_claim(const Claim& claim, const Pair& pair, const MethodAnswer& answer) {
  return answer.verdict == Verdict::disjoint ? answer.told_error / allowed(claim, pair) : 0;
}

bool tells_distance(const MethodAnswer& answer) { return answer.has_distance || answer.told_error > 0; }

class Judge final : public Method {
 public:
  std::string_view name() const override { return "judge"; }
  std::string_view version() const override { return ""; }
  Claim claim() const override { return {.source = "oracles/referee/referee.hpp: Proves the verdict."}; }
  bool foreign() const override { return false; }
  bool takes(SolidKind) const override { return true; }
  MethodAnswer answer(const Pair& pair) override {
    const Truth truth = judge(pair);
    MethodAnswer answer;
    answer.status = Status::answered;
    answer.verdict = truth.verdict;
    answer.steps = truth.bits;
    answer.step_cap = precision_cap;
    return answer;
  }
};

}  // namespace

double likely_score(Search search, const Claim& claim, const Pair& pair, const MethodAnswer& answer) {
  switch (search) {
    case Search::steps:
      return answer.steps;
    case Search::bound:
      return bound_over_claim(claim, pair, answer);
    case Search::undecided:
      return answer.verdict == Verdict::undecided ? likely_room(pair) : 0;
    case Search::error: {
      if (!tells_distance(answer)) return 0;
      Trial trial(pair, judge_verdict(pair));
      return error_over_bound(trial, claim, answer, false).hi;
    }
    case Search::margin:
    case Search::time:
      break;
  }
  return 0;
}

ScoredPair proved_score(Search search, const Claim& claim, const Pair& pair, const MethodAnswer& answer) {
  const double likely = likely_score(search, claim, pair, answer);
  switch (search) {
    case Search::steps:
      return {pair, likely, answer.step_cap > 0 && answer.steps > answer.step_cap};
    case Search::undecided: {
      Trial trial(pair);
      const double room = answer.verdict == Verdict::undecided ? proved_room(trial) : 0;
      return {pair, room, claim.decides == Decides::beyond_rounding && room >= resolved_margin};
    }
    case Search::error: {
      if (!tells_distance(answer)) return {pair, 0, false};
      Trial trial(pair);
      const Enclosure ratio = error_over_bound(trial, claim, answer, true);
      return {pair, ratio.hi, ratio.lo > 1};
    }
    case Search::bound:
      return {pair, likely, likely > 1};
    case Search::margin:
    case Search::time:
      break;
  }
  return {pair, 0, false};
}

std::unique_ptr<Method> judge_method() { return std::make_unique<Judge>(); }

}  // namespace cyl
