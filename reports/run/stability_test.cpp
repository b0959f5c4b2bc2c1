// SPDX-License-Identifier: MIT
#include "reports/run/stability.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "base/json.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/store/run_store.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

TEST(WriteStability, SetsWhatThePageReadsAndLeavesTheRest) {
  const fs::path folder = fs::temp_directory_path() / ("daylight_stability_" + std::to_string(getpid()));
  fs::remove_all(folder);
  FindingRecord f;
  f.method = "stored";
  f.kind = FindingKind::wrong_disjoint;
  f.severity = Severity::contract;
  f.family = "f";
  Case line;
  line.pair = {{{0, 0, 0}, {0, 0, 1}, 1, 2}, {{1.4, 0, 0}, {0, 0, 1}, 1, 2}};  // 0.6 deep, of size 6
  f.pair = format_case(line);
  f.truth = R"({"verdict":"intersecting","stage":"filter"})";
  f.answers = "[]";
  f.stage = "filter";
  BatchRecord batch;
  batch.next = 1;
  batch.findings = {f};
  RunStore::create(folder, {}).commit(batch, 1);
  std::ofstream(folder / "charts.json") << R"({"maps":[3],"paths":[4]})";
  const auto methods = select_methods(own_methods(), "intersect");
  RunData run = read_run(folder, {});
  write_stability(run, methods, DAYLIGHT_SOURCE_DIR "/bench/stability/builds.jsonl");
  std::ifstream in(folder / "charts.json");
  const json charts = json::parse(in);
  EXPECT_EQ(charts["maps"], parse_json("[3]"));
  EXPECT_EQ(charts["paths"].size(), 24u);
  EXPECT_EQ(charts["paths"][0]["method"], "intersect");
  EXPECT_GT(charts["builds"].size(), 0u);
  bool found = false;
  for (const json& row : charts["backward"])
    if (row["method"] == "stored") {
      found = true;
      EXPECT_EQ(row["wrong"], 1);
      EXPECT_NEAR(row["p50"].get<double>(), 0.1, 1e-3);
    }
  EXPECT_TRUE(found);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace cyl
