// SPDX-License-Identifier: MIT
#include "reports/triage/cause_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "base/safe_text.hpp"
#include "oracles/trial/algorithm_groups.hpp"
#include "oracles/trial/mechanism.hpp"

namespace cyl {
namespace {

/// The most labels listed with a cause.
constexpr std::size_t labels_cap = 6;

/// Describes what a method does that fails in this way.
const char* kind_in_words(FindingKind kind) {
  constexpr std::array words{"answers disjoint for pairs that meet",
                             "answers intersecting for disjoint pairs",
                             "answers touching for pairs that do not touch",
                             "answers invalid for valid pairs",
                             "returns a witness that proves nothing",
                             "returns a wrong distance",
                             "returns a number that is infinite, the largest double, or not a number",
                             "throws an exception",
                             "crashes",
                             "hangs",
                             "returns a meaningless answer",
                             "answers the same pair in two ways",
                             "the truth is undecided",
                             "is undecided on pairs that it claims to decide",
                             "answers, but has a forbidden side effect",
                             "fails after many pairs, but not on the pair alone",
                             "failed"};
  static_assert(words.size() == enum_values<FindingKind>.size());
  return words[static_cast<std::size_t>(kind)];
}

}  // namespace

std::string cause_in_words(const std::string& key, Mechanism mechanism,
                           const std::map<FindingKind, std::string>& reasons) {
  const bool within = key.ends_with("/within-claim");
  std::string said;
  for (const auto& [kind, reason] : reasons) {
    said += said.empty() ? "" : "; ";
    said += kind_in_words(kind);
    if (within && kind == FindingKind::bad_witness) said += ", by no more than the claim explains";
    const bool thrown = kind == FindingKind::exception;
    if (!reason.empty()) said += (thrown ? ", with the message: " : ": ") + escaped_controls(reason);
  }
  if (within) return "within its claim: " + said;
  return mechanism == Mechanism::unclassified ? said : fmt::format("{} ({})", in_words(mechanism), said);
}

std::vector<std::string> labels_of(const Cause& b, const CauseFindings& group, const ShownPair& simplest_now,
                                   const GroupedMethods& of) {
  const std::span<const std::unique_ptr<Method>> methods = of.methods;
  std::vector<std::string> labels{b.description};
  const auto own = position_of(methods, b.method);
  const bool was_asked = !own || simplest_now.asked[*own];
  if (!b.seen_again)
    labels.push_back(fmt::format(
        fmt::runtime(was_asked ? "not reproduced: {} does not fail in this way when it is asked alone"
                               : "not asked again: no time was left for {}, which hangs"),
        b.method));
  if (depends_on_last_bit(b.method, b.kind, group.simplest->pair).value_or(false))
    labels.push_back(shown_in_words(b) +
                     " depends on the last bit of our support function: the method is right if its sums "
                     "change their order");
  std::string elsewhere;
  if (own)
    for (const std::size_t sharer : methods_sharing_algorithm(of, *own))
      elsewhere += (elsewhere.empty() ? "" : ", ") + std::string(methods[sharer]->name());
  if (!elsewhere.empty()) labels.push_back("shared code, judging by common errors: " + elsewhere);
  std::vector<std::pair<std::size_t, std::string>> often;
  for (const auto& [label, n] : group.labels) often.emplace_back(group.findings.size() - n, label);
  std::sort(often.begin(), often.end());
  if (often.size() > labels_cap) often.resize(labels_cap);
  for (const auto& [rarity, label] : often)
    labels.push_back(rarity == 0 ? label
                                 : fmt::format("{} ({} of {})", label, group.findings.size() - rarity,
                                               group.findings.size()));
  std::string shared;
  for (std::size_t m = 0; m < methods.size(); ++m)
    if (const auto& wrong = simplest_now.trial.findings[m];
        methods[m]->name() != b.method && wrong && wrong->kind == b.kind)
      shared += (shared.empty() ? "" : ", ") + std::string(methods[m]->name());
  if (!shared.empty())
    labels.push_back(fmt::format("wrong in the same way on {}: {}", shown_in_words(b), shared));
  return labels;
}

}  // namespace cyl
