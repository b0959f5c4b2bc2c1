// SPDX-License-Identifier: MIT
#include "reports/triage/shown_pair.hpp"

#include <utility>

namespace cyl {
namespace {

/// A method that hangs once on a pair would hang again.
constexpr Caps shown_caps = attended_caps(1);
/// After this many hangs on all pairs together, a method that is not blamed is left out.
constexpr unsigned hangs_cap = 3;
/// The width of the distance, relative to the size.
constexpr double shown_width = 1e-6;

/// Asks the method twice in a row, which reveals one that answers in two ways. One question reveals a hang,
/// and each further hang costs a second.
Trial ask_alone(std::span<const std::unique_ptr<Method>> methods, const FailingMethod& blamed,
                const Pair& pair) {
  const std::size_t times = blamed.kind == FindingKind::hang ? 1 : 2;
  return std::move(try_methods(methods.subspan(blamed.method, 1), {&pair, 1}, shown_caps, times).front());
}

}  // namespace

bool fails_alone(std::span<const std::unique_ptr<Method>> methods, const FailingMethod& blamed,
                 const Pair& pair) {
  return ask_alone(methods, blamed, pair).fails(blamed.kind);
}

bool ShownPair::fails(const FailingMethod& blamed) const {
  const std::optional<Finding>& wrong = trial.findings[blamed.method];
  return wrong && wrong->kind == blamed.kind;
}

PairShower::PairShower(std::span<const std::unique_ptr<Method>> methods, std::function<bool()> out_of_time)
    : methods_(methods),
      out_of_time_(std::move(out_of_time)),
      asker_(methods, shown_caps),
      hangs_(methods.size(), 0) {}

ShownPair PairShower::show(const Pair& pair, const std::optional<FailingMethod>& blamed) {
  ShownPair shown;
  shown.asked.assign(methods_.size(), false);
  std::vector<MethodAnswer> answers(methods_.size());
  const auto take = [&](std::size_t m, const MethodAnswer& said) {
    answers[m] = said;
    shown.asked[m] = true;
    hangs_[m] += said.failure == Failure::hang;
  };
  std::vector<Question> others;
  for (std::size_t m = 0; m < methods_.size() && !out_of_time_(); ++m)
    if (hangs_[m] < hangs_cap && !(blamed && blamed->method == m)) others.push_back({m, 0});
  const std::vector<ContainedAnswer> said = asker_.ask({&pair, 1}, others);
  for (std::size_t q = 0; q < others.size(); ++q) take(others[q].method, said[q].answer);
  std::optional<Finding> of_blamed;
  if (blamed && !(blamed->kind == FindingKind::hang && out_of_time_())) {
    const Trial alone = ask_alone(methods_, *blamed, pair);
    take(blamed->method, alone.answer());
    of_blamed = alone.finding();
  }
  shown.trial = Trial(pair, answers);
  for (std::size_t m = 0; m < methods_.size(); ++m) {
    auto& wrong = shown.trial.findings.emplace_back();
    if (blamed && blamed->method == m)
      wrong = of_blamed;
    else if (shown.asked[m])
      wrong = compare(shown.trial, methods_[m]->claim(), answers[m]);
  }
  shown.trial.answers = std::move(answers);
  if (shown.trial.decided()) shown.trial.distance_at(shown_width);
  return shown;
}

}  // namespace cyl
