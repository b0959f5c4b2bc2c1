// SPDX-License-Identifier: MIT
#include "fuzz/campaign/self_check.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "fuzz/campaign/campaign.hpp"
#include "fuzz/campaign/killed_test.hpp"
#include "fuzz/campaign/merge.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t seed = 20261121;

/// Calls upright cylinders of radius 1 side by side apart from some distance of their axes on; right is 2.
class Apart : public Method {
 public:
  explicit Apart(double from) : from_(from) {}
  std::string_view name() const override { return "apart"; }
  std::string_view version() const override { return "1"; }
  Claim claim() const override { return {1e-6, 0, "its word"}; }
  bool foreign() const override { return false; }
  MethodAnswer ask(const Pair& pair) override {
    MethodAnswer answer;
    answer.status = Status::answered;
    answer.verdict = pair.b.center.x() < from_ ? Verdict::intersecting : Verdict::disjoint;
    return answer;
  }

 private:
  double from_;
};
constexpr double right = 2, wrong_about_one = 0.5;

/// All apart, but for the one.
constexpr std::uint64_t the_one = 700;
Pair draw(std::uint64_t, std::uint64_t index) {
  return {{{0, 0, 0}, {0, 0, 1}, 1, 3}, {{index == the_one ? 1.0 : 3.0, 0, 0}, {0, 0, 1}, 1, 3}};
}
const Family only_family[] = {{"row", "all alike but one", draw}};

TEST(Moments, LieInOctavesAndAreDrawnFromTheSeed) {
  std::set<std::uint64_t> drawn;
  for (std::uint64_t s = 0; s < 20; ++s) {
    for (unsigned k = 0; k < 20; ++k) {
      const std::uint64_t moment = alarm_moment(s, k);
      EXPECT_GE(moment, batch_size << k);
      EXPECT_LT(moment, batch_size << (k + 1));
      drawn.insert(moment);
    }
  }
  EXPECT_GT(drawn.size(), 390u);
}

TEST(Usual, IsLearnedFromWhatItEverTook) {
  EXPECT_EQ(usual_pairs({}, 21), alarm_pairs_cap);
  EXPECT_EQ(usual_pairs({1, 100}, 21), alarm_pairs_cap) << "one night tells next to nothing";
  EXPECT_EQ(usual_pairs({2, 100}, 21), 14000u);
  EXPECT_EQ(usual_pairs({5, 100}, 21), 1400u);
  EXPECT_EQ(usual_pairs({10, 100}, 21), 700u);
  EXPECT_EQ(usual_pairs({10, 2}, 21), 7u * 21) << "the luck of the start";
  EXPECT_EQ(usual_pairs({100000, 100}, 21), 100u) << "what it took so often it does not exceed";
  EXPECT_EQ(usual_pairs({2, 100000}, 21), alarm_pairs_cap);
}

TEST(KnownFaults, AreThoseThatCampaignsFindWithTheMethodsAsked) {
  const std::string file = DAYLIGHT_SOURCE_DIR "/props/mutants/kill_matrix.jsonl";
  const auto own = own_methods();
  const std::vector<KnownFault> faults = known_faults(file, own);
  // Too few, and a night's faults could be guessed: measure the column again, daylight mutants matrix
  // --detectors fuzz.
  EXPECT_GE(faults.size(), 40u);
  EXPECT_TRUE(known_faults(file, std::span(own).first(1)).empty());
  EXPECT_GE(known_faults(file, all_methods()).size(), faults.size());
  EXPECT_THROW(known_faults("/nowhere", own), std::runtime_error);
}

TEST(RunUntilFound, EndsWithTheFirstFindingBeyondAClaim) {
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(std::make_unique<Apart>(wrong_about_one));
  const BatchRecord found = run_until_found({methods, only_family, {}}, seed, 100, 2000);
  ASSERT_EQ(found.findings.size(), 1u);
  EXPECT_EQ(found.findings[0].index, the_one);
  EXPECT_TRUE(run_until_found({methods, only_family, {}}, seed, 100, 600).findings.empty());
  EXPECT_TRUE(run_until_found({methods, only_family, {}}, seed, the_one + 1, 2000).findings.empty());
}

