// SPDX-License-Identifier: MIT
#include "reports/triage/triage.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "base/scratch_test.hpp"
#include "reports/triage/triage_context.hpp"
#include "reports/triage/triage_store.hpp"
#include "reports/triage/triage_test.hpp"

namespace cyl {
namespace {

using Json = nlohmann::json;

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

struct Folder : Scratch {
  std::string make_run(const std::string& name, const std::string& started,
                       std::vector<FindingRecord> findings, std::uint64_t times = 1) const {
    const std::string run = (folder / name).string();
    std::vector<MethodRecord> methods;
    for (const char* method : {"fcl-libccd", "mujoco", "seedbook-printed"})
      methods.push_back({method, "1", 0, 0, "", 1});
    RunStore store = RunStore::create(run, {{"started", started}}, methods);
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
    return run;
  }
};

Triage triage(const std::string& folder, std::chrono::milliseconds budget = std::chrono::minutes(10)) {
  TriageOptions options;
  options.folder = folder;
  options.budget = budget;
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
  for (const Json& shown : {page_of(one.causes[0].simplest), page_of(*one.causes[0].worst)})
    for (const char* what : {"nearest", "direction"}) EXPECT_TRUE(shown.contains(what)) << what;
  EXPECT_EQ(causes_json(first), to_json(one.causes));
  for (const Json& b : causes_json(first)) EXPECT_EQ(to_json(cause_from_json(b)), b);

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

TEST(Triage, GoesOnWhereItWas) {
  const Folder history;
  const std::string folder = history.make_run("one", "2026-11-20", three());
  const Triage none = triage(folder, std::chrono::milliseconds(0));
  EXPECT_EQ(none.progress.classified, 0u);
  EXPECT_EQ(exit_code(none), 3);
  {
    TriageStore store(folder, methods_line("test", quick_methods()));
    store.add(std::vector<CauseRecord>{{2, "known-before", Mechanism::unclassified, ""}});
    store.add(SimpleRecord{1, "half done", false});
    store.add(SimpleRecord{3, "done", true});
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

}  // namespace
}  // namespace cyl
