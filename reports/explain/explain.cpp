// SPDX-License-Identifier: MIT
#include "reports/explain/explain.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "base/safe_text.hpp"
#include "base/usage_error.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/truth_io.hpp"
#include "oracles/methods/contained.hpp"
#include "oracles/trial/algorithm_groups.hpp"
#include "oracles/trial/mechanism.hpp"

namespace cyl {
namespace {

/// The fewest samples on a side of an end of a range that show the end.
constexpr unsigned several = 3;

/// Describes the answer that was found beyond an end.
std::string beyond_in_words(const RegionEnd& end) {
  if (!end.beyond)
    return end.failing_samples >= several ? "as far as tried"
           : end.failing_samples > 0      ? counted(end.failing_samples, "sample") + " tried"
                                          : "nothing was tried";
  const Trial& p = *end.beyond;
  if (p.finding())
    return p.fails(end.failing.finding()->kind) && p.finding()->severity == Severity::resolution
               ? "within the claim"
               : to_string(p.finding()->kind);
  if (!p.decided()) return "truth unproved";
  if (p.answer().status != Status::answered || p.answer().verdict == Verdict::undecided) return "no answer";
  if (p.meets() != end.failing.meets()) return p.meets() ? "they meet" : "they are apart";
  return end.right_samples == 0 ? "right" : fmt::format("right ({})", counted(end.right_samples, "sample"));
}

/// The samples that fail, with the pair itself.
unsigned failing_samples(const FailingRegion& r) {
  return r.low.failing_samples + r.high.failing_samples + 1;
}

/// Returns whether the samples show that the failure ends there, and that the method ends it, not the truth
/// or a refusal to answer.
bool is_supported(const FailingRegion& r, const RegionEnd& end) {
  return end.beyond && end.beyond->right() && end.beyond->meets() == end.failing.meets() &&
         !end.fails_beyond && end.right_samples >= several && failing_samples(r) >= several;
}

/// Names the cause as triage does.
std::string cause_in_words(std::span<const std::unique_ptr<Method>> methods, const Failing& failing,
                           const Trial& asked) {
  const Method& own = *methods[failing.method];
  const Classification found = classify(methods, {&failing, 1}, probe_caps)[0];
  const auto groups = algorithm_groups(
      methods, [&](const Method& m) { return m.library() == own.library() && m.guest() == own.guest(); });
  const std::string key = cause_key({methods, groups}, failing, asked.finding()->severity, found.mechanism,
                                    asked.answer().reason);
  std::string text = "Triage calls the cause " + key;
  if (found.mechanism != Mechanism::unclassified) text += fmt::format(" ({})", in_words(found.mechanism));
  if (found.right_sibling) text += fmt::format("; {} is right", methods[*found.right_sibling]->name());
  return text + '.';
}

std::string number(double x) { return x == 0 ? "0" : fmt::format("{:.4g}", x); }

std::string regions_table(const std::vector<FailingRegion>& regions) {
  constexpr const char* row = "{:<16} {:>11} {:>11} {:>11} {:>8}   {:<18} {}\n";
  std::string text =
      fmt::format(fmt::runtime(row), "fails along", "from", "here", "to", "samples", "below", "above");
  for (const FailingRegion& r : regions)
    text += fmt::format(fmt::runtime(row), to_string(r.parameter), number(r.low.fails_at), number(r.at),
                        number(r.high.fails_at), failing_samples(r), beyond_in_words(r.low),
                        beyond_in_words(r.high));
  return text;
}

}  // namespace

std::vector<std::string> supported_ranges(const std::vector<FailingRegion>& regions) {
  std::vector<std::string> words;
  for (const FailingRegion& r : regions) {
    if (r.parameter == Parameter::distance) continue;
    const bool low = is_supported(r, r.low), high = is_supported(r, r.high);
    if (low && high)
      words.push_back(
          fmt::format("{} {:.3g} to {:.3g}", to_string(r.parameter), r.low.fails_at, r.high.fails_at));
    else if (low || high)
      words.push_back(fmt::format("{} {} {:.3g}", to_string(r.parameter), low ? "from" : "up to",
                                  low ? r.low.fails_at : r.high.fails_at));
  }
  return words;
}

std::string explain(std::span<const std::unique_ptr<Method>> methods, std::string_view name, FindingKind kind,
                    const Pair& pair) {
  const auto& method = find_method(methods, name);
  const Trial asked = try_method(method, pair);
  if (kind == FindingKind::state_dependent)
    throw UsageError(
        fmt::format("{} fails in this way only after other pairs, not on this pair alone", name));
  if (!asked.fails(kind))
    throw UsageError(fmt::format("{} has no {} on this pair now: it answers {}", name, to_string(kind),
                                 format_method_answer(asked.answer())));
  const std::string text = fmt::format(
      "{} answers {} for solids {}: {} ({})\n{}\n", name, one_line(format_method_answer(asked.answer())),
      distance_in_words(asked), to_string(kind), in_words(asked.finding()->severity), format_pair(pair));
  if (kind == FindingKind::hang)
    return text + fmt::format("Each hang takes {} s of CPU time, so no similar pair was asked about.\n",
                              std::chrono::duration<double>(cpu_cap_of(*method)).count());
  const std::vector<FailingRegion> regions = failing_regions(method, asked);
  const auto index = static_cast<std::size_t>(&method - methods.data());
  std::string sentences = cause_in_words(methods, {index, kind, pair}, asked);
  if (const auto only = supported_ranges(regions); !only.empty())
    sentences += fmt::format(" In the samples, it fails only with {}.", fmt::join(only, " and "));
  if (regions[0].at != 0 && std::isfinite(regions[0].at))
    sentences += fmt::format(" If {} change, b moves so that the distance stays the same.",
                             has_box(pair) ? "angle or lengths" : "angle, radii or heights");
  return text + '\n' + regions_table(regions) + '\n' + sentences + '\n';
}

}  // namespace cyl
