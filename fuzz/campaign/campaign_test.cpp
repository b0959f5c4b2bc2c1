// SPDX-License-Identifier: MIT
#include "fuzz/campaign/campaign.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <sstream>
#include <stdexcept>

#include "base/json.hpp"
#include "fuzz/campaign/killed_test.hpp"
#include "fuzz/campaign/merge.hpp"
#include "oracles/methods/contained.hpp"
#include "oracles/methods/fake_method_test.hpp"
#include "oracles/trial/compare.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;

/// A method made of a function, so that a test can make it wrong in any way.
std::unique_ptr<Method> fake(std::string name, FakeMethod::Ask ask, bool foreign = true, unsigned share = 1) {
  return fake_method(std::move(name), std::move(ask),
                     {.claim = {1e-6, 0, "a fake's word"}, .foreign = foreign, .share = share});
}

/// The families here hold upright cylinders of radius 1 and height 3, side by side along x.
Pair beside(double gap) { return {{{0, 0, 0}, {0, 0, 1}, 1, 3}, {{2 + gap, 0, 0}, {0, 0, 1}, 1, 3}}; }

Verdict right(const Pair& pair) { return pair.b.center.x() > 2 ? Verdict::disjoint : Verdict::intersecting; }

Pair wide(std::uint64_t seed, std::uint64_t index) {
  return beside(static_cast<double>(mix(seed * 77 + index) % 1000) / 1000 - 0.4995);
}
Pair narrow(std::uint64_t seed, std::uint64_t index) {
  const double gap = std::ldexp(1.0, -2 - static_cast<int>(mix(seed * 99 + index) % 40));
  return beside(index % 2 == 0 ? gap : -gap);
}

const Family two_families[] = {{"wide", "gaps up to half a radius", wide}, {"narrow", "small gaps", narrow}};

std::vector<std::unique_ptr<Method>> make_methods() {
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(fake(
      "good", [](const Pair& p) { return answered(right(p)); }, false));
  methods.push_back(fake("blind", [](const Pair&) { return answered(Verdict::disjoint); }));
  methods.push_back(fake("crashing", [](const Pair& p) {
    if (p.b.center.x() > 2.49) std::abort();
    return answered(right(p));
  }));
  methods.push_back(fake(
      "choosy", [](const Pair& p) { return p.b.center.x() > 2.1 ? MethodAnswer{} : answered(right(p)); }));
  return methods;
}

/// A folder of its own for each test, gone afterwards.
class Campaign : public testing::Test {
 protected:
  void SetUp() override {
    folder = fs::temp_directory_path() / ("daylight_campaign_" + std::to_string(getpid()) + "_" +
                                          testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder);
    methods = make_methods();
  }
  void TearDown() override { fs::remove_all(folder); }

  CampaignOptions options(const std::string& name, std::uint64_t pairs) const {
    CampaignOptions o;
    o.out = folder / name;
    o.seed = 20261121;
    o.pairs = pairs;
    return o;
  }
  Workload workload() const { return {methods, two_families, cases}; }
  RunStore store(const std::string& name) const { return RunStore::open(folder / name); }

  fs::path folder;
  std::vector<std::unique_ptr<Method>> methods;
  std::vector<Case> cases;
};

/// All of a run that must not depend on times: findings, groups and counts, as text.
std::string content(const RunStore& store, std::uint64_t below = ~0ull) {
  std::string text;
  for (const FindingRecord& f : store.findings()) {
    if (f.index >= below) continue;
    text += std::to_string(f.index) + f.family + std::to_string(f.family_index) + f.method + f.kind +
            f.severity + f.pair + f.answers + f.truth + f.stage + f.reason;
    if (f.margin) text += std::to_string(f.margin->lo) + std::to_string(f.margin->hi);
    text += '\n';
  }
  if (below != ~0ull) return text;
  for (const CellRecord& c : store.cells()) {
    text += c.plane + ' ' + std::to_string(c.x) + ' ' + std::to_string(c.y) + ' ' +
            format_cell_counts(c.methods) + '\n';
  }
  for (const GroupRecord& g : store.groups()) {
    text += g.method + g.kind + g.severity + g.family + std::to_string(g.count) + '\n';
  }
  for (const auto& [method, family, c] : store.tallies()) {
    text += method + family;
    for (const auto n : {c.asked, c.declined, c.failed, c.contract, c.resolution, c.undecided}) {
      text += ' ' + std::to_string(n);
    }
    text += '\n';
  }
  return text;
}