class Night : public testing::Test {
 protected:
  void SetUp() override {
    folder = fs::temp_directory_path() / ("daylight_alarm_" + std::to_string(getpid()) + "_" +
                                          testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder);
    fs::create_directories(folder);
    methods.push_back(std::make_unique<Apart>(wrong_about_one));
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
    worker(
        "printf "
        "'[[],[],[[%s,\"row\",0,\"decide\",\"wrong_disjoint\",\"contract\",[],\"\",\"\",\"\",\"\",\"\"]],[]]'"
        " "
        "$(($7 + " +
        std::to_string(pairs - 1) + "))");
  }
  void finds_nothing() const { worker("echo '[[],[],[],[]]'"); }

  CampaignOptions options(const std::string& name, std::uint64_t pairs) const {
    CampaignOptions o;
    o.out = folder / name;
    o.seed = seed;
    o.pairs = pairs;
    o.alarm.program = folder / "worker";
    for (int number = 1; number <= 20; ++number) o.alarm.faults.push_back({number, "a fault", "decide"});
    return o;
  }
  CampaignSummary run(const CampaignOptions& o) const { return run_campaign(o, {methods, only_family, {}}); }
  CampaignSummary go_on(CampaignOptions o) const {
    o.resume = true;
    return run(o);
  }
  std::vector<AlarmRecord> alarms(const std::string& name) const {
    std::vector<AlarmRecord> all = RunStore::open(folder / name).alarms();
    for (AlarmRecord& a : all) a.milliseconds = 0;  // is of the machine
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
constexpr std::uint64_t short_night = 1 << 15;

TEST_F(Night, PlantsFaultsAtMomentsOfItsSeed) {
  const CampaignSummary summary = run(options("run", short_night));
  EXPECT_EQ(summary.harness_failure, "");
  EXPECT_EQ(exit_code(summary), 2) << "its own finding";
  const std::vector<AlarmRecord> all = alarms("run");
  ASSERT_EQ(all.size(), 6u);
  std::set<int> mutants;
  for (std::size_t k = 0; k < all.size(); ++k) {
    EXPECT_EQ(all[k].start, alarm_moment(seed, static_cast<unsigned>(k)));
    EXPECT_TRUE(all[k].found);
    EXPECT_EQ(all[k].pairs, 40u);
    EXPECT_EQ(all[k].usual, alarm_pairs_cap);
    mutants.insert(all[k].mutant);
  }
  EXPECT_EQ(mutants.size(), 6u) << "each once";
  EXPECT_EQ(format_alarms(all).find("alarm: 6 planted faults found"), 0u) << format_alarms(all);
  run(options("again", short_night));
  EXPECT_EQ(alarms("again"), all);
  CampaignOptions other = options("other", short_night);
  other.seed = 1;
  run(other);
  EXPECT_NE(alarms("other"), all);
}

TEST_F(Night, OneThatIsNotFoundIsRedThoughNothingElseIsFound) {
  methods.clear();
  methods.push_back(std::make_unique<Apart>(right));
  finds_nothing();
  EXPECT_EQ(exit_code(run(options("run", alarm_moment(seed, 0)))), 0) << "none yet";
  EXPECT_TRUE(alarms("run").empty());
  const CampaignSummary longer = go_on(options("run", alarm_moment(seed, 0) + 1));
  EXPECT_EQ(longer.progress.contract, 0u);
  ASSERT_EQ(alarms("run").size(), 1u);
  EXPECT_EQ(exit_code(longer), 1);
  EXPECT_NE(longer.harness_failure.find("(a fault), from index " + std::to_string(alarm_moment(seed, 0))),
            std::string::npos)
      << longer.harness_failure;
  EXPECT_NE(longer.harness_failure.find("not found in 131072 pairs"), std::string::npos)
      << longer.harness_failure;
  EXPECT_EQ(value_of(RunStore::open(folder / "run").config(), "status"),
            status_failed + longer.harness_failure);
  EXPECT_EQ(format_alarms(alarms("run")).find("ALARM: planted fault "), 0u);
  // What is stored stays red, and nothing is planted twice.
  const std::size_t before = planted();
  EXPECT_EQ(exit_code(go_on(options("run", alarm_moment(seed, 0) + 1))), 1);
  EXPECT_EQ(planted(), before);
}

TEST_F(Night, AWorkerThatDiesIsRed) {
  worker("kill -SEGV $$");
  const CampaignSummary summary = run(options("run", short_night));
  EXPECT_EQ(exit_code(summary), 1);
  EXPECT_NE(summary.harness_failure.find("its process ended: killed by signal 11"), std::string::npos)
      << summary.harness_failure;
  CampaignOptions none = options("none", short_night);
  none.alarm.program = folder / "nowhere";
  EXPECT_EQ(exit_code(run(none)), 1);
}

TEST_F(Night, WhatItFindsIsTheSameWithAlarmsAndWithout) {
  finds_after(1);
  CampaignOptions without = options("without", short_night);
  without.alarm = {};
  EXPECT_EQ(exit_code(run(without)), exit_code(run(options("with", short_night))));
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
  EXPECT_TRUE(none.alarms().empty());
}

TEST_F(Night, LearnsFromEarlierNightsAndIsRedBeyondThem) {
  CampaignOptions o = options("0", short_night);
  o.alarm.faults.resize(1);
  for (const char* name : {"0", "1", "2", "3", "4"}) {
    o.out = folder / name;
    EXPECT_EQ(exit_code(run(o)), 2);
  }
  EXPECT_EQ(alarms("0").at(0).usual, alarm_pairs_cap);
  EXPECT_EQ(alarms("2").at(0).usual, 140u * 40);
  o.out = folder / "5";
  EXPECT_EQ(exit_code(run(o)), 2);
  EXPECT_EQ(alarms("5").at(0).usual, 14u * 40);
  // Found, but later than it ever was by far: red, and known the next time.
  finds_after(600);
  o.out = folder / "late";
  const CampaignSummary late = run(o);
  EXPECT_EQ(exit_code(late), 1);
  EXPECT_NE(late.harness_failure.find("found after 600 pairs only; usual are 440 at most"), std::string::npos)
      << late.harness_failure;
  o.out = folder / "next";
  EXPECT_EQ(exit_code(run(o)), 2);
  // No longer found: red, and no night learns from that.
  finds_nothing();
  for (const char* name : {"lost", "lost again"}) {
    o.out = folder / name;
    EXPECT_EQ(exit_code(run(o)), 1) << name;
  }
  EXPECT_EQ(alarms("lost").at(0).usual, alarms("lost again").at(0).usual);
  // Other weights of the families are other pairs.
  const unsigned weights[] = {3};
  o.out = folder / "weighted";
  run_campaign(o, {methods, only_family, {}, weights});
  EXPECT_EQ(alarms("weighted").at(0).usual, alarm_pairs_cap);
}

TEST_F(Night, KilledAtAnyMomentAndResumedItHasTheSameAlarms) {
  fs::create_directories(folder / "a");
  fs::create_directories(folder / "b");  // not beside each other: neither learns
  const CampaignSummary whole = run(options("a/whole", 8 * own_batch_size));
  CampaignOptions o = options("b/killed", 8 * own_batch_size);
  const int kills = kill_until_done(1, 1, [&](const auto& on_progress) {
    o.resume = holds_run(o.out);
    run_campaign(o, {methods, only_family, {}}, on_progress);
  });
  EXPECT_GE(kills, 3) << "of 8 batches";
  EXPECT_EQ(alarms("b/killed"), alarms("a/whole"));
  EXPECT_EQ(alarms("a/whole").size(), 11u);
}

TEST_F(Night, AMergedRunHasTheAlarmsOfItsShards) {
  finds_nothing();
  for (std::uint64_t i = 0; i < 2; ++i) {
    CampaignOptions o = options("shard-" + std::to_string(i), 2 * own_batch_size);
    o.shard = i;
    o.shards = 2;
    if (i > 0) o.alarm = {};
    EXPECT_EQ(exit_code(run(o)), i == 0 ? 1 : 0) << "its own finding is in the first batch";
  }
  const MergeSummary summary = merge_runs({folder / "shard-0", folder / "shard-1"}, folder / "merged");
  EXPECT_EQ(exit_code(summary), 1);
  EXPECT_EQ(alarms("merged"), alarms("shard-0"));
  EXPECT_EQ(alarms("merged").size(), 8u);
}

}  // namespace
}  // namespace cyl
