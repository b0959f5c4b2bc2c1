// SPDX-License-Identifier: MIT
#include "reports/triage/suppressed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "oracles/methods/contained.hpp"
#include "oracles/referee/referee.hpp"
#include "oracles/trial/algorithm_groups.hpp"
#include "oracles/trial/mechanism.hpp"

namespace cyl {
namespace {

constexpr std::size_t cases_at_once = 32;
constexpr Caps caps{
    .call_cpu = std::chrono::milliseconds(500), .call_wall = std::chrono::milliseconds(2000), .hangs = 1};

}  // namespace

std::set<std::string> causes_of(std::span<const std::unique_ptr<Method>> methods,
                                std::span<const Case> cases) {
  const std::vector<std::size_t> kin = kin_of(methods);
  std::set<std::string> causes;
  for (std::size_t first = 0; first < cases.size(); first += cases_at_once) {
    std::vector<Pair> pairs;
    std::vector<Question> questions;
    for (const Case& c : cases.subspan(first, std::min(cases_at_once, cases.size() - first)))
      pairs.push_back(c.pair);
    for (std::size_t m = 0; m < methods.size(); ++m)
      for (std::size_t p = 0; p < pairs.size(); ++p) questions.push_back({m, p});
    const std::vector<ContainedAnswer> said = ask_contained(methods, pairs, questions, caps);
    std::vector<Failing> failing;
    std::vector<Severity> severities;
    std::vector<std::string> reasons;
    for (std::size_t p = 0; p < pairs.size(); ++p) {
      std::vector<MethodAnswer> answers;
      for (std::size_t m = 0; m < methods.size(); ++m) answers.push_back(said[m * pairs.size() + p].answer);
      const Truth truth = judge(pairs[p], answers);
      LazyDistance distance([&](double width) { return enclose_distance(pairs[p], truth, width); });
      for (std::size_t m = 0; m < methods.size(); ++m) {
        const auto wrong = compare(pairs[p], truth, distance, methods[m]->claim(), answers[m]);
        if (!wrong) continue;
        failing.push_back({m, wrong->kind, pairs[p]});
        severities.push_back(wrong->severity);
        reasons.push_back(answers[m].reason);
      }
    }
    const std::vector<Told> told = tell_mechanisms(methods, kin, failing, caps);
    for (std::size_t i = 0; i < failing.size(); ++i)
      causes.insert(
          cause_key(methods, kin, failing[i].method, failing[i].kind, severities[i], told[i], reasons[i]));
  }
  return causes;
}

void mark_suppressed(GateReport& report, std::span<const std::unique_ptr<Method>> methods,
                     const std::vector<Suppression>& suppressions, std::string_view today) {
  if (suppressions.empty()) return;
  const std::vector<std::size_t> kin = kin_of(methods);
  for (GateFailure& f : report.failures) {
    if (find_suppression(suppressions, f.bucket, today) != nullptr) f.known = true;
    const auto kind = from_word<FindingKind>(f.kind);
    const auto method =
        std::find_if(methods.begin(), methods.end(), [&](const auto& m) { return m->name() == f.method; });
    if (f.known || !kind || method == methods.end()) continue;
    const Failing failing{static_cast<std::size_t>(method - methods.begin()), *kind, f.simplest};
    const Told told = tell_mechanisms(methods, kin, {&failing, 1}, caps)[0];
    const std::string cause = cause_key(methods, kin, failing.method, *kind, f.severity, told, f.reason);
    f.known = find_suppression(suppressions, cause, today) != nullptr;
  }
}

std::vector<std::string> remarks_on(const std::vector<Suppression>& suppressions, std::string_view today,
                                    const std::set<std::string>& causes, std::size_t& stale) {
  std::vector<std::string> remarks;
  stale = 0;
  for (const Suppression& s : suppressions) {
    const std::string which = fmt::format("the suppression of {} (line {})", s.bucket, s.line);
    if (is_expired(s, today))
      remarks.push_back(fmt::format("{} expired on {}; {} asked for it", which, s.expires, s.owner));
    if (causes.contains(s.bucket)) continue;
    remarks.push_back(which + " matches no stored case: remove it, or keep a case of it");
    ++stale;
  }
  return remarks;
}

}  // namespace cyl
