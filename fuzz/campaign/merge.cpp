// SPDX-License-Identifier: MIT
#include "fuzz/campaign/merge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <map>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "base/usage_error.hpp"
#include "corpus/store/representatives.hpp"
#include "corpus/store/run_facts.hpp"
#include "corpus/store/run_store.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;

/// The settings that determine the findings, and the methods that made them.
constexpr const char* agreed[] = {"seed", "families", "case_count", "case_fingerprint", "build"};

struct Part {
  std::string folder;
  Config config;
  std::vector<MethodRecord> methods;
  Progress progress;
  Shard shard;
};

Part read_part(const std::string& folder) {
  const RunStore store = RunStore::open(folder);
  Part part{folder, store.config(), store.methods(), store.progress(), {}};
  if (part.config.contains("shards")) throw UsageError(folder + " is itself merged from shards");
  check_progress(store);
  part.shard = shard_of(part.config);
  return part;
}

void refuse(const Part& part, const Part& other, const std::string& what) {
  throw UsageError(fmt::format("{} and {} are not shards of one run: {}", part.folder, other.folder, what));
}

void check_agreement(const Part& a, const Part& b) {
  for (const char* key : agreed) {
    const std::string x = value_of(a.config, key), y = value_of(b.config, key);
    if (x != y) refuse(a, b, fmt::format("their {} differ, '{}' and '{}'", key, x, y));
  }
  if (a.methods != b.methods) refuse(a, b, "their methods, versions or claims differ");
  if (a.shard.count != b.shard.count || a.shard.batch != b.shard.batch)
    refuse(a, b, fmt::format("one is cut into {}, the other into {}", a.shard.count, b.shard.count));
  if (a.shard.index == b.shard.index) refuse(a, b, fmt::format("both are shard {}", a.shard.index));
}

/// The place of each name in a list; what is not in it comes after.
std::size_t place_in(const std::vector<std::string>& names, const std::string& name) {
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

std::vector<TallyRecord> in_order(std::map<std::pair<std::string, std::string>, Counts> counts,
                                  const Part& like) {
  std::vector<std::string> rows, columns{cases_family};
  for (const MethodRecord& m : like.methods) rows.push_back(m.name);
  for (const char* row : {corpus_row, referee_row}) rows.emplace_back(row);
  rows.insert(rows.end(), stage_rows.begin(), stage_rows.end());
  std::istringstream lines(value_of(like.config, "families"));
  for (std::string name; std::getline(lines, name);) columns.push_back(name);
  columns.emplace_back(fuzzed_family);
  std::vector<TallyRecord> all;
  for (const auto& [key, c] : counts) all.push_back({key.first, key.second, c});
  std::ranges::stable_sort(all, {}, [&](const TallyRecord& t) {
    return std::pair(place_in(rows, t.method), place_in(columns, t.family));
  });
  return all;
}

/// The shards as one batch, for the store to filter (why that is exact: corpus/store/run_store.cpp,
/// Representatives).
BatchRecord together(const std::vector<Part>& parts) {
  BatchRecord all;
  Representatives groups;
  std::map<std::pair<std::string, std::string>, Counts> counts;
  CellTable cells;
  for (const Part& part : parts) {
    const RunStore store = RunStore::open(part.folder);
    if (store.progress().next != part.progress.next)
      throw std::runtime_error(part.folder + " goes on while it is merged");
    all.next += part.shard.below(part.progress.next);
    for (const TallyRecord& t : store.tallies()) counts[{t.method, t.family}] += t.counts;
    for (const GroupRecord& g : store.groups()) groups.add(g);
    for (const CellRecord& c : store.cells()) cells.add(c);
    for (FindingRecord& f : store.findings()) all.findings.push_back(std::move(f));
  }
  // Findings of one index are of one shard: a stable sort leaves them in its order.
  std::ranges::stable_sort(all.findings, {}, &FindingRecord::index);
  all.groups = groups.groups();
  all.cells = cells.records();
  all.tallies = in_order(std::move(counts), parts.front());
  return all;
}

/// Returns the shards in their order. Throws UsageError if they do not belong together.
std::vector<Part> read_parts(const std::vector<std::string>& runs) {
  std::vector<Part> parts;
  for (const std::string& run : runs) {
    parts.push_back(read_part(run));
    for (std::size_t i = 0; i + 1 < parts.size(); ++i) check_agreement(parts[i], parts.back());
  }
  std::ranges::sort(parts, {}, [](const Part& part) { return part.shard.index; });
  return parts;
}

std::string why_incomplete(const Part& part) {
  const std::string status = value_of(part.config, "status");
  if (status == status_complete) return "";
  return fmt::format("shard {} of {} ({}) is {} at index {}", part.shard.index, part.shard.count, part.folder,
                     status == status_running ? "running or was killed" : status, part.progress.next);
}

}  // namespace

