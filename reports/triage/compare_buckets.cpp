// SPDX-License-Identifier: MIT
#include <algorithm>

#include "reports/triage/buckets.hpp"

namespace cyl {
namespace {

/// The bucket of that key, if the run found it.
const Bucket* find(const std::vector<Bucket>& run, const std::string& key) {
  for (const Bucket& b : run)
    if (b.key == key && b.status != Recurrence::gone) return &b;
  return nullptr;
}

}  // namespace

void compare_with_earlier(std::vector<Bucket>& buckets, const std::string& id,
                          const std::vector<std::string>& asked,
                          const std::vector<std::vector<Bucket>>& earlier) {
  const auto found_before = [&](const std::string& key) {
    std::vector<bool> found;
    for (const auto& run : earlier) found.push_back(find(run, key) != nullptr);
    return found;
  };
  for (Bucket& b : buckets) {
    b.first_seen = b.last_seen = id;
    const std::vector<bool> found = found_before(b.key);
    if (!found.empty()) b.status = recurrence(true, true, found);
    const auto first = std::find(found.begin(), found.end(), true);
    if (first != found.end())
      b.first_seen = find(earlier[static_cast<std::size_t>(first - found.begin())], b.key)->first_seen;
  }
  if (earlier.empty()) return;
  for (Bucket b : earlier.back()) {
    if (b.status == Recurrence::gone || find(buckets, b.key) != nullptr) continue;
    const bool again = std::any_of(b.methods.begin(), b.methods.end(), [&](const std::string& name) {
      return std::find(asked.begin(), asked.end(), name) != asked.end();
    });
    b.status = recurrence(false, again, {true});
    if (!b.status) continue;
    b.count = 0;
    b.findings.clear();
    buckets.push_back(std::move(b));
  }
}

void suppress(std::vector<Bucket>& buckets, const std::vector<Suppression>& suppressions,
              std::string_view today) {
  for (Bucket& b : buckets) {
    const Suppression* s = find_suppression(suppressions, b.key, today);
    b.suppressed = s != nullptr ? std::optional(*s) : std::nullopt;
  }
}

}  // namespace cyl
