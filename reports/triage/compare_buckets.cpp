// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/json.hpp"
#include "fuzz/campaign/climbed.hpp"
#include "reports/triage/buckets.hpp"

namespace cyl {
namespace {

/// Nights that are shown with a cause.
constexpr std::size_t nights_cap = 60;

/// The run's bucket of that cause, by the key of today or of 0.1.0, if it has it.
const Bucket* find(const TriagedRun& run, const Bucket& of) {
  for (const Bucket& b : run.buckets)
    if (b.status != Recurrence::gone &&
        (b.key == of.key || of.former_keys.contains(b.key) || b.former_keys.contains(of.key)))
      return &b;
  return nullptr;
}

/// Pairs that a method of the bucket was asked in its families, at most.
std::uint64_t asked_in(const TriagedRun& run, const Bucket& of) {
  std::map<std::string, std::uint64_t> asked;
  for (const TallyRecord& t : run.tallies)
    if (of.methods.contains(t.method) && of.families.contains(t.family))
      asked[t.method] +=
          independent_draws(t.family, t.counts.asked - std::min(t.counts.asked, t.counts.declined));
  std::uint64_t most = 0;
  for (const auto& [method, n] : asked) most = std::max(most, n);
  return most;
}

/// Of a bucket that an earlier build stored without it, the pairs are told from its findings.
std::uint64_t pairs_of(const Bucket& b) {
  return b.pairs > 0 || b.methods.empty() ? b.pairs : b.count / b.methods.size();
}

Sight sight_of(const TriagedRun& run, const Bucket& of) {
  const Bucket* const found = find(run, of);
  const std::uint64_t pairs = found != nullptr ? pairs_of(*found) : 0;
  const double looked_at = run.part * static_cast<double>(asked_in(run, of));
  return {pairs, std::max(pairs, static_cast<std::uint64_t>(looked_at))};
}

std::string version_in(const TriagedRun& run, const std::string& method) {
  for (const MethodRecord& m : run.methods)
    if (m.name == method) return m.version;
  return {};
}

void compare(Bucket& b, const TriagedRun& run, const std::vector<TriagedRun>& earlier, std::size_t compared) {
  b.first_seen = b.last_seen = run.id;
  b.first_version = b.last_version = version_in(run, b.method);
  std::vector<Sight> sights;
  for (const TriagedRun& past : earlier) {
    sights.push_back(sight_of(past, b));
    if (sights.back().asked > 0) b.nights.push_back({past.id, past.started, sights.back()});
    const Bucket* const found = find(past, b);
    if (found == nullptr || b.first_seen != run.id) continue;
    b.first_seen = found->first_seen;
    b.first_version = found->first_version.empty() ? version_in(past, b.method) : found->first_version;
  }
  const Sight here = sight_of(run, b);
  b.nights.push_back({run.id, run.started, here});
  if (b.nights.size() > nights_cap) b.nights.erase(b.nights.begin(), b.nights.end() - nights_cap);
  if (earlier.empty()) return;
  const Standing standing = standing_of(here, sights, compared);
  b.status = standing.status;
  b.chance = standing.chance;
}

/// What has become of a bucket of the last run that this one does not have; nothing where nobody was asked.
std::optional<Bucket> missed(Bucket b, const TriagedRun& run, const std::vector<TriagedRun>& earlier,
                             std::size_t compared, const FailsToday& fails_today) {
  const bool asked = std::any_of(b.methods.begin(), b.methods.end(), [&](const std::string& name) {
    return std::any_of(run.methods.begin(), run.methods.end(),
                       [&](const MethodRecord& m) { return m.name == name; });
  });
  if (b.status == Recurrence::gone || !asked) return {};
  const std::string last_seen = b.last_seen, last_version = b.last_version, first_seen = b.first_seen;
  b.count = b.pairs = 0;
  b.findings.clear();
  b.nights.clear();
  compare(b, run, earlier, compared);
  b.first_seen = first_seen;
  b.last_seen = last_seen;
  b.last_version = last_version.empty() ? version_in(earlier.back(), b.method) : last_version;
  const std::optional<bool> fails = fails_today(b);
  if (fails)
    b.status = *fails ? Recurrence::known : Recurrence::gone;
  else if (!b.status)
    b.status = Recurrence::rare;
  return b;
}

int place_of(const Bucket& b) {
  if (b.status == Recurrence::fresh) return 0;
  if (b.status == Recurrence::back) return 1;
  return b.status == Recurrence::gone ? 3 : 2;
}

}  // namespace

void compare_with_earlier(TriagedRun& run, const std::vector<TriagedRun>& earlier,
                          const FailsToday& fails_today) {
  std::vector<const Bucket*> absent;
  if (!earlier.empty())
    for (const Bucket& b : earlier.back().buckets)
      if (find(run, b) == nullptr) absent.push_back(&b);
  const std::size_t compared = run.buckets.size() + absent.size();
  std::vector<Bucket> not_met;
  for (const Bucket* b : absent)
    if (auto now = missed(*b, run, earlier, compared, fails_today)) not_met.push_back(std::move(*now));
  for (Bucket& b : run.buckets) compare(b, run, earlier, compared);
  for (Bucket& b : not_met) run.buckets.push_back(std::move(b));
  std::stable_sort(run.buckets.begin(), run.buckets.end(),
                   [](const Bucket& x, const Bucket& y) { return place_of(x) < place_of(y); });
}

std::string what_changed(const std::vector<Bucket>& buckets) {
  const auto is_compared = [](const Bucket& b) { return b.status.has_value(); };
  if (std::none_of(buckets.begin(), buckets.end(), is_compared))
    return fmt::format("{} cause{}", buckets.size(), buckets.size() == 1 ? "" : "s");
  std::string text;
  for (const Recurrence status :
       {Recurrence::fresh, Recurrence::back, Recurrence::known, Recurrence::gone, Recurrence::rare}) {
    const auto n =
        std::count_if(buckets.begin(), buckets.end(), [&](const Bucket& b) { return b.status == status; });
    if (n == 0 && status != Recurrence::fresh) continue;
    text += fmt::format("{}{} {}{}", text.empty() ? "" : ", ", n, to_string(status),
                        !text.empty() ? ""
                        : n == 1      ? " cause"
                                      : " causes");
  }
  return text;
}

void suppress(std::vector<Bucket>& buckets, const std::vector<Suppression>& suppressions,
              std::string_view today) {
  for (Bucket& b : buckets) {
    const Suppression* s = find_suppression(suppressions, b.key, today);
    for (const std::string& former : b.former_keys)
      if (s == nullptr) s = find_suppression(suppressions, former, today);
    b.suppressed = s != nullptr ? std::optional(*s) : std::nullopt;
  }
}

std::vector<std::string> former_keys_in(const std::vector<Suppression>& suppressions,
                                        const std::vector<Bucket>& buckets) {
  std::vector<std::string> remarks;
  for (const Suppression& s : suppressions) {
    std::string lines;
    for (const Bucket& b : buckets) {
      if (!b.former_keys.contains(s.bucket)) continue;
      Suppression now = s;
      now.bucket = b.key;
      lines += '\n' + line_of(now);
    }
    if (!lines.empty())
      remarks.push_back(fmt::format("the suppression of {} (line {}) is by a key of 0.1.0; write instead{}",
                                    s.bucket, s.line, lines));
  }
  return remarks;
}

}  // namespace cyl
