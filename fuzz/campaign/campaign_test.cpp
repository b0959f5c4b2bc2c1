// SPDX-License-Identifier: MIT
#include "fuzz/campaign/campaign.hpp"

#include <gtest/gtest.h>

#include <map>

#include "base/from_environment_test.hpp"
#include "base/json.hpp"
#include "base/usage_error.hpp"
#include "corpus/store/stored_answers.hpp"
#include "fuzz/campaign/campaign_test.hpp"

namespace cyl {
namespace {

TEST_F(Campaign, CountsWhatEveryMethodDid) {
  const std::uint64_t pairs = 5 * batch_size;
  const CampaignSummary summary = run_campaign(options("run", pairs), workload());
  EXPECT_EQ(summary.harness_failure, "");
  EXPECT_EQ(summary.progress.done, pairs);
  EXPECT_EQ(exit_code(summary), 2);

  std::uint64_t meet = 0, far = 0, near = 0, within_claim = 0;
  for (std::uint64_t i = 0; i < pairs; ++i) {
    const Pair pair = two_families[i % 2].generate(20261121, i / 2);
    const double gap = pair.b.center.x() - 2;
    meet += gap < 0;
    far += gap > 0.49;
    near += gap <= 0.1;
    within_claim += gap < 0 && -gap < 8e-6;
  }
  const RunStore run = store("run");
  EXPECT_EQ(total(run, "good").asked, pairs);
  EXPECT_EQ(total(run, "good").contract + total(run, "good").resolution, 0u);
  EXPECT_EQ(total(run, "blind").contract, meet - within_claim);
  EXPECT_EQ(total(run, "blind").resolution, within_claim);
  EXPECT_EQ(total(run, "crashing").failed, far);
  EXPECT_EQ(total(run, "choosy").declined, pairs - near);
  EXPECT_EQ(total(run, referee_row).asked, pairs);
  EXPECT_GT(total(run, "blind").nanoseconds, 0u);
  EXPECT_GT(far * within_claim * meet, 0u);
}

TEST_F(Campaign, AFindingHoldsAllThatIsNeededToSeeItAgain) {
  run_campaign(options("run", 500), workload());
  for (const FindingRecord& f : store("run").findings()) {
    const CaseLine line = parse_case(f.pair, 1);
    ASSERT_TRUE(line.value) << line.error;
    const Pair pair = two_families[f.index % 2].generate(20261121, f.index / 2);
    EXPECT_EQ(format_pair(line.value->pair), format_pair(pair));
    EXPECT_EQ(f.family, two_families[f.index % 2].name);
    std::map<std::string, nlohmann::json> answers;
    for_each_answer(parse_json(f.answers), [&](const auto& answer, const auto& its_methods) {
      for (const std::string& method : its_methods) answers[method] = answer;
    });
    ASSERT_EQ(answers.size(), methods.size());
    EXPECT_EQ(answers["good"]["verdict"], to_string(right(pair)));
    EXPECT_EQ(parse_json(f.truth)["verdict"], to_string(right(pair)));
    if (f.method == "blind") {
      EXPECT_EQ(f.kind, FindingKind::wrong_disjoint);
      EXPECT_LE(f.margin->lo, (2 - pair.b.center.x()) / 8);
      EXPECT_GE(f.margin->hi, (2 - pair.b.center.x()) / 8);
    } else {
      EXPECT_EQ(f.method, "crashing");
      EXPECT_EQ(f.kind, FindingKind::crash);
      EXPECT_NE(f.reason.find("ABRT"), std::string::npos) << f.reason;
    }
  }
}

TEST_F(Campaign, SameSeedSameFindingsWhateverTheJobs) {
  CampaignOptions one = options("one", 3 * batch_size), three = options("three", 3 * batch_size);
  one.jobs = 1;
  three.jobs = 3;
  run_campaign(one, workload());
  run_campaign(three, workload());
  EXPECT_EQ(content(store("one")), content(store("three")));
  CampaignOptions other = options("other", 3 * batch_size);
  other.seed = 1;
  run_campaign(other, workload());
  EXPECT_NE(content(store("one")), content(store("other")));
}

TEST_F(Campaign, AShorterRunIsAPrefixOfALonger) {
  const std::uint64_t shorter = batch_size + 300;
  run_campaign(options("short", shorter), workload());
  run_campaign(options("long", 2 * batch_size), workload());
  EXPECT_NE(content(store("short"), shorter), "");
  EXPECT_EQ(content(store("short"), shorter), content(store("long"), shorter));
  // Gone on with, the shorter one becomes the longer one, though its batches are cut elsewhere.
  CampaignOptions on = options("short", 2 * batch_size);
  on.resume = true;
  run_campaign(on, workload());
  EXPECT_EQ(content(store("short")), content(store("long")));
}

TEST_F(Campaign, KilledAtAnyMomentAndResumedIsAsIfNothingHappened) {
  const std::uint64_t batches = from_environment("DAYLIGHT_KILLED_BATCHES", 20), most = batches / 10;
  const std::uint64_t pairs = batches * batch_size;
  run_campaign(options("whole", pairs), workload());
  CampaignOptions o = options("killed", pairs);
  const int kills = kill_until_done(1, most, [&](const auto& on_progress) {
    o.resume = holds_run(o.out);
    run_campaign(o, workload(), on_progress);
  });
  EXPECT_GE(kills, static_cast<int>(batches / (most + 1)));
  EXPECT_EQ(store("killed").progress().next, pairs);
  EXPECT_EQ(content(store("killed")), content(store("whole")));
}

TEST_F(Campaign, ItsStoreSaysHowItEnded) {
  const auto status = [&] { return value_of(store("run").config(), "status"); };
  CampaignOptions o = options("run", 200);
  o.create_only = true;
  run_campaign(o, workload());
  EXPECT_EQ(status(), status_planned);
  o.create_only = false;
  o.resume = true;
  run_campaign(o, workload());
  EXPECT_EQ(status(), status_complete);
  o.pairs = 0;
  o.budget = std::chrono::hours(1);
  const auto goes_on = [&](const auto& on_progress) {
    run_campaign(o, workload(), on_progress);
    return 0;
  };
  EXPECT_TRUE(WIFSIGNALED(end_on_its_way(goes_on, SIGKILL)));
  EXPECT_EQ(status(), status_running);
}

TEST_F(Campaign, ASignalStopsItAndKeepsWhatIsComplete) {
  CampaignOptions o = options("run", 0);
  o.budget = std::chrono::hours(1);
  const auto begins = [&](const auto& on_progress) {
    const CampaignSummary summary = run_campaign(o, workload(), on_progress);
    return summary.interrupted && summary.harness_failure.empty() ? 42 : 1;
  };
  const int status = end_on_its_way(begins, SIGINT);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 42);
  EXPECT_GT(store("run").progress().next, 0u);
  EXPECT_EQ(total(store("run"), "good").asked, store("run").progress().next);
}

TEST_F(Campaign, RefusesToResumeWhatDiffers) {
  run_campaign(options("run", 100), workload());
  CampaignOptions o = options("run", 200);
  o.resume = true;
  o.seed = 5;
  EXPECT_THROW(run_campaign(o, workload()), std::runtime_error);
  o.seed = 20261121;
  methods.pop_back();
  EXPECT_THROW(run_campaign(o, workload()), std::runtime_error);
  methods = make_methods();
  cases.resize(1);
  EXPECT_THROW(run_campaign(o, workload()), std::runtime_error);
  cases.clear();
  EXPECT_EQ(run_campaign(o, workload()).progress.done, 200u);
  o.resume = false;
  EXPECT_THROW(run_campaign(o, workload()), UsageError);
}

TEST_F(Campaign, CasesComeFirstAndTheirStatedTruthIsHeldToTheProof) {
  for (const double gap : {0.25, -0.25}) {
    Case c;
    c.pair = beside(gap);
    c.id = gap > 0 ? "apart" : "meet";
    c.truth = Verdict::disjoint;  // a lie of the second
    cases.push_back(c);
  }
  run_campaign(options("run", 10), workload());
  const RunStore run = store("run");
  EXPECT_EQ(total(run, corpus_row).asked, 2u);
  EXPECT_EQ(total(run, corpus_row).contract, 1u);
  bool found = false;
  for (const FindingRecord& f : run.findings()) {
    if (f.method != corpus_row) continue;
    found = true;
    EXPECT_EQ(f.index, 1u);
    EXPECT_EQ(f.family, cases_family);
    EXPECT_EQ(parse_case(f.pair, 1).value->id, "meet");
  }
  EXPECT_TRUE(found);
  EXPECT_EQ(total(run, "good").asked, 10u);
}

/// Sums over a plane.
std::vector<CellCounts> on_plane(const RunStore& store, const std::string& plane) {
  CellTable table;
  for (const CellRecord& c : store.cells())
    if (c.plane == plane) table.add({plane, 0, 0, c.methods});
  return table.records().empty() ? std::vector<CellCounts>{} : table.records()[0].methods;
}

TEST_F(Campaign, EveryPairIsInOneCellOfEachPlane) {
  const std::uint64_t pairs = 2 * batch_size;
  run_campaign(options("run", pairs), workload());
  const RunStore run = store("run");
  std::uint64_t meet = 0, in_cell = 0;
  for (std::uint64_t i = 0; i < pairs; ++i) {
    const double gap = two_families[i % 2].generate(20261121, i / 2).b.center.x() - 2;
    meet += gap < 0;
    in_cell += gap < 0 && -gap / 8 <= 1e-2 && -gap / 8 > 1e-3;
  }
  for (const char* plane : {"angle-margin", "aspect-margin", "scale-offset", "margin-shapes"}) {
    const std::vector<CellCounts> sums = on_plane(run, plane);
    ASSERT_EQ(sums.size(), methods.size()) << plane;
    EXPECT_EQ(sums[0], (CellCounts{.asked = pairs})) << plane;
    EXPECT_EQ(
        sums[1],
        (CellCounts{.asked = pairs, .wrong_disjoint = meet, .within_disjoint = sums[1].within_disjoint}))
        << plane;
    EXPECT_EQ(sums[2].failed, total(run, "crashing").failed) << plane;
    EXPECT_EQ(sums[3].declined, total(run, "choosy").declined) << plane;
  }
  for (const CellRecord& c : run.cells()) {  // parallel axes
    if (c.plane != "angle-margin" || c.x != 0 || c.y != 2) continue;
    EXPECT_EQ(c.methods[1].wrong_disjoint, in_cell);
  }
  EXPECT_GT(in_cell, 0u);
}

TEST_F(Campaign, CostlyMethodsAreInCellsOnTheirShareAndOursAloneOnAShareOfPairs) {
  methods.clear();
  methods.push_back(fake(
      "blind", [](const Pair&) { return answered(Verdict::disjoint); }, true));
  methods.push_back(fake(
      "costly", [](const Pair& p) { return answered(right(p)); }, true, 100));
  run_campaign(options("run", 1000), workload());
  EXPECT_GT(total(store("run"), "costly").asked, 100u);  // in disputes
  std::uint64_t drawn = 0;
  for (std::uint64_t i = 0; i < 1000; ++i) drawn += on_share(100, options("run", 1000).seed, i);
  EXPECT_EQ(on_plane(store("run"), "angle-margin").at(1).asked, drawn);

  methods.clear();
  methods.push_back(fake(
      "good", [](const Pair& p) { return answered(right(p)); }, false));
  const std::uint64_t pairs = 200 * own_cell_share;
  run_campaign(options("own", pairs), workload());
  const std::uint64_t asked = on_plane(store("own"), "angle-margin").at(0).asked;
  EXPECT_GT(asked, 150u);
  EXPECT_LT(asked, 250u);
}

TEST_F(Campaign, ABatchThatDiesIsAHarnessFailureThatNamesThePair) {
  methods.clear();
  methods.push_back(fake(
      "deadly",
      [](const Pair& p) -> MethodAnswer {
        if (p.b.center.x() == 9) std::abort();
        return answered(right(p));
      },
      false));
  const Family deadly[] = {
      {"deadly", "", [](std::uint64_t, std::uint64_t i) { return beside(i == own_batch_size + 5 ? 7 : 1); }}};
  CampaignOptions o = options("run", 3 * own_batch_size);
  const CampaignSummary summary = run_campaign(o, {methods, deadly, {}});
  EXPECT_EQ(exit_code(summary), 1);
  EXPECT_NE(summary.harness_failure.find(std::to_string(own_batch_size) + " to " +
                                         std::to_string(2 * own_batch_size - 1)),
            std::string::npos)
      << summary.harness_failure;
  EXPECT_NE(summary.harness_failure.find("signal 6"), std::string::npos) << summary.harness_failure;
  EXPECT_NE(summary.harness_failure.find("its index " + std::to_string(own_batch_size + 5) +
                                         " alone dies (killed by signal 6 (Aborted)): pair " +
                                         std::to_string(own_batch_size + 5) + " of deadly"),
            std::string::npos)
      << summary.harness_failure;
  EXPECT_TRUE(value_of(store("run").config(), "status").starts_with(status_failed));
  EXPECT_EQ(store("run").progress().next, own_batch_size);
}

TEST(ExitCode, StoppedBeforeItsLimitDecidesNothingButKeepsItsFindings) {
  CampaignSummary summary;
  summary.interrupted = true;
  EXPECT_EQ(exit_code(summary), 3);
  summary.progress.contract = 1;
  EXPECT_EQ(exit_code(summary), 2);
}

TEST(ExitCode, FailureThenFindingsThenUndecided) {
  CampaignSummary summary;
  EXPECT_EQ(exit_code(summary), 0);
  summary.progress.resolution = 5;
  EXPECT_EQ(exit_code(summary), 0);
  summary.progress.unresolved = 1;
  EXPECT_EQ(exit_code(summary), 3);
  summary.progress.failed = 1;
  EXPECT_EQ(exit_code(summary), 2);
  summary.harness_failure = "x";
  EXPECT_EQ(exit_code(summary), 1);
}

}  // namespace
}  // namespace cyl