Counts total(const RunStore& store, const std::string& method) {
  Counts sum;
  for (const TallyRecord& t : store.tallies()) {
    if (t.method == method) sum += t.counts;
  }
  return sum;
}

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
    const auto said = parse_json(f.answers);
    ASSERT_EQ(said.size(), methods.size());
    EXPECT_EQ(said["good"]["verdict"], to_string(right(pair)));
    EXPECT_EQ(parse_json(f.truth)["verdict"], to_string(right(pair)));
    if (f.method == "blind") {
      EXPECT_EQ(f.kind, "wrong_disjoint");
      EXPECT_LE(f.margin->lo, (2 - pair.b.center.x()) / 8);
      EXPECT_GE(f.margin->hi, (2 - pair.b.center.x()) / 8);
    } else {
      EXPECT_EQ(f.method, "crashing");
      EXPECT_EQ(f.kind, "crash");
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

TEST_F(Campaign, ABudgetEndsARunThatHasNoOtherLimit) {
  CampaignOptions o = options("run", 0);
  o.budget = std::chrono::seconds(1);
  const CampaignSummary summary = run_campaign(o, workload());
  EXPECT_EQ(summary.harness_failure, "");
  EXPECT_FALSE(summary.interrupted);
  EXPECT_GT(summary.progress.done, 0u);
  EXPECT_EQ(summary.progress.done % batch_size, 0u);
  EXPECT_EQ(total(store("run"), "good").asked, summary.progress.done);
}

TEST_F(Campaign, KilledAtAnyMomentAndResumedIsAsIfNothingHappened) {
  const std::uint64_t batches = 400, pairs = batches * batch_size, most = 30;
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
  const std::uint64_t pairs = 9 * batch_size + 100;
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
  const std::uint64_t pairs = 200 * batch_size + 7, most = 20;
  run_campaign(options("whole", pairs), workload());
  for (std::uint64_t i = 0; i < 3; ++i) {
    CampaignOptions o = shard_options(i, 3, pairs);
    const int kills = kill_until_done(100 * i, most, [&](const auto& on_progress) {
      o.resume = holds_run(o.out);
      run_campaign(o, workload(), on_progress);
    });
    EXPECT_GE(kills, 3) << "of 66 batches";
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
  const unsigned weights[] = {2, 1};
  Workload weighted = workload();
  weighted.weights = weights;
  refuses(shard_options(1, 2, 100), weighted);
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

TEST_F(Campaign, WeightsShareThePairsOutAndAreKept) {
  const unsigned weights[] = {3, 1};
  Workload weighted = workload();
  weighted.weights = weights;
  run_campaign(options("run", 400), weighted);
  EXPECT_EQ(value_of(store("run").config(), "weights"), "3 1");
  std::map<std::string, std::uint64_t> asked;
  for (const TallyRecord& t : store("run").tallies()) {
    if (t.method == "good") asked[t.family] = t.counts.asked;
  }
  EXPECT_EQ(asked["wide"], 300u);
  EXPECT_EQ(asked["narrow"], 100u);
  CampaignOptions on = options("run", 500);
  on.resume = true;
  EXPECT_THROW(run_campaign(on, workload()), std::runtime_error);
  const unsigned equal[] = {1, 1};
  weighted.weights = equal;
  run_campaign(options("equal", 400), weighted);
  run_campaign(options("none", 400), workload());
  EXPECT_EQ(content(store("equal")), content(store("none")));
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
  EXPECT_THROW(run_campaign(o, workload()), std::runtime_error);
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

TEST_F(Campaign, ACostlyMethodIsAskedOnItsShareAndInDisputes) {
  methods.clear();
  methods.push_back(fake(
      "good", [](const Pair& p) { return answered(right(p)); }, false));
  methods.push_back(fake(
      "mostly", [](const Pair& p) { return answered(p.b.center.x() < 1.6 ? Verdict::disjoint : right(p)); }));
  methods.push_back(fake("tolerant", [](const Pair& p) {
    const double gap = p.b.center.x() - 2;
    return answered(std::abs(gap) < 1e-7 ? Verdict::disjoint
                                         : right(p));  // often wrong, always within its claim
  }));
  methods.push_back(fake(
      "costly", [](const Pair& p) { return answered(right(p)); }, true, 100));
  run_campaign(options("run", 1000), workload());
  std::uint64_t expected = 0;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    expected += i % 100 == 0 || two_families[i % 2].generate(20261121, i / 2).b.center.x() < 1.6;
  }
  EXPECT_GT(expected, 20u);
  EXPECT_GT(total(store("run"), "tolerant").resolution, 20u);
  EXPECT_EQ(total(store("run"), "costly").asked, expected);
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
  for (const char* plane : {"angle-margin", "aspect-margin", "scale-offset"}) {
    const std::vector<CellCounts> sums = on_plane(run, plane);
    ASSERT_EQ(sums.size(), methods.size()) << plane;
    EXPECT_EQ(sums[0], (CellCounts{pairs, 0, 0, 0, 0})) << plane;
    EXPECT_EQ(sums[1], (CellCounts{pairs, meet, 0, 0, 0})) << plane;
    EXPECT_EQ(sums[2].failed, total(run, "crashing").failed) << plane;
    EXPECT_EQ(sums[3].undecided, total(run, "choosy").declined) << plane;
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
  EXPECT_EQ(on_plane(store("run"), "angle-margin").at(1).asked, 10u);

  methods.clear();
  methods.push_back(fake(
      "good", [](const Pair& p) { return answered(right(p)); }, false));
  const std::uint64_t pairs = 200 * own_cell_share;
  run_campaign(options("own", pairs), workload());
  const std::uint64_t asked = on_plane(store("own"), "angle-margin").at(0).asked;
  EXPECT_GT(asked, 150u);
  EXPECT_LT(asked, 250u);
}

TEST_F(Campaign, AnOwnMethodWithAMemoryIsFound) {
  methods.clear();
  int calls = 0;
  methods.push_back(fake(
      "moody", [&](const Pair& p) { return answered(++calls % 2 == 0 ? Verdict::undecided : right(p)); },
      false));
  run_campaign(options("run", 3), workload());
  const auto findings = store("run").findings();
  EXPECT_TRUE(std::any_of(findings.begin(), findings.end(),
                          [](const FindingRecord& f) { return f.kind == "nondeterminism" && f.index == 0; }));
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
