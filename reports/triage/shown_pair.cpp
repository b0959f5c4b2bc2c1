// SPDX-License-Identifier: MIT
#include "reports/triage/shown_pair.hpp"

#include <algorithm>
#include <utility>

namespace cyl {
namespace {

/// After this many hangs on all pairs together, a method that is not blamed is left out.
constexpr unsigned hangs_cap = 3;
/// The number of times that a question is asked in a row, which reveals a method that answers in two ways.
constexpr std::size_t times = 2;
/// The width of the distance, relative to the size.
constexpr double shown_width = 1e-6;

/// One question reveals a hang, and each further hang costs a second.
std::size_t times_of(FindingKind kind) { return kind == FindingKind::hang ? 1 : times; }

}  // namespace

bool fails_alone(std::span<const std::unique_ptr<Method>> methods, const FailingMethod& blamed,
                 const Pair& pair) {
  return try_methods(methods.subspan(blamed.method, 1), {&pair, 1}, shown_caps, times_of(blamed.kind))
      .front()
      .fails(blamed.kind);
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

ShownPair PairShower::show(const Pair& pair, std::span<const FailingMethod> blamed) {
  ShownPair shown;
  shown.asked.assign(methods_.size(), false);
  std::vector<Question> of_others, of_blamed;
  for (std::size_t m = 0; m < methods_.size(); ++m) {
    const auto accusation =
        std::find_if(blamed.begin(), blamed.end(), [m](const FailingMethod& b) { return b.method == m; });
    const bool failing = accusation != blamed.end();
    const bool cheap = failing && accusation->kind != FindingKind::hang;
    if ((!failing && hangs_[m] >= hangs_cap) || (!cheap && out_of_time_())) continue;
    shown.asked[m] = true;
    auto& questions = failing ? of_blamed : of_others;
    questions.insert(questions.end(), failing ? times_of(accusation->kind) : times, Question{m, 0});
  }
  std::vector<MethodAnswer> first(methods_.size()), last(methods_.size());
  const auto take = [&](std::span<const Question> questions, std::span<const ContainedAnswer> said) {
    for (std::size_t q = questions.size(); q-- > 0;) {  // backwards, so that `first` keeps the first answer
      const std::size_t m = questions[q].method;
      if (q + 1 == questions.size() || questions[q + 1].method != m) last[m] = said[q].answer;
      first[m] = said[q].answer;
      hangs_[m] += said[q].answer.failure == Failure::hang;
    }
  };
  take(of_others, asker_.ask({&pair, 1}, of_others));
  for (std::size_t q = 0, next = 0; q < of_blamed.size(); q = next) {
    while (next < of_blamed.size() && of_blamed[next].method == of_blamed[q].method) ++next;
    const auto one = std::span<const Question>(of_blamed).subspan(q, next - q);
    take(one, ask_contained(methods_, {&pair, 1}, one, shown_caps));
  }
  shown.trial = Trial(pair, first);
  for (std::size_t m = 0; m < methods_.size(); ++m) {
    auto& wrong = shown.trial.findings.emplace_back();
    if (!shown.asked[m]) continue;
    wrong = compare(shown.trial, methods_[m]->claim(), first[m]);
    if (!wrong && !same_answer(first[m], last[m]))
      wrong = Finding{FindingKind::nondeterminism, Severity::contract, {}};
  }
  shown.trial.answers = std::move(first);
  if (shown.trial.decided()) shown.trial.distance_at(shown_width);
  return shown;
}

}  // namespace cyl
