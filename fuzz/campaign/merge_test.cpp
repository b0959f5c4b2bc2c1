// SPDX-License-Identifier: MIT
#include "fuzz/campaign/merge.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "base/from_environment_test.hpp"
#include "fuzz/campaign/campaign_test.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;

/// All of a run that must not depend on times, in an order that does not depend on appearance.
std::string sorted_content(const RunStore& store) {
  std::istringstream in(content(store));
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  std::sort(lines.begin(), lines.end());
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  return text;
}

class Shards : public Campaign {
 protected:
  std::string name_of(std::uint64_t shard) const { return "shard-" + std::to_string(shard); }
  CampaignOptions shard_options(std::uint64_t shard, std::uint64_t shards, std::uint64_t pairs) const {
    CampaignOptions o = options(name_of(shard), pairs);
    o.shard = shard;
    o.shards = shards;
    return o;
  }
  std::vector<std::string> folders(std::uint64_t shards) const {
    std::vector<std::string> all;
    for (std::uint64_t i = 0; i < shards; ++i) all.push_back(folder / name_of(i));
    return all;
  }
  std::vector<std::int64_t> ids(const std::string& name) const {
    std::vector<std::int64_t> all;
    for (const FindingRecord& f : store(name).findings()) all.push_back(static_cast<std::int64_t>(f.index));
    return all;
  }
};

TEST_F(Shards, TogetherAreWhatOneRunIs) {
  const std::uint64_t pairs = 7 * batch_size + 100;
  run_campaign(options("whole", pairs), workload());
  for (const std::uint64_t n : {1u, 2u, 3u, 7u}) {
    for (std::uint64_t i = 0; i < n; ++i) {
      const CampaignSummary summary = run_campaign(shard_options(i, n, pairs), workload());
      EXPECT_EQ(summary.progress.done, summary.progress.goal);
      EXPECT_EQ(total(store(name_of(i)), referee_row).asked, summary.progress.goal);
    }
    std::vector<std::string> runs = folders(n);
    std::reverse(runs.begin(), runs.end());
    const MergeSummary summary = merge_runs(runs, folder / "merged");
    EXPECT_TRUE(summary.incomplete.empty()) << summary.incomplete.front();
    EXPECT_EQ(summary.whole_below, pairs);
    EXPECT_EQ(summary.progress.done, pairs);
    EXPECT_EQ(exit_code(summary), 2);
    EXPECT_EQ(ids("merged"), ids("whole"));
    EXPECT_EQ(sorted_content(store("merged")), sorted_content(store("whole"))) << n;
    for (const std::string& run : runs) fs::remove_all(run);
  }
}

TEST_F(Shards, KilledAtAnyMomentAndResumedTheyAreStillOneRun) {
  const std::uint64_t batches = from_environment("DAYLIGHT_KILLED_BATCHES", 20), most = batches / 12;
  const std::uint64_t pairs = batches * batch_size + 7;
  run_campaign(options("whole", pairs), workload());
  for (std::uint64_t i = 0; i < 3; ++i) {
    CampaignOptions o = shard_options(i, 3, pairs);
    const int kills = kill_until_done(100 * i, most, [&](const auto& on_progress) {
      o.resume = holds_run(o.out);
      run_campaign(o, workload(), on_progress);
    });
    EXPECT_GE(kills, 3) << "of a third of the batches";
  }
  EXPECT_TRUE(merge_runs(folders(3), folder / "merged").incomplete.empty());
  EXPECT_EQ(sorted_content(store("merged")), sorted_content(store("whole")));
}

TEST_F(Shards, WhatIsMissingIsSaid) {
  const std::uint64_t pairs = 6 * batch_size;
  run_campaign(shard_options(0, 3, pairs), workload());
  CampaignOptions planned = shard_options(2, 3, pairs);
  planned.create_only = true;
  run_campaign(planned, workload());
  const MergeSummary summary = merge_runs({folders(3)[0], folders(3)[2]}, folder / "merged");
  ASSERT_EQ(summary.incomplete.size(), 2u);
  EXPECT_EQ(summary.incomplete[0], "shard 1 of 3 is missing");
  EXPECT_EQ(summary.incomplete[1], "shard 2 of 3 (" + folders(3)[2] + ") is planned at index 0");
  EXPECT_EQ(summary.whole_below, batch_size);
  EXPECT_EQ(total(store("merged"), referee_row).asked, 2 * batch_size);
  EXPECT_TRUE(value_of(store("merged").config(), "status").starts_with("incomplete"));
  MergeSummary without_findings = summary;
  without_findings.progress.contract = without_findings.progress.failed = 0;
  EXPECT_EQ(exit_code(without_findings), 3);
  without_findings.harness_failed = true;
  EXPECT_EQ(exit_code(without_findings), 1);
  // Gone on with, and merged again over it, it is whole.
  planned.create_only = false;
  planned.resume = true;
  run_campaign(planned, workload());
  run_campaign(shard_options(1, 3, pairs), workload());
  EXPECT_TRUE(merge_runs(folders(3), folder / "merged").incomplete.empty());
  EXPECT_EQ(total(store("merged"), referee_row).asked, pairs);
}

TEST_F(Shards, ThatDoNotBelongTogetherAreRefused) {
  run_campaign(shard_options(0, 2, 100), workload());
  const std::string first = folders(1)[0], out = folder / "out";
  const auto refuses = [&](const CampaignOptions& other, const Workload& about) {
    run_campaign(other, about);
    EXPECT_THROW(merge_runs({first, other.out}, out), std::invalid_argument);
    fs::remove_all(other.out);
  };
  CampaignOptions o = shard_options(1, 2, 100);
  o.seed = 1;
  refuses(o, workload());
  refuses(shard_options(1, 3, 100), workload());
  o = shard_options(1, 2, 100);
  o.build = "another";
  refuses(o, workload());
  cases.resize(1);
  refuses(shard_options(1, 2, 100), workload());
  cases.clear();
  methods.pop_back();
  refuses(shard_options(1, 2, 100), workload());
  EXPECT_THROW(merge_runs({first, first}, out), std::invalid_argument);
  EXPECT_THROW(merge_runs({first}, first), std::invalid_argument);
  merge_runs({first}, out);
  EXPECT_THROW(merge_runs({out}, folder / "twice"), std::invalid_argument);
  CampaignOptions on = options("out", 200);
  on.resume = true;
  methods = make_methods();
  EXPECT_THROW(run_campaign(on, workload()), std::runtime_error);
}

}  // namespace
}  // namespace cyl
