// SPDX-License-Identifier: MIT
#include "fuzz/campaign/self_check.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "corpus/store/batch_bytes.hpp"
#include "fuzz/campaign/campaign.hpp"
#include "fuzz/campaign/killed_test.hpp"
#include "fuzz/campaign/merge.hpp"
#include "oracles/methods/fake_method_test.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t seed = 20261121;

/// Calls upright cylinders of radius 1 side by side apart from some distance of their axes on; right is 2.
std::unique_ptr<Method> apart(double from) {
  const auto ask = [from](const Pair& pair) {
    return answered(pair.b.center.x() < from ? Verdict::intersecting : Verdict::disjoint);
  };
  return fake_method("apart", ask, {.claim = {1e-6, 0, "its word"}, .foreign = false});
}
constexpr double right = 2, wrong_about_one = 0.5;

/// All apart, but for the one.
constexpr std::uint64_t the_one = 700;
Pair draw(std::uint64_t, std::uint64_t index) {
  return {{{0, 0, 0}, {0, 0, 1}, 1, 3}, {{index == the_one ? 1.0 : 3.0, 0, 0}, {0, 0, 1}, 1, 3}};
}
const Family only_family[] = {{"row", "all alike but one", draw}};

TEST(SelfCheckStarts, LieInOctavesAndAreDrawnFromTheSeed) {
  std::set<std::uint64_t> drawn;
  for (std::uint64_t s = 0; s < 20; ++s) {
    for (unsigned k = 0; k < 20; ++k) {
      const std::uint64_t start = self_check_start(s, k);
      EXPECT_GE(start, self_check_octave << k);
      EXPECT_LT(start, self_check_octave << (k + 1));
      drawn.insert(start);
    }
  }
  EXPECT_GT(drawn.size(), 390u);
}

TEST(RunUntilFound, EndsWithTheFirstFindingBeyondAClaim) {
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(apart(wrong_about_one));
  const BatchRecord found = run_until_found({methods, only_family, {}}, seed, 100, 2000);
  ASSERT_EQ(found.findings.size(), 1u);
  EXPECT_EQ(found.findings[0].index, the_one);
  EXPECT_TRUE(run_until_found({methods, only_family, {}}, seed, 100, 600).findings.empty());
  EXPECT_TRUE(run_until_found({methods, only_family, {}}, seed, the_one + 1, 2000).findings.empty());
}

class SelfCheck : public testing::Test {
 protected:
  void SetUp() override {
    folder = fs::temp_directory_path() / ("daylight_self_check_" + std::to_string(getpid()) + "_" +
                                          testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder);
    fs::create_directories(folder);
    methods.push_back(apart(wrong_about_one));
    finds_after(40);
  }
  void TearDown() override { fs::remove_all(folder); }

  /// Stands for daylight-mutants: notes which mutant it was given, and does this.
  void worker(const std::string& script) const {
    const fs::path program = folder / "worker";
    std::ofstream(program) << "#!/bin/sh\necho \"$3\" >>" << (folder / "planted").string() << "\n" << script;
    fs::permissions(program, fs::perms::owner_all);
  }
  void finds_after(std::uint64_t pairs) const {
    BatchRecord batch;
    FindingRecord finding;
    finding.index = 0x12345678;  // four bytes, as every index here; the script puts in its own
    finding.family = "row";
    finding.method = "decide";
    finding.kind = FindingKind::wrong_disjoint;
    finding.severity = Severity::contract;
    batch.findings = {finding};
    const std::string bytes = format_batch(batch), index("\x12\x34\x56\x78", 4);
    const std::size_t at = bytes.find(index);
    std::ofstream(folder / "before", std::ios::binary) << bytes.substr(0, at);
    std::ofstream(folder / "behind", std::ios::binary) << bytes.substr(at + index.size());
    worker("cd '" + folder.string() + "'\ncat before\ni=$(($7 + " + std::to_string(pairs - 1) +
           "))\nfor shift in 24 16 8 0; do printf \"\\\\$(printf %03o $((i >> shift & 255)))\"; done\n"
           "cat behind\n");
  }
  void finds_nothing() const {
    std::ofstream(folder / "nothing", std::ios::binary) << format_batch({});
    worker("cat '" + (folder / "nothing").string() + "'\n");
  }

  CampaignOptions options(const std::string& name, std::uint64_t pairs) const {
    CampaignOptions o;
    o.out = folder / name;
    o.seed = seed;
    o.pairs = pairs;
    o.self_check.program = folder / "worker";
    for (int number = 1; number <= 20; ++number) o.self_check.faults.push_back({number, "a fault", "decide"});
    return o;
  }
  CampaignSummary run(const CampaignOptions& o) const { return run_campaign(o, {methods, only_family, {}}); }
  CampaignSummary go_on(CampaignOptions o) const {
    o.resume = true;
    return run(o);
  }
  std::vector<SelfCheckRecord> self_checks(const std::string& name) const {
    std::vector<SelfCheckRecord> all = RunStore::open(folder / name).self_checks();
    for (SelfCheckRecord& a : all) a.milliseconds = 0;  // is of the machine
    return all;
  }
  std::size_t planted() const {
    std::ifstream in(folder / "planted");
    std::size_t lines = 0;
    for (std::string line; std::getline(in, line);) ++lines;
    return lines;
  }

  fs::path folder;
  std::vector<std::unique_ptr<Method>> methods;
};

// Moments below 2^15 pairs are six.
constexpr std::uint64_t short_run = 1 << 15;

