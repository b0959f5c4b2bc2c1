// SPDX-License-Identifier: MIT
#include "reports/triage/triage.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <set>
#include <string>

#include "base/usage_error.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/pair_json.hpp"
#include "corpus/store/run_store.hpp"
#include "oracles/methods/fake_method_test.hpp"
#include "oracles/referee/referee.hpp"
#include "reports/triage/causes.hpp"
#include "reports/triage/group_findings.hpp"
#include "reports/triage/suppressions.hpp"
#include "reports/triage/triage_context.hpp"
#include "reports/triage/triage_store.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

FindingRecord finding(const std::string& method, const std::string& family, const Pair& pair,
                      FindingKind kind = FindingKind::wrong_disjoint) {
  FindingRecord f;
  f.family = family;
  f.method = method;
  f.kind = kind;
  f.severity = Severity::contract;
  Trial trial(pair);
  const Verdict said = kind == FindingKind::wrong_intersecting ? Verdict::intersecting : Verdict::disjoint;
  const auto wrong = compare_statement(trial, said);
  f.margin = wrong ? wrong->margin : std::nullopt;
  f.pair = format_pair(pair);
  f.answers = std::string("[[{\"verdict\":\"") + to_string(said) + "\"},[" + quote_json(method) + "]]]";
  f.truth = "{}";
  f.stage = "filter";
  return f;
}

/// Two cylinders of that radius and height that overlap.
Pair huge(double size) {
  Pair p;
  p.a = {{0, 0, 0}, {0, 0, 1}, size, size};
  p.b = {{size / 2, 0, 0}, {0, 1, 0}, size, size};
  return p;
}

/// The page of the book, as printed, answers intersecting for this pair.
Pair apart() {
  Pair p;
  p.a = {{0, 0, 0}, {0, 0, 1}, 3, 2};
  p.b = {{3, 3, 3}, {0, 1, 2}, 1, 4};
  return p;
}

std::vector<FindingRecord> three() {
  return {finding("fcl-libccd", "tiny_and_huge", huge(1e156)), finding("mujoco", "random", huge(1e160)),
          finding("seedbook-printed", "random", apart(), FindingKind::wrong_intersecting)};
}

/// All methods but those that take nine tenths of the time and are not in any test here.
std::vector<std::unique_ptr<Method>> quick_methods() {
  auto methods = all_methods();
  std::erase_if(methods, [](const auto& m) { return m->name().starts_with("nlopt"); });
  return methods;
}

