// SPDX-License-Identifier: MIT
#include "reports/triage/causes.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>

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

/// A run with causes of one method in one family.
TriagedRun triaged(const std::string& id, const std::vector<FindingKind>& kinds,
                   const std::string& family = "f") {
  TriagedRun run{id, id, id, {{"x", id, 0, 0, "", 1}}, {{"x", family, {1000, 0, 0, 0, 0, 0, 0}}}, {}};
  for (const FindingKind kind : kinds) {
    Cause& b = run.causes.emplace_back();
    b.key = std::string("x/") + to_string(kind);
    b.methods = {b.method = "x"};
    b.families = {family};
    b.severity = Severity::contract;
    b.count = 3;
    b.first_seen = b.last_seen = b.first_version = b.last_version = id;
  }
  return run;
}

TEST(Causes, AreComparedWithEarlierRuns) {
  const TriagedRun first = triaged("1", {FindingKind::hang}), second = triaged("2", {FindingKind::crash});
  const auto compared = [&](TriagedRun run, std::optional<bool> today) {
    compare_with_earlier(run, {first, second}, [&](const Cause&) { return today; });
    return run.causes;
  };
  const auto causes = compared(triaged("3", {FindingKind::hang, FindingKind::malformed}), true);
  EXPECT_EQ(what_changed(causes), "1 new cause, 2 known");
  EXPECT_EQ(causes[0].key, "x/malformed") << "what is new comes first";
  EXPECT_EQ(causes[0].first_version, "3");
  EXPECT_EQ(causes[1].key, "x/hang");
  EXPECT_EQ(causes[1].first_seen, "1") << "though the last run lacks it";
  EXPECT_EQ(causes[1].last_version, "3");
  EXPECT_EQ(causes[2].count, 0u);
  EXPECT_EQ(causes[2].last_seen, "2");
  const auto gone = compared(triaged("3", {}), false);
  ASSERT_EQ(gone.size(), 1u);
  EXPECT_EQ(gone[0].status, Recurrence::gone);
  EXPECT_EQ(what_changed(gone), "0 new causes, 1 gone");
  EXPECT_TRUE(compared(triaged("3", {}), {}).empty()) << "nobody knows";
  EXPECT_EQ(what_changed({Cause{}, Cause{}}), "2 causes");
  EXPECT_EQ(
      what_changed(compared(triaged("3", {FindingKind::malformed}, "another"), {})),
      "1 new cause. For 1 new cause, no earlier run tested the method on these families, so it is unknown "
      "whether it is really new");
}

TEST(Causes, WhatIsCertainlyNewIsNewThoughItsKeyIsKnown) {
  TriagedRun run = triaged("2", {FindingKind::hang});
  compare_with_earlier(run, {triaged("1", {FindingKind::hang})}, [](const Cause&) { return std::nullopt; },
                       {"x/hang"});
  EXPECT_EQ(what_changed(run.causes), "1 new cause");
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
  EXPECT_EQ(parse_json(causes[0].worst->page)["pair"], pair_json(huge(verdict ? 1 : 2)));
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