MergeSummary merge_runs(const std::vector<std::string>& runs, const std::string& out) {
  if (runs.empty()) throw UsageError("no run to merge");
  if (holds_run(out) && !RunStore::open(out).config().contains("shards"))
    throw UsageError(out + " already holds a run that was not merged");
  const std::vector<Part> parts = read_parts(runs);
  MergeSummary summary;
  summary.whole_below = std::numeric_limits<std::uint64_t>::max();
  Config config = parts.front().config;
  std::uint64_t milliseconds = 0;
  Shard shard = parts.front().shard;
  auto part = parts.begin();
  for (shard.index = 0; shard.index < shard.count; ++shard.index) {
    if (part == parts.end() || part->shard.index != shard.index) {
      summary.incomplete.push_back(fmt::format("shard {} of {} is missing", shard.index, shard.count));
      summary.whole_below = std::min(summary.whole_below, shard.first_from(0));
      continue;
    }
    if (const std::string why = why_incomplete(*part); !why.empty()) summary.incomplete.push_back(why);
    if (const std::string pairs = value_of(part->config, "pairs"); pairs != config["pairs"]) {
      summary.incomplete.push_back(fmt::format("shard {} was limited to {} pairs, shard {} to {}",
                                               shard.index, pairs, parts.front().shard.index,
                                               config["pairs"]));
    }
    summary.harness_failed |= value_of(part->config, "status").starts_with(status_failed);
    // A limit of pairs may have cut its last batch: then the next index is not above that of the others.
    summary.whole_below = std::min(summary.whole_below, shard.first_from(part->progress.next));
    milliseconds += part->progress.milliseconds;
    if (part != parts.begin()) config["fuzzing"] += value_of(part->config, "fuzzing");
    summary.fuzz_failed |= !value_of(part->config, fuzz_failed_key).empty();
    config["started"] = std::min(config["started"], value_of(part->config, "started"));
    ++part;
  }
  if (const std::uint64_t pairs = number_of(config, "pairs"); pairs != 0)
    summary.whole_below = std::min(summary.whole_below, pairs);
  for (const char* of_one : {"shard", "corpus_fingerprint", "fuzz_milliseconds"}) config.erase(of_one);
  if (summary.fuzz_failed) config[fuzz_failed_key] = "1";
  config["shards"] = fmt::format("{} of {}", parts.size(), shard.count);
  config["status"] = summary.incomplete.empty()
                         ? status_complete
                         : fmt::format("incomplete: {}", fmt::join(summary.incomplete, "; "));

  const std::string unfinished = out + ".merging";
  fs::remove_all(unfinished);
  const BatchRecord all = together(parts);
  {
    RunStore store = RunStore::create(unfinished, config, parts.front().methods);
    store.commit(all, milliseconds);
  }
  fs::create_directories(out);
  for (const char* old : {"/run.sqlite-wal", "/run.sqlite-shm"})
    fs::remove(out + old);  // of a reader that died
  fs::remove_all(out + "/corpus");
  for (const Part& each : parts)  // equal inputs have equal names
    if (fs::is_directory(each.folder + "/corpus"))
      fs::copy(each.folder + "/corpus", out + "/corpus",
               fs::copy_options::recursive | fs::copy_options::overwrite_existing);
  fs::rename(unfinished + "/run.sqlite", out + "/run.sqlite");
  fs::remove_all(unfinished);
  summary.progress.done = all.next;
  count(summary.progress, all.tallies);
  return summary;
}

int exit_code(const MergeSummary& summary) {
  CampaignSummary as_one;
  as_one.progress = summary.progress;
  as_one.interrupted = !summary.incomplete.empty();
  if (summary.harness_failed) as_one.harness_failure = "in a shard";
  as_one.fuzz_failed = summary.fuzz_failed;
  return exit_code(as_one);
}

}  // namespace cyl