TEST_F(SelfCheck, PlantsFaultsAtMomentsOfItsSeed) {
  const CampaignSummary summary = run(options("run", short_run));
  EXPECT_EQ(summary.harness_failure, "");
  EXPECT_EQ(exit_code(summary), 2) << "its own finding";
  const std::vector<SelfCheckRecord> all = self_checks("run");
  ASSERT_EQ(all.size(), 6u);
  std::set<int> mutants;
  for (std::size_t k = 0; k < all.size(); ++k) {
    EXPECT_EQ(all[k].start, self_check_start(seed, static_cast<unsigned>(k)));
    EXPECT_TRUE(all[k].found);
    EXPECT_EQ(all[k].pairs, 40u);
    mutants.insert(all[k].mutant);
  }
  EXPECT_EQ(mutants.size(), 6u) << "each once";
  EXPECT_EQ(format_self_checks(all).find("self-check: 6 planted faults found"), 0u)
      << format_self_checks(all);
  run(options("again", short_run));
  EXPECT_EQ(self_checks("again"), all);
  CampaignOptions other = options("other", short_run);
  other.seed = 1;
  run(other);
  EXPECT_NE(self_checks("other"), all);
}

TEST_F(SelfCheck, OneThatIsNotFoundIsRedThoughNothingElseIsFound) {
  methods.clear();
  methods.push_back(apart(right));
  finds_nothing();
  EXPECT_EQ(exit_code(run(options("run", self_check_start(seed, 0)))), 0) << "none yet";
  EXPECT_TRUE(self_checks("run").empty());
  const CampaignSummary longer = go_on(options("run", self_check_start(seed, 0) + 1));
  EXPECT_EQ(longer.progress.contract, 0u);
  ASSERT_EQ(self_checks("run").size(), 1u);
  EXPECT_EQ(exit_code(longer), 1);
  EXPECT_NE(longer.harness_failure.find("(a fault) was not found from index " +
                                        std::to_string(self_check_start(seed, 0))),
            std::string::npos)
      << longer.harness_failure;
  EXPECT_NE(longer.harness_failure.find(" on in 131072 pairs"), std::string::npos) << longer.harness_failure;
  EXPECT_EQ(value_of(RunStore::open(folder / "run").config(), "status"),
            status_failed + longer.harness_failure);
  EXPECT_EQ(format_self_checks(self_checks("run")).find("SELF-CHECK FAILED: planted fault "), 0u);
  // The stored failure stays, and no fault is planted twice.
  const std::size_t before = planted();
  EXPECT_EQ(exit_code(go_on(options("run", self_check_start(seed, 0) + 1))), 1);
  EXPECT_EQ(planted(), before);
}

TEST_F(SelfCheck, AWorkerThatDiesIsRed) {
  worker("kill -SEGV $$");
  const CampaignSummary summary = run(options("run", short_run));
  EXPECT_EQ(exit_code(summary), 1);
  EXPECT_NE(summary.harness_failure.find("its process ended: killed by signal 11"), std::string::npos)
      << summary.harness_failure;
  CampaignOptions none = options("none", short_run);
  none.self_check.program = folder / "nowhere";
  EXPECT_EQ(exit_code(run(none)), 1);
}

TEST_F(SelfCheck, WhatItFindsIsTheSameWithSelfChecksAndWithout) {
  finds_after(1);
  CampaignOptions without = options("without", short_run);
  without.self_check = {};
  EXPECT_EQ(exit_code(run(without)), exit_code(run(options("with", short_run))));
  const RunStore with = RunStore::open(folder / "with"), none = RunStore::open(folder / "without");
  ASSERT_EQ(with.findings().size(), none.findings().size());
  for (std::size_t i = 0; i < with.findings().size(); ++i) {
    EXPECT_EQ(with.findings()[i].index, none.findings()[i].index);
    EXPECT_EQ(with.findings()[i].pair, none.findings()[i].pair);
  }
  ASSERT_EQ(with.tallies().size(), none.tallies().size());
  for (std::size_t i = 0; i < with.tallies().size(); ++i) {
    EXPECT_EQ(with.tallies()[i].counts.asked, none.tallies()[i].counts.asked);
    EXPECT_EQ(with.tallies()[i].counts.contract, none.tallies()[i].counts.contract);
  }
  EXPECT_TRUE(none.self_checks().empty());
}

TEST_F(SelfCheck, KilledAtAnyMomentAndResumedItHasTheSameSelfChecks) {
  const CampaignSummary whole = run(options("whole", 4 * own_batch_size));
  CampaignOptions o = options("killed", 4 * own_batch_size);
  const int kills = kill_until_done(1, 1, [&](const auto& on_progress) {
    o.resume = holds_run(o.out);
    run_campaign(o, {methods, only_family, {}}, on_progress);
  });
  EXPECT_GE(kills, 1) << "of 4 batches";
  EXPECT_EQ(self_checks("killed"), self_checks("whole"));
  EXPECT_EQ(self_checks("whole").size(), 10u);
}

TEST_F(SelfCheck, AMergedRunHasTheSelfChecksOfItsShards) {
  finds_nothing();
  for (std::uint64_t i = 0; i < 2; ++i) {
    CampaignOptions o = options("shard-" + std::to_string(i), 2 * own_batch_size);
    o.shard = i;
    o.shards = 2;
    if (i > 0) o.self_check = {};
    EXPECT_EQ(exit_code(run(o)), i == 0 ? 1 : 0) << "its own finding is in the first batch";
  }
  const MergeSummary summary = merge_runs({folder / "shard-0", folder / "shard-1"}, folder / "merged");
  EXPECT_EQ(exit_code(summary), 1);
  EXPECT_EQ(self_checks("merged"), self_checks("shard-0"));
  EXPECT_EQ(self_checks("merged").size(), 8u);
}

}  // namespace
}  // namespace cyl
