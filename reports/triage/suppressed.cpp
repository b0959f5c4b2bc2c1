// SPDX-License-Identifier: MIT
#include "reports/triage/suppressed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "oracles/trial/algorithm_groups.hpp"
#include "oracles/trial/mechanism.hpp"
#include "oracles/trial/trial.hpp"

namespace cyl {
namespace {

constexpr std::size_t cases_at_once = 32;
constexpr Caps caps = attended_caps(1);

}  // namespace

std::set<std::string> causes_of(std::span<const std::unique_ptr<Method>> methods,
                                std::span<const Case> cases) {
  const std::vector<std::size_t> groups = algorithm_groups(methods);
  const GroupedMethods grouped{methods, groups};
  std::set<std::string> causes;
  for (std::size_t first = 0; first < cases.size(); first += cases_at_once) {
    std::vector<Pair> pairs;
    for (const Case& c : cases.subspan(first, std::min(cases_at_once, cases.size() - first)))
      pairs.push_back(c.pair);
    const std::vector<Trial> trials = try_methods(methods, pairs, caps);
    std::vector<Failing> failing;
    std::vector<std::pair<Severity, std::string>> found;  // severity and the method's own words
    for (const Trial& trial : trials)
      for (std::size_t m = 0; m < methods.size(); ++m) {
        const std::optional<Finding>& wrong = trial.findings[m];
        if (!wrong) continue;
        failing.push_back({m, wrong->kind, trial.pair});
        found.emplace_back(wrong->severity, trial.answers[m].reason);
      }
    const std::vector<Classification> classified = classify(methods, failing, caps);
    for (std::size_t i = 0; i < failing.size(); ++i)
      causes.insert(cause_key(grouped, failing[i], found[i].first, classified[i].mechanism, found[i].second));
  }
  return causes;
}

void mark_suppressed(JudgedGate& gate, std::span<const std::unique_ptr<Method>> methods,
                     const std::vector<Suppression>& suppressions, std::string_view today) {
  if (suppressions.empty()) return;
  const std::vector<std::size_t> groups = algorithm_groups(methods);
  for (JudgedFailure& f : gate.failures) {
    const auto excuse = [&](std::string_view key) {
      f.known |= find_suppression(suppressions, key, today) != nullptr;
    };
    excuse(f.bucket);
    const auto kind = from_word<FindingKind>(f.kind);
    const auto method = position_of(methods, f.method);
    if (f.known || !kind || !method) continue;
    const Failing failing{*method, *kind, f.simplest};
    const GroupedMethods grouped{methods, groups};
    const Mechanism mechanism = classify(methods, {&failing, 1}, caps).front().mechanism;
    excuse(cause_key(grouped, failing, f.severity, mechanism, f.reason));
  }
}

std::vector<GateRemark> suppression_remarks(const std::vector<Suppression>& suppressions,
                                            std::string_view today, const std::set<std::string>& causes) {
  std::vector<GateRemark> remarks;
  for (const Suppression& s : suppressions) {
    const std::string which = fmt::format("the suppression of {} (line {})", s.cause, s.line);
    if (is_expired(s, today))
      remarks.push_back({fmt::format("{} expired on {}; its owner is {}", which, s.expires, s.owner)});
    if (!causes.contains(s.cause))
      remarks.push_back({which + " matches no stored case: remove it, or keep a case of it", exit_findings});
  }
  return remarks;
}

}  // namespace cyl
