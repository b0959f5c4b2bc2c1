// SPDX-License-Identifier: MIT
#include "reports/run/history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <map>

#include "base/safe_text.hpp"
#include "corpus/store/run_facts.hpp"
#include "reports/run/run_data.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;

using MethodFamily = std::pair<std::string, std::string>;

/// The part of a run that the history needs.
struct Past {
  std::string began, folder;
  bool shard = false;  ///< a part of a run
  std::map<MethodFamily, std::uint64_t> asked;
  std::map<FindingGroup, std::uint64_t> found;
};

Past past_of(const std::string& folder, const Config& config, const std::vector<TallyRecord>& tallies,
             const std::vector<GroupRecord>& groups) {
  Past past{value_of(config, "started"), folder, shard_of(config).count > 1, {}, {}};
  for (const TallyRecord& t : tallies) past.asked[{t.method, t.family}] += t.counts.asked;
  for (const GroupRecord& g : groups) past.found[g] = g.count;
  return past;
}

bool before(const Past& x, const Past& y) {
  return std::pair(x.began, x.folder) < std::pair(y.began, y.folder);
}

Observation observation_of(const FindingGroup& key, const Past& run) {
  const auto asked = run.asked.find({key.method, key.family});
  if (asked == run.asked.end()) return {};
  const auto found = run.found.find(key);
  return {found == run.found.end() ? 0 : found->second, asked->second};
}

}  // namespace

std::size_t History::count(Recurrence status) const {
  return static_cast<std::size_t>(
      std::count_if(groups.begin(), groups.end(), [&](const auto& g) { return g.second == status; }));
}

History compare_with_earlier(const RunData& data) {
  const fs::path run = fs::canonical(data.folder);
  const Past here = past_of(run.string(), data.config, data.tallies, data.groups);
  History history;
  if (here.shard) return history;
  std::vector<Past> earlier;
  for (const std::string& folder : runs_in(run.parent_path().string())) {
    if (folder == run.string()) continue;
    try {
      const RunStore store = RunStore::open(folder);
      Past past = past_of(folder, store.config(), store.tallies(), store.groups());
      if (!past.shard && before(past, here)) earlier.push_back(std::move(past));
    } catch (const std::exception&) {
      ++history.unreadable;
    }
  }
  std::sort(earlier.begin(), earlier.end(), before);
  history.runs = earlier.size();

  std::map<FindingGroup, std::uint64_t> all = here.found;
  for (const Past& past : earlier) all.insert(past.found.begin(), past.found.end());
  for (const auto& [key, count] : all) {
    std::vector<Observation> before;
    for (const Past& past : earlier) before.push_back(observation_of(key, past));
    if (const RecurrenceOf now = recurrence_of(observation_of(key, here), before, all.size()); now.status)
      history.groups.emplace_back(key, *now.status);
  }
  return history;
}

std::string format_history(const History& history) {
  const auto number = [&](Recurrence status) {
    return fmt::format("{} {}", history.count(status), to_string(status));
  };
  std::string text = fmt::format(
      "compared with {} in the same folder, groups by method, kind and family: {}, {}, {}, {}, "
      "{}",
      counted(history.runs, "earlier run"), number(Recurrence::fresh), number(Recurrence::back),
      number(Recurrence::gone), number(Recurrence::known), number(Recurrence::rare));
  if (history.unreadable > 0)
    text += fmt::format("\n  skipped because they cannot be read: {}", counted(history.unreadable, "run"));
  return text;
}

}  // namespace cyl
