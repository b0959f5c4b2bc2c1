// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "base/safe_text.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "reports/triage/causes.hpp"

namespace cyl {
namespace {

/// Returns the cause with that key, if the run has it.
const Cause* find(const TriagedRun& run, const std::string& key) {
  for (const Cause& b : run.causes)
    if (b.status != Recurrence::gone && b.key == key) return &b;
  return nullptr;
}

/// Returns whether the run asked a method of the cause about one of its families.
bool asked_about(const TriagedRun& run, const Cause& b) {
  return std::ranges::any_of(run.tallies, [&](const TallyRecord& t) {
    return b.methods.contains(t.method) && b.families.contains(t.family) &&
           t.counts.asked > t.counts.declined;
  });
}

void compare(Cause& b, const TriagedRun& run, const std::vector<TriagedRun>& earlier) {
  b.first_seen = b.last_seen = run.id;
  b.first_version = b.last_version = version_in(run.methods, b.method);
  if (earlier.empty()) return;
  b.status = Recurrence::fresh;
  b.asked_before = std::ranges::any_of(earlier, [&](const TriagedRun& past) { return asked_about(past, b); });
  for (const TriagedRun& past : earlier) {
    const Cause* const found = find(past, b.key);
    if (found == nullptr) continue;
    b.status = Recurrence::known;
    b.first_seen = found->first_seen;
    b.first_version = found->first_version;
    return;
  }
}

/// Returns the causes of an earlier run that this run lacks, if it asked a method of theirs and their pair
/// was asked about again.
std::vector<Cause> missed(const TriagedRun& run, const TriagedRun& earlier, const FailsToday& fails_today) {
  std::vector<Cause> causes;
  for (const Cause& past : earlier.causes) {
    const auto asked = [&](const MethodRecord& m) { return past.methods.contains(m.name); };
    if (past.status == Recurrence::gone || find(run, past.key) != nullptr ||
        std::ranges::none_of(run.methods, asked))
      continue;
    const std::optional<bool> fails = fails_today(past);
    if (!fails) continue;
    Cause& b = causes.emplace_back(past);
    b.count = 0;
    b.findings.clear();
    b.status = *fails ? Recurrence::known : Recurrence::gone;
  }
  return causes;
}

/// The order in which causes are shown.
auto rank_of(const Cause& b) {
  return std::tuple(b.status.value_or(Recurrence::known), b.severity, !is_ordinary(b.simplest.pair),
                    ~b.count);
}

}  // namespace

std::string version_in(const std::vector<MethodRecord>& methods, const std::string& name) {
  const auto found = std::ranges::find(methods, name, &MethodRecord::name);
  return found == methods.end() ? "" : found->version;
}

void compare_with_earlier(TriagedRun& run, const std::vector<TriagedRun>& earlier,
                          const FailsToday& fails_today, const std::set<std::string>& certainly_new) {
  for (Cause& b : run.causes) {
    compare(b, run, earlier);
    if (!certainly_new.contains(b.key)) continue;
    b.status = Recurrence::fresh;
    b.asked_before = true;  // its pairs are those of an earlier run
  }
  if (!earlier.empty())
    for (Cause& b : missed(run, earlier.back(), fails_today)) run.causes.push_back(std::move(b));
  std::ranges::stable_sort(run.causes, {}, rank_of);
}

bool is_of_new_families(const Cause& b) { return b.status == Recurrence::fresh && !b.asked_before; }

std::string what_changed(const std::vector<Cause>& causes) {
  if (std::ranges::none_of(causes, [](const Cause& b) { return b.status.has_value(); }))
    return counted(causes.size(), "cause");
  std::string text;
  for (const Recurrence status : enum_values<Recurrence>) {
    const auto n = std::ranges::count(causes, std::optional(status), &Cause::status);
    if (status != Recurrence::fresh) {
      if (n > 0) text += fmt::format(", {} {}", n, to_string(status));
      continue;
    }
    text = counted(static_cast<std::uint64_t>(n), "new cause");
    const auto beyond = std::ranges::count_if(causes, [](const Cause& b) {
      return b.status == Recurrence::fresh && b.severity == Severity::contract;
    });
    if (beyond < n) text += fmt::format(" ({} beyond a claim)", beyond);
  }
  if (const auto n = std::ranges::count_if(causes, is_of_new_families); n > 0)
    text += fmt::format(
        ". For {}, no earlier run tested the method on these families, so it is unknown whether {} really "
        "new",
        counted(static_cast<std::uint64_t>(n), "new cause"), n == 1 ? "it is" : "they are");
  return text;
}

}  // namespace cyl
