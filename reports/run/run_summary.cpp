// SPDX-License-Identifier: MIT
#include "reports/run/run_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "base/safe_text.hpp"
#include "corpus/pairs/finding.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/store/run_facts.hpp"
#include "oracles/methods/method.hpp"
#include "reports/run/tally_table.hpp"

namespace cyl {
namespace {

/// The most names in a line.
constexpr std::size_t named_cap = 3;

using Ranked = std::vector<std::pair<std::string, std::uint64_t>>;

/// Returns "ode 1804, mujoco 900 and 3 more", the most first, or "none". Lines stay below 120 columns.
std::string most_of(Ranked counts) {
  std::ranges::stable_sort(counts, std::greater(), &Ranked::value_type::second);
  std::string text;
  for (std::size_t i = 0; i < std::min(counts.size(), named_cap); ++i)
    text += fmt::format("{}{} {}", i == 0 ? "" : ", ", counts[i].first, counts[i].second);
  if (counts.size() > named_cap) text += fmt::format(" and {} more", counts.size() - named_cap);
  return text.empty() ? "none" : text;
}

/// Returns failures by method and kind: "ode crash 12".
Ranked failures_of(const RunData& run) {
  std::map<std::string, std::uint64_t> counts;
  for (const GroupRecord& g : run.groups) {
    if (is_failure(g.kind)) counts[g.method + ' ' + to_string(g.kind)] += g.count;
  }
  return {counts.begin(), counts.end()};
}

}  // namespace

std::vector<std::size_t> worst_first(const RunData& run) {
  std::set<std::string, std::less<>> of_texts;
  for (const auto& methods : {literature_2008_methods, literature_2017_methods})
    for (const auto& m : methods()) of_texts.emplace(m->name());
  using Rank = std::tuple<Severity, bool, bool, bool, double, std::size_t>;
  std::vector<Rank> ranks;
  for (std::size_t i = 0; i < run.findings.size(); ++i) {
    const FindingRecord& f = run.findings[i];
    const std::optional<Case>& line = run.pairs[i].line;
    ranks.emplace_back(f.severity, !line || !is_ordinary(line->pair), of_texts.contains(f.method),
                       !is_refuted_verdict(f.kind), f.margin ? -f.margin->lo : 0.0, i);
  }
  std::sort(ranks.begin(), ranks.end());
  std::vector<std::size_t> order;
  for (const Rank& rank : ranks) order.push_back(std::get<std::size_t>(rank));
  return order;
}

std::string format_summary(const RunData& run) {
  std::set<std::string, std::less<>> own_names;
  for (const auto& m : own_methods()) own_names.emplace(m->name());
  Ranked beyond;
  std::uint64_t judged = 0, undecided = 0, misstated = 0, all_beyond = 0, all_within = 0;
  std::size_t asked = 0, own = 0, own_wrong = 0;
  for (const MethodTally& m : tally_methods(run.tallies)) {
    const Counts& c = m.total;
    if (m.method == referee_row) judged = c.asked, undecided = c.undecided;
    if (m.method == corpus_row) misstated = c.contract;
    if (!is_method_row(m.method)) continue;
    ++asked;
    all_beyond += c.contract;
    all_within += c.resolution;
    if (c.contract > 0) beyond.emplace_back(m.method, c.contract);
    if (!own_names.contains(m.method)) continue;
    ++own;
    own_wrong += c.contract + c.failed > 0;
  }
  std::string text = escaped_controls(value_of(run.config, "fuzzing"), "\n");
  text += fmt::format("pairs: {}, {} undecided\nmethods: {}\n", judged, undecided, asked);
  std::uint64_t findings = 0;  // as the page counts them: all that follow
  for (const GroupRecord& g : run.groups) findings += g.count;
  text += fmt::format("findings: {}\n", grouped(findings));
  text += fmt::format("wrong beyond the claim: {}, {}\n  most: {}\n", counted(beyond.size(), "method"),
                      counted(all_beyond, "answer"), most_of(beyond));
  text += fmt::format("wrong within the claim: {}\n", counted(all_within, "answer"));
  text += fmt::format("failed: {}\n", most_of(failures_of(run)));
  if (misstated > 0) text += fmt::format("cases with a wrong verdict: {}\n", misstated);
  if (own > 0)
    text += fmt::format("our methods: {} of {} wrong beyond the claim or failed\n", own_wrong, own);
  return text;
}

}  // namespace cyl