struct Folder {
  fs::path path =
      fs::temp_directory_path() / ("triage_test." + std::to_string(getpid()) + "." + std::to_string(next++));
  Folder() { fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
  static inline int next = 0;

  std::string make_run(const std::string& name, const std::string& started,
                       std::vector<FindingRecord> findings, std::uint64_t times = 1) const {
    const std::string folder = (path / name).string();
    std::vector<MethodRecord> methods;
    for (const char* method : {"fcl-libccd", "mujoco", "seedbook-printed"})
      methods.push_back({method, "1", 0, 0, "", 1});
    RunStore store = RunStore::create(folder, {{"started", started}}, methods);
    BatchRecord batch;
    batch.next = 1;
    for (FindingRecord& f : findings) {
      batch.groups.push_back({{f.method, f.kind, f.severity, f.family}, times});
      for (std::uint64_t i = 0; i < times; ++i) {
        f.index = batch.findings.size();  // a store holds one pair per index
        batch.findings.push_back(f);
      }
    }
    store.commit(batch, 1);
    return folder;
  }
};

Triage triage(const std::string& folder, std::chrono::milliseconds budget = std::chrono::minutes(10)) {
  TriageOptions options;
  options.folder = folder;
  options.budget = budget;
  options.today = "2026-11-22";
  options.build = "test";
  return run_triage(options, quick_methods());
}

std::set<std::string> keys_of(const std::vector<Cause>& causes) {
  std::set<std::string> keys;
  for (const Cause& b : causes) keys.insert(b.key);
  return keys;
}

Json page_of(const ShownCase& shown) { return Json::parse(shown.page); }

TEST(Triage, ShowsCausesWhateverTheOrderAndTheNight) {
  const Folder history;
  const std::string first = history.make_run("one", "2026-11-20", three(), 5);
  const Triage one = triage(first);
  EXPECT_EQ(keys_of(one.causes),
            (std::set<std::string>{"fcl-libccd/overflow", "mujoco/overflow", "seedbook/wrong_intersecting"}));
  EXPECT_EQ(exit_code(one), 2);
  EXPECT_EQ(one.causes[0].key, "seedbook/wrong_intersecting") << "of ordinary size";
  const Cause& overflow = one.causes[1];
  EXPECT_EQ(overflow.key, "fcl-libccd/overflow");
  EXPECT_EQ(overflow.count, 5u);
  EXPECT_EQ(overflow.methods, (std::set<std::string>{"fcl-libccd"}));
  EXPECT_TRUE(overflow.simplified && overflow.seen_again);
  const Json simplest = page_of(overflow.simplest);
  EXPECT_EQ(simplest["truth"]["verdict"], "intersecting");
  EXPECT_EQ(simplest["answers"][overflow.method]["verdict"], "disjoint");
  EXPECT_FALSE(overflow.status);
  EXPECT_NE(simplest["pair"], page_of(*overflow.worst)["pair"]) << "nothing was simplified";
  EXPECT_EQ(causes_json(first), to_json(one.causes));
  for (Json b : causes_json(first)) {
    b["runs"].clear();
    EXPECT_EQ(to_json(cause_from_json(b)), b);
  }

  auto other_way = three();
  std::reverse(other_way.begin(), other_way.end());
  other_way.pop_back();
  const Triage two = triage(history.make_run("two", "2026-11-21", other_way));
  EXPECT_EQ(keys_of(two.causes), keys_of(one.causes));
  for (const Cause& b : two.causes) {
    EXPECT_EQ(b.status, Recurrence::known);
    EXPECT_EQ(b.first_seen, "one");
    EXPECT_EQ(b.last_seen, b.count > 0 ? "two" : "one");
  }
  const Triage three = triage(history.make_run("three", "2026-11-22", {other_way.back()}));
  ASSERT_EQ(three.causes.size(), 3u);
  for (const Cause& b : three.causes) EXPECT_EQ(b.status, Recurrence::known) << "fails today, met or not";
  EXPECT_EQ(three.causes[0].count, 0u);
  EXPECT_EQ(three.causes[0].history.size(), 3u);
}

TEST(Triage, SimplifiesNewCausesBeforeKnownOnes) {
  const Folder history;
  TriageOptions options;
  std::vector<FindingRecord> findings = three();
  findings.push_back(finding("mujoco", "of another family", huge(1e161)));
  options.folder = history.make_run("one", "2026-11-20", findings);
  options.build = "test";
  triage(options.folder);
  const auto methods = quick_methods();
  const TriageContext context(options, methods, {});
  const auto first = [&](const std::set<std::string>& known) {
    return simplification_order(context, known).front()->record->method;
  };
  EXPECT_EQ(first({}), "mujoco") << "it has most findings";
  EXPECT_EQ(first({"fcl-libccd/overflow", "mujoco/overflow"}), "seedbook-printed");
}

TEST(Causes, WhatHangsIsNotAskedOnceTheTimeIsOver) {
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(fake_method("endless", [](const Pair&) -> MethodAnswer {
    volatile bool forever = true;
    while (forever) {
    }
    return answered(Verdict::disjoint);
  }));
  TriageRecords records;
  records.folder = "run";
  records.findings = {finding("endless", "f", apart(), FindingKind::hang)};
  records.findings[0].id = 1;
  records.causes = {{1, "endless/hang", Mechanism::unclassified, ""}};
  const std::vector<std::size_t> groups{0};
  const auto causes = make_causes(records, {methods, groups}, {}, [] { return true; });
  ASSERT_EQ(causes.size(), 1u);
  ASSERT_FALSE(causes[0].seen_again);
  EXPECT_EQ(causes[0].labels[1], "not asked again: no time was left for endless, which hangs");
}

TEST(Causes, NoShareIsNamedIfNoRandomPairShowsTheCause) {
  Cause cause;
  cause.key = "x/hang";
  cause.count = 1;
  cause.share = Cause::Share{1, 64};
  EXPECT_NE(format_causes({cause}).find("1 of 64 similar"), std::string::npos);
  cause.share->wrong = 0;
  EXPECT_EQ(format_causes({cause}).find("of 64"), std::string::npos);
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
  compare_with_earlier(run, {triaged("1", 3)}, [](const Cause&) { return std::nullopt; });
  EXPECT_EQ(run.causes[0].status, Recurrence::rare) << "nobody knows, and it may be chance";
}

TEST(Causes, WhatWasNotLookedAtIsNotMissed) {
  TriagedRun run = triaged("2", 5), earlier = triaged("1", 0);
  compare_with_earlier(run, {earlier}, [](const Cause&) { return std::nullopt; });
  EXPECT_NEAR(*run.causes[0].chance, 1 / 32.0, 1e-9);
  run = triaged("2", 5);
  examine(earlier, 10, 1, 0);
  compare_with_earlier(run, {earlier}, [](const Cause&) { return std::nullopt; });
  EXPECT_GT(*run.causes[0].chance, 0.5);
}

/// If only three of 62 findings are examined, they count as three, even if the cause stands for more.
TEST(Causes, CountOnlyWhatWasLookedAtInBothRuns) {
  TriagedRun run = triaged("2", 62), earlier = triaged("1", 0);
  examine(run, 62, 3, 3);
  examine(earlier, 60, 4, 0);
  compare_with_earlier(run, {earlier}, [](const Cause&) { return std::nullopt; });
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
  compare_with_earlier(run, {earlier}, [](const Cause&) { return std::nullopt; });
  EXPECT_EQ(run.causes[0].status, Recurrence::rare) << "who looked at nothing knows nothing";
  run = triaged("2", 62);
  examine(run, 62, 20, 20);
  examine(earlier, 60, 20, 0);
  compare_with_earlier(run, {earlier}, [](const Cause&) { return std::nullopt; });
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
  compare_with_earlier(run, {triaged("1", 30)}, [](const Cause&) { return std::nullopt; });
  EXPECT_EQ(run.causes[0].key, "x/crash");
  EXPECT_LT(run.causes[0].chance, 1e-9);
  EXPECT_EQ(run.causes[1].status, Recurrence::rare);
  EXPECT_EQ(run.causes[2].first_version, "1");
  EXPECT_EQ(what_changed(run.causes), "1 new cause, 1 known, 1 too rare to judge");
  EXPECT_EQ(what_changed({Cause{}, Cause{}}), "2 causes");
  TriagedRun other = triaged("1", 0);
  other.tallies[0].family = "another";
  run = triaged("2", 30);
  compare_with_earlier(run, {other}, [](const Cause&) { return std::nullopt; });
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

/// The run's answer to the pair does not recur: no method answers disjoint for these two solids.
TEST(Triage, ShowsWhatTheRunSawWhereItIsNotSeenAgain) {
  const Folder history;
  FindingRecord once = finding("mujoco", "random", huge(1));
  once.answers = R"([[{"verdict":"disjoint"},["mujoco"]],[{"verdict":"intersecting"},["intersect"]]])";
  const Triage triaged = triage(history.make_run("one", "2026-11-20", {once}));
  ASSERT_EQ(triaged.causes.size(), 1u);
  const Cause& b = triaged.causes[0];
  EXPECT_FALSE(b.simplified || b.seen_again);
  const Json simplest = page_of(b.simplest);
  EXPECT_EQ(simplest["answers"]["mujoco"]["verdict"], "disjoint");
  EXPECT_TRUE(simplest.contains("note"));
}

/// Returns why a run is refused that states this of the pair apart(), whose solids are 0.02 of their size
/// apart.
std::string refused_with(const std::function<void(FindingRecord&)>& change) {
  const Folder history;
  FindingRecord stated = finding("seedbook-printed", "random", apart(), FindingKind::wrong_intersecting);
  change(stated);
  try {
    triage(history.make_run("one", "2026-11-20", {stated}), std::chrono::milliseconds(1500));
  } catch (const InputError& error) {
    return error.what();
  }
  return "shown";
}

TEST(Triage, JudgesAgainWhatARunStates) {
  const std::string begin = "finding 1 of the run (seedbook-printed wrong_intersecting) ",
                    end = ": it is damaged or forged";
  EXPECT_EQ(refused_with([](FindingRecord&) {}), "shown");
  EXPECT_EQ(
      refused_with([](FindingRecord& f) { f.severity = Severity::resolution; }),
      begin + "is within its claim, but its stored answer is wrong_intersecting (beyond its claim)" + end);
  for (const Enclosure margin : {Enclosure{0.5, 0.5}, Enclosure{1e-9, 1e-9}})
    EXPECT_TRUE(refused_with([&](FindingRecord& f) {
                  f.margin = margin;
                }).starts_with(begin + "states another margin than the "));
  EXPECT_EQ(refused_with([](FindingRecord& f) {
              f.margin = Enclosure{2, 1};
            }),
            begin + "has no such margin" + end);
  EXPECT_EQ(refused_with(
                [](FindingRecord& f) { f.answers = R"([[{"verdict":"disjoint"},["seedbook-printed"]]])"; }),
            begin + "is refuted: its stored answer is right, or missing" + end);
  EXPECT_EQ(refused_with([](FindingRecord& f) { f.kind = FindingKind::crash; }),
            "finding 1 of the run (seedbook-printed crash) is beyond its claim, but its stored answer is "
            "wrong_intersecting (beyond its claim)" +
                end);
}

TEST(Triage, GoesOnWhereItWas) {
  const Folder history;
  const std::string folder = history.make_run("one", "2026-11-20", three());
  const Triage none = triage(folder, std::chrono::milliseconds(0));
  EXPECT_EQ(none.progress.classified, 0u);
  EXPECT_EQ(exit_code(none), 3);
  {
    TriageStore store(folder, methods_line("test", quick_methods()));
    store.add(std::vector<CauseRecord>{{2, "known-before", Mechanism::unclassified, ""}});
    store.add(SimpleRecord{1, "half done", 1, false});
    store.add(SimpleRecord{3, "done", 1, true});
  }
  const Triage all = triage(folder);
  EXPECT_TRUE(keys_of(all.causes).contains("known-before"));
  EXPECT_EQ(all.progress.classified, 3u);
  EXPECT_EQ(all.progress.simplified, 3u);
  for (const SimpleRecord& simple : TriageStore(folder, methods_line("test", quick_methods())).simples()) {
    EXPECT_TRUE(simple.ended);
    EXPECT_EQ(simple.pair == "done", simple.finding == 3);
    EXPECT_NE(simple.pair, "half done");
  }
  const TriageStore other(folder, "another build");
  EXPECT_TRUE(other.causes().empty());
}

/// Returns the distance of the solids of apart(), in sizes.
double margin_of_apart() {
  const Enclosure d = enclose_distance(apart(), judge(apart()));
  return d.lo / size_of(apart());
}

TEST(Triage, SearchesForAWorsePairAndKeepsIt) {
  const Folder history;
  FindingRecord printed = finding("seedbook-printed", "random", apart(), FindingKind::wrong_intersecting);
  printed.margin = Enclosure{margin_of_apart(), margin_of_apart()};
  const std::string folder = history.make_run("one", "2026-11-20", {printed});
  const Triage first = triage(folder);
  ASSERT_EQ(first.causes.size(), 1u);
  EXPECT_EQ(first.progress.searched, 1u);
  const Json worst = page_of(first.causes[0].worst.value());
  EXPECT_GT(worst["margin"][0], 1.2 * margin_of_apart());
  EXPECT_EQ(worst["truth"]["verdict"], "disjoint");
  EXPECT_EQ(worst["answers"]["seedbook-printed"]["verdict"], "intersecting");
  EXPECT_NE(worst["note"].get<std::string>().find(folder + ":1"), std::string::npos)
      << "where the original is";
  for (const Json& shown : {page_of(first.causes[0].simplest), worst})
    for (const char* what : {"nearest", "direction"}) EXPECT_TRUE(shown.contains(what)) << what;
  EXPECT_NE(format_causes(first.causes).find("by search"), std::string::npos);

  TriageStore store(folder, methods_line("test", quick_methods()));
  ASSERT_EQ(store.worsts().size(), 1u);
  WorstRecord kept = store.worsts()[0];
  EXPECT_TRUE(kept.ended);

  // A pair that is no longer wrong, or less wrong than the finding, is not shown. A search that ended is not
  // repeated.
  kept.pair = format_pair(huge(1));
  store.add(kept);
  const Triage again = triage(folder);
  const Json shown = page_of(again.causes[0].worst.value());
  EXPECT_FALSE(shown.contains("note"));
  EXPECT_EQ(shown["pair"], Json::parse(format_pair(apart())));
  // A search that was cut continues.
  kept.ended = false;
  store.add(kept);
  EXPECT_EQ(page_of(triage(folder).causes[0].worst.value())["margin"], worst["margin"]);
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
  TriageRecords records;
  for (std::int64_t id = 1; id <= 2; ++id) {
    records.findings.push_back(
        finding("intersect", "f", apart(), id == 1 ? FindingKind::non_finite : FindingKind::wrong_disjoint));
    records.findings.back().id = id;
    records.causes.push_back({id, "own/absolute-length", Mechanism::absolute_length, ""});
  }
  records.findings[0].reason = "the witness is not finite";
  const auto methods = select_methods(own_methods(), "intersect");
  const std::vector<std::size_t> groups{0};
  const auto causes = make_causes(records, {methods, groups}, {}, [] { return true; });
  ASSERT_EQ(causes.size(), 1u);
  EXPECT_TRUE(causes[0].description.ends_with(
      "(answers disjoint for pairs that meet; returns a number that is infinite, the "
      "largest double, or not a number: the witness is not finite)"))
      << causes[0].description;
}

TEST(Causes, TheMarginIsOfFindingsOfTheKind) {
  TriageRecords records;
  records.findings = {finding("intersect", "f", huge(1)), finding("decide", "f", huge(2))};
  records.findings[1].kind = FindingKind::bad_witness;
  records.findings[0].margin = Enclosure{0.1, 0.2};
  records.findings[1].margin = Enclosure{0.41, 0.42};
  for (std::int64_t id : {1, 2}) {
    records.findings[static_cast<std::size_t>(id) - 1].id = id;
    records.causes.push_back({id, "x", Mechanism::unclassified, ""});
  }
  const auto methods = select_methods(own_methods(), "intersect,decide");
  const auto causes =
      make_causes(records, {methods, std::vector<std::size_t>{0, 1}}, {}, [] { return true; });
  ASSERT_EQ(causes.size(), 1u);
  const bool verdict = causes[0].kind == FindingKind::wrong_disjoint;
  EXPECT_EQ(causes[0].methods.size(), 2u);
  EXPECT_EQ(causes[0].methods_of_kind, (std::set<std::string>{verdict ? "intersect" : "decide"}));
  EXPECT_EQ(causes[0].margin->hi, verdict ? 0.1 : 0.41);
  EXPECT_EQ(parse_json(causes[0].worst->page)["pair"], pair_to_json(huge(verdict ? 1 : 2)));
}

TEST(Causes, ShowAPairWithoutRoundingsAndOfOrdinarySize) {
  const auto methods = select_methods(own_methods(), "intersect");
  TriageRecords records;
  for (const double size : {1e-5, 1.0, 2.0}) {  // the simplest has roundings
    Pair pair = huge(size);
    if (size == 1) pair.a.rounding = 1;
    if (size == 2) pair.b.axis = {0.25, 1, 0.5};
    records.findings.push_back(finding("intersect", "f", pair));
    records.findings.back().id = static_cast<std::int64_t>(records.findings.size());
    records.causes.push_back({records.findings.back().id, "x", Mechanism::unclassified, ""});
  }
  const auto causes = make_causes(records, {methods, std::vector<std::size_t>{0}}, {}, [] { return true; });
  ASSERT_EQ(causes.size(), 1u);
  EXPECT_EQ(causes[0].simplest.pair.a.radius, 2);
  EXPECT_NE(format_causes(causes).find("a pair (not simplified): {"), std::string::npos);
}

TEST(Causes, GiveAGroupsCountAsItsKeptOnesAre) {
  TriageRecords records;
  for (std::int64_t id = 1; id <= 3; ++id) {
    records.findings.push_back(finding("m", "f", apart()));
    records.findings.back().id = id;
    records.causes.push_back({id, id == 1 ? "rare" : "often", Mechanism::unclassified, ""});
  }
  records.groups.push_back({{"m", FindingKind::wrong_disjoint, Severity::contract, "f"}, 100});
  records.groups.push_back({{"m", FindingKind::wrong_disjoint, Severity::contract, "not kept"}, 7});
  const auto counts = count_by_cause(records.groups, records.findings, records.causes);
  EXPECT_EQ(counts.at("often"), 67u);
  EXPECT_EQ(counts.at("rare"), 33u);
}

TEST(Causes, SuppressedDoNotFail) {
  Triage t;
  t.causes.resize(1);
  t.causes[0].key = "x";
  t.causes[0].severity = Severity::contract;
  EXPECT_EQ(exit_code(t), 2);
  const std::vector<Suppression> all{{"x", "because", "link", "ada", "2026-11-22", 1}};
  suppress(t.causes, all, "2026-11-22");
  EXPECT_EQ(t.causes[0].suppressed->owner, "ada");
  EXPECT_EQ(exit_code(t), 0);
  suppress(t.causes, all, "2026-11-23");
  EXPECT_EQ(exit_code(t), 2);
}

}  // namespace
}  // namespace cyl
