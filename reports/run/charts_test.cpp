// SPDX-License-Identifier: MIT
#include "reports/run/charts.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "base/files.hpp"
#include "base/json.hpp"
#include "base/scratch_test.hpp"
#include "base/usage_error.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/store/representatives.hpp"
#include "reports/run/bench_table.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Two upright cylinders side by side with this margin, of size 6.
Pair beside(double margin) {
  return {{{0, 0, 0}, {0, 0, 1}, 1, 2}, {{2 + 6 * margin, 0, 0}, {0, 0, 1}, 1, 2}};
}

FindingRecord finding(const char* method, FindingKind kind, const Pair& pair, Verdict truth) {
  FindingRecord f;
  f.method = method;
  f.kind = kind;
  f.severity = Severity::contract;
  f.family = "f";
  f.pair = format_pair(pair);
  f.truth = std::string("{\"verdict\":\"") + to_string(truth) + "\",\"stage\":\"filter\"}";
  f.answers = "[]";
  return f;
}

MethodRecord method(const char* name) { return {name, "1", 0, 0, "", 1}; }

/// A run of two methods on four kinds of pairs.
class Charts : public testing::Test {
 protected:
  void SetUp() override {
    RunStore run = RunStore::create(folder, {}, {method("good"), method("bad"), method("silent")});
    BatchRecord batch;
    batch.next = 9;
    CellTable cells;
    const auto ask = [&](const Pair& pair, Verdict truth, const std::vector<CellCounts>& counts) {
      const auto places = cells_of(pair, truth);
      for (const Plane p : planes) {
        const Cell at = places[static_cast<std::size_t>(p)];
        cells.add({std::string(to_string(p)), at.x, at.y, counts});
      }
    };
    ask(beside(3e-7), Verdict::disjoint, {{4}, {4, 0, 2, 0, 0, 1, 0, 1}});
    ask(beside(-3e-7), Verdict::intersecting, {{2}, {2, 1, 0, 1, 0}});
    ask(beside(1), Verdict::disjoint, {{3}, {3, 0, 0, 0, 1}});
    ask(beside(0), Verdict::touching, {{7}, {0}});
    ask(beside(1e-17), Verdict::disjoint, {{1}, {0}});
    batch.cells = cells.records();
    batch.findings = {finding("bad", FindingKind::distance_outside, beside(3e-7), Verdict::disjoint),
                      finding("bad", FindingKind::wrong_intersecting, beside(4e-7), Verdict::undecided),
                      finding("bad", FindingKind::wrong_intersecting, beside(4e-7), Verdict::disjoint),
                      finding("bad", FindingKind::wrong_intersecting, beside(3e-7), Verdict::disjoint),
                      finding("bad", FindingKind::crash, beside(1), Verdict::disjoint)};
    Representatives kept;
    for (std::size_t i = 0; i < batch.findings.size(); ++i) {
      batch.findings[i].index = i;
      kept.admit(batch.findings[i]);
    }
    batch.groups = kept.groups();
    run.commit(batch, 1);
  }
  json charts() const { return parse_json(read_file(folder / "charts.json")); }
  const Scratch scratch;
  const fs::path folder = scratch.folder / "run";
};

json cell_at(const json& map, const Pair& pair, Verdict truth) {
  const Cell at = cells_of(pair, truth)[static_cast<std::size_t>(Plane::angle_margin)];
  for (const json& c : map["cells"])
    if (c["x"] == at.x && c["y"] == at.y) return c;
  return {};
}

TEST_F(Charts, MapsCountAndNameTheFirstFindingOfEachCell) {
  const json maps = failure_maps(read_run(folder));
  ASSERT_EQ(maps.size(), 2 * planes.size());  // the silent method was not asked
  EXPECT_EQ(maps[0]["method"], "good");
  const json& bad = maps[planes.size()];
  EXPECT_EQ(bad["method"], "bad");
  EXPECT_EQ(bad["plane"], "angle-margin");
  const json near = cell_at(bad, beside(3e-7), Verdict::disjoint);  // both sides of touching
  EXPECT_EQ(near["asked"], 6);
  EXPECT_EQ(near["wrong_disjoint"], 1);
  EXPECT_EQ(near["wrong_intersecting"], 2);
  EXPECT_EQ(near["finding"], 3);  // not the distance, not the undecided pair
  EXPECT_FALSE(cell_at(bad, beside(1), Verdict::disjoint).contains("finding"))
      << "no failure was counted there, only seen in a dispute";
  EXPECT_TRUE(cell_at(bad, beside(0), Verdict::touching).is_null());
  EXPECT_FALSE(cell_at(maps[0], beside(3e-7), Verdict::disjoint).contains("finding"));
}

