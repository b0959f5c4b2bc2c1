// SPDX-License-Identifier: MIT
#include "reports/triage/causes.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>
#include <set>
#include <string>

#include "corpus/pairs/pair_json.hpp"
#include "oracles/methods/fake_method_test.hpp"
#include "reports/triage/group_findings.hpp"
#include "reports/triage/triage.hpp"
#include "reports/triage/triage_test.hpp"

namespace cyl {
namespace {

using Json = nlohmann::json;

/// The findings get the numbers 1, 2, ... and this cause.
TriageRecords records_of(std::vector<FindingRecord> findings, const std::string& cause) {
  TriageRecords records;
  records.folder = "run";
  for (FindingRecord& f : findings) {
    f.id = static_cast<std::int64_t>(records.causes.size() + 1);
    records.causes.push_back({f.id, cause, Mechanism::unclassified, ""});
  }
  records.findings = std::move(findings);
  return records;
}

/// No time is left for what hangs.
std::vector<Cause> causes_of(const TriageRecords& records,
                             const std::vector<std::unique_ptr<Method>>& methods) {
  std::vector<std::size_t> groups(methods.size());
  std::iota(groups.begin(), groups.end(), 0);
  return make_causes(records, {methods, groups}, {}, [] { return true; });
}

TEST(Causes, WhatHangsIsNotAskedOnceTheTimeIsOver) {
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(fake_method("endless", [](const Pair&) -> MethodAnswer {
    volatile bool forever = true;
    while (forever) {
    }
    return answered(Verdict::disjoint);
  }));
  const auto causes =
      causes_of(records_of({finding("endless", "f", apart(), FindingKind::hang)}, "endless/hang"), methods);
  ASSERT_EQ(causes.size(), 1u);
  ASSERT_FALSE(causes[0].seen_again);
  EXPECT_EQ(causes[0].labels[1], "not asked again: no time was left for endless, which hangs");
}

/// A run with one cause, on which one method is wrong for so many pairs of 1000.
TriagedRun triaged(const std::string& id, std::uint64_t pairs, FindingKind kind = FindingKind::hang) {
  const std::string key = std::string("x/") + to_string(kind);
  TriagedRun run{id, id, id, {{"x", id, 0, 0, "", 1}}, {{"x", "f", {1000, 0, 0, 0, 0, 0, 0}}}, {}, {}};
  if (pairs == 0) return run;
  Cause b;
  b.key = key;
  b.method = "x";
  b.methods = {"x"};
  b.families = {"f"};
  b.severity = Severity::contract;
  b.count = 3 * pairs;
  b.first_seen = b.last_seen = b.first_version = b.last_version = id;
  run.causes = {b};
  run.examined[{"x", kind, Severity::contract, "f"}] = {pairs, pairs, {{key, pairs}}};
  return run;
}

/// Sets the findings of the group "x/hang", how many are examined, and how many of these have the cause.
void examine(TriagedRun& run, std::uint64_t found, std::uint64_t looked_at, std::uint64_t of_cause) {
  ExaminedFindings& e =
      run.examined[{"x", FindingKind::hang, Severity::contract, "f"}] = {found, looked_at, {}};
  if (of_cause > 0) e.by_cause["x/hang"] = of_cause;
}

/// Compares without an answer of today.
void compare(TriagedRun& run, const TriagedRun& earlier) {
  compare_with_earlier(run, {earlier}, [](const Cause&) { return std::nullopt; });
}

TEST(Causes, GoneIsWhatAnswersRightToday) {
  for (const auto& [answer, status] :
       {std::pair(std::optional(false), Recurrence::gone), std::pair(std::optional(true), Recurrence::known),
        std::pair(std::optional<bool>(), Recurrence::gone)}) {
    const std::optional<bool> today = answer;
    TriagedRun run = triaged("2", 0);
    compare_with_earlier(run, {triaged("1", 30)}, [&](const Cause&) { return today; });
    ASSERT_EQ(run.causes.size(), 1u);
    EXPECT_EQ(run.causes[0].status, status);
    EXPECT_EQ(run.causes[0].count, 0u);
    EXPECT_EQ(run.causes[0].last_version, "1");
  }
  TriagedRun run = triaged("2", 0);
  compare(run, triaged("1", 3));
  EXPECT_EQ(run.causes[0].status, Recurrence::rare) << "nobody knows, and it may be chance";
}

TEST(Causes, WhatWasNotLookedAtIsNotMissed) {
  TriagedRun run = triaged("2", 5), earlier = triaged("1", 0);
  compare(run, earlier);
  EXPECT_NEAR(*run.causes[0].chance, 1 / 32.0, 1e-9);
  run = triaged("2", 5);
  examine(earlier, 10, 1, 0);
  compare(run, earlier);
  EXPECT_GT(*run.causes[0].chance, 0.5);
}

/// If only three of 62 findings are examined, they count as three, even if the cause stands for more.
TEST(Causes, CountOnlyWhatWasLookedAtInBothRuns) {
  TriagedRun run = triaged("2", 62), earlier = triaged("1", 0);
  examine(run, 62, 3, 3);
  examine(earlier, 60, 4, 0);
  compare(run, earlier);
  EXPECT_EQ(run.causes[0].status, Recurrence::rare);
  const Cause::RunObservation& night = run.causes[0].history.back();
  EXPECT_EQ(night.examined.count, 3u);
  EXPECT_EQ(night.examined.asked, 48u);
  EXPECT_EQ(night.all.count, 62u) << "what is shown is all";
  run.causes[0].simplest.page = "{}";
  const Json shown = to_json(run.causes[0])["runs"].back();
  EXPECT_EQ(shown["count"], 62);
  EXPECT_EQ(shown["asked"], 1000);
  EXPECT_DOUBLE_EQ(shown["per_million"][0], 62000);
  examine(earlier, 60, 0, 0);
  compare(run, earlier);
  EXPECT_EQ(run.causes[0].status, Recurrence::rare) << "who looked at nothing knows nothing";
  run = triaged("2", 62);
  examine(run, 62, 20, 20);
  examine(earlier, 60, 20, 0);
  compare(run, earlier);
  EXPECT_EQ(run.causes[0].status, Recurrence::fresh);
}

TEST(Causes, NewComesFirstAndIsNoChance) {
  TriagedRun run = triaged("2", 30);
  for (const auto& [pairs, kind] :
       {std::pair(40, FindingKind::crash), std::pair(2, FindingKind::malformed)}) {
    TriagedRun other = triaged("2", static_cast<std::uint64_t>(pairs), kind);
    run.causes.push_back(other.causes[0]);
    run.examined.merge(other.examined);
  }
  compare(run, triaged("1", 30));
  EXPECT_EQ(run.causes[0].key, "x/crash");
  EXPECT_LT(run.causes[0].chance, 1e-9);
  EXPECT_EQ(run.causes[1].status, Recurrence::rare);
  EXPECT_EQ(run.causes[2].first_version, "1");
  EXPECT_EQ(what_changed(run.causes), "1 new cause, 1 known, 1 too rare to judge");
  EXPECT_EQ(what_changed({Cause{}, Cause{}}), "2 causes");
  TriagedRun other = triaged("1", 0);
  other.tallies[0].family = "another";
  run = triaged("2", 30);
  compare(run, other);
  EXPECT_EQ(
      what_changed(run.causes),
      "1 new cause. For 1 new cause, no earlier run tested the method on these families, so it is unknown "
      "whether it is really new");
}

TEST(Causes, FilesAreCalledAsTheyAre) {
  EXPECT_EQ(file_name_of("libccd-mpr/wrong_disjoint"), "libccd-mpr.wrong_disjoint");
  EXPECT_EQ(file_name_of("../x y").substr(0, 7), "...x.y.");
  EXPECT_NE(file_name_of("../x y"), file_name_of("../x z"));
  EXPECT_NE(file_name_of("a b"), file_name_of("a/b"));
  EXPECT_LT(file_name_of(std::string(5000, 'a')).size(), 120u);
}

TEST(Causes, AWrongVerdictIsWorseThanAWrongDistance) {
  FindingRecord verdict = finding("m", "f", huge(1)),
                distance = finding("m", "f", apart(), FindingKind::distance_outside);
  distance.margin = Enclosure{9, 9};
  EXPECT_TRUE(is_worse(verdict, distance));
  EXPECT_FALSE(is_worse(distance, verdict));
  FindingRecord deeper = verdict;
  deeper.margin->lo = 2 * verdict.margin->lo;
  EXPECT_TRUE(is_worse(deeper, verdict));
}

TEST(Causes, HaveMarginsOfAtLeastWhatIsProved) {
  Cause b;
  b.count = 1;
  b.methods = {"m"};
  b.families = {"f", "g"};
  b.margin = Enclosure{1e-9, std::numeric_limits<double>::infinity()};
  b.simplest = {apart(), {}, Json{{"pair", Json::parse(format_pair(apart()))}, {"margin", nullptr}}.dump()};
  const std::string text = format_causes({b});
  EXPECT_NE(text.find("    1 finding in 2 families, of 1 method; margins from 1.0e-09 up to inf or more\n"),
            std::string::npos)
      << text;
  EXPECT_EQ(to_json(b)["margin"], Json({1e-9, "inf"}));
  EXPECT_EQ(cause_from_json(to_json(b)).margin->hi, b.margin->hi);
}

TEST(Causes, TheWordsOfAFailureStandByItsKind) {
  TriageRecords records = records_of({finding("intersect", "f", apart(), FindingKind::non_finite),
                                      finding("intersect", "f", apart(), FindingKind::wrong_disjoint)},
                                     "own/absolute-length");
  for (CauseRecord& cause : records.causes) cause.mechanism = Mechanism::absolute_length;
  records.findings[0].reason = "the witness is not finite";
  const auto causes = causes_of(records, select_methods(own_methods(), "intersect"));
  ASSERT_EQ(causes.size(), 1u);
  EXPECT_TRUE(causes[0].description.ends_with(
      "(answers disjoint for pairs that meet; returns a number that is infinite, the "
      "largest double, or not a number: the witness is not finite)"))
      << causes[0].description;
}

TEST(Causes, TheMarginIsOfFindingsOfTheKind) {
  TriageRecords records =
      records_of({finding("intersect", "f", huge(1)), finding("decide", "f", huge(2))}, "x");
  records.findings[1].kind = FindingKind::bad_witness;
  records.findings[0].margin = Enclosure{0.1, 0.2};
  records.findings[1].margin = Enclosure{0.41, 0.42};
  const auto causes = causes_of(records, select_methods(own_methods(), "intersect,decide"));
  ASSERT_EQ(causes.size(), 1u);
  const bool verdict = causes[0].kind == FindingKind::wrong_disjoint;
  EXPECT_EQ(causes[0].methods.size(), 2u);
  EXPECT_EQ(causes[0].methods_of_kind, (std::set<std::string>{verdict ? "intersect" : "decide"}));
  EXPECT_EQ(causes[0].margin->hi, verdict ? 0.1 : 0.41);
  EXPECT_EQ(parse_json(causes[0].worst->page)["pair"], pair_to_json(huge(verdict ? 1 : 2)));
}

TEST(Causes, ShowAPairWithoutRoundingsAndOfOrdinarySize) {
  std::vector<FindingRecord> findings;
  for (const double size : {1e-5, 1.0, 2.0}) {  // the simplest has roundings
    Pair pair = huge(size);
    if (size == 1) pair.a.rounding = 1;
    if (size == 2) pair.b.axis = {0.25, 1, 0.5};
    findings.push_back(finding("intersect", "f", pair));
  }
  const auto causes = causes_of(records_of(findings, "x"), select_methods(own_methods(), "intersect"));
  ASSERT_EQ(causes.size(), 1u);
  EXPECT_EQ(causes[0].simplest.pair.a.radius, 2);
  EXPECT_NE(format_causes(causes).find("a pair (not simplified): {"), std::string::npos);
}

TEST(Causes, GiveAGroupsCountAsItsKeptOnesAre) {
  TriageRecords records = records_of({3, finding("m", "f", apart())}, "often");
  records.causes[0].cause = "rare";
  records.groups.push_back({{"m", FindingKind::wrong_disjoint, Severity::contract, "f"}, 100});
  records.groups.push_back({{"m", FindingKind::wrong_disjoint, Severity::contract, "not kept"}, 7});
  const auto counts = count_by_cause(records.groups, records.findings, records.causes);
  EXPECT_EQ(counts.at("often"), 67u);
  EXPECT_EQ(counts.at("rare"), 33u);
}

}  // namespace
}  // namespace cyl