TEST_F(Charts, TheFileHasWhatThePageReadsAndKeepsWhatOthersWrote) {
  std::ofstream(folder / "charts.json") << R"({"other":[1],"maps":[],"speed":[5]})";
  RunData run = read_run(folder);
  write_charts(run, {});
  EXPECT_EQ(charts()["other"], parse_json("[1]"));
  EXPECT_EQ(charts()["speed"], parse_json("[5]"));
  BenchRow row;
  row.method = "bad-tol1e-4";
  row.name = {"bad", "", "tol1e-4"};
  row.family = "margin_1e-01";
  row.query = "verdict";
  row.pairs = 9;
  row.median_ns = 12.5;
  BenchRow distance = row;
  distance.query = "distance";
  write_charts(run, {distance, row});
  const json all = charts();
  EXPECT_EQ(all, run.charts);
  EXPECT_EQ(all["other"], parse_json("[1]"));
  const json& cell = all["maps"][planes.size()]["cells"][1];
  for (const char* field : {"x", "y", "asked", "wrong_disjoint", "wrong_intersecting", "failed", "declined",
                            "within_intersecting", "finding"})
    EXPECT_TRUE(cell.contains(field)) << field;
  for (const char* zero : {"undecided", "within_disjoint"}) EXPECT_FALSE(cell.contains(zero)) << zero;
  EXPECT_EQ(all["maps"][planes.size()]["plane"], "angle-margin");
  EXPECT_EQ(all["maps"][planes.size()]["x"]["labels"][static_cast<std::size_t>(cell["x"])], "parallel");
  EXPECT_EQ(all["maps"][planes.size()]["y"]["labels"][static_cast<std::size_t>(cell["y"])], "1e-6");
  EXPECT_EQ(all["speed"], parse_json(R"([{"method":"bad-tol1e-4","curve":"bad","setting":"tol1e-4",
    "family":"all","query":"verdict","ns":12.5,"p99":null,"asked":9,"wrong_disjoint":0,
    "wrong_intersecting":0,"digits":1,"digits_low":null}])"));
}

TEST_F(Charts, ReadWhatABenchWrote) {
  BenchRow row;
  row.method = "a \"b\"";
  row.name = {"a", "b", "c"};
  row.family = "random";
  row.query = "distance";
  row.pairs = 7;
  row.median_ns = 0.1;
  row.wrong_disjoint = 1;
  row.wrong_intersecting = 2;
  row.undecided = 3;
  row.failed = 4;
  const fs::path file = folder / "bench.json";
  std::ofstream(file) << json{{"results", bench_json({&row, 1})}};
  const std::vector<BenchRow> rows = read_bench(file);
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].method, row.method);
  EXPECT_EQ(rows[0].name.setting, "c");
  EXPECT_EQ(rows[0].query, "distance");
  EXPECT_EQ(rows[0].pairs, 7u);
  EXPECT_EQ(rows[0].median_ns, 0.1);
  EXPECT_NE(rows[0].p99_ns, rows[0].p99_ns);
  EXPECT_EQ(rows[0].wrong_disjoint + 10 * rows[0].wrong_intersecting + 100 * rows[0].undecided +
                1000 * rows[0].failed,
            4321u);
  std::ofstream(file) << R"({"date":"2026-01-02","cpu":"a machine","results":[]})";
  EXPECT_EQ(origin_of_bench(file), "a machine, 2026-01-02");
  for (const char* bad : {"", "[]", "{}", R"({"results":[{}]})"}) {
    std::ofstream(file) << bad;
    EXPECT_THROW(read_bench(file), InputError) << bad;
  }
}

}  // namespace
}  // namespace cyl
