// SPDX-License-Identifier: MIT
#include "reports/gate_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "corpus/pair_io.hpp"
#include "reports/gate_example.hpp"

namespace cyl {
namespace {

using json = nlohmann::json;

TEST(GateJson, IsTheWholeReport) {
  const json all = json::parse(gate_json(example_report()));
  EXPECT_EQ(all["seed"], std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(all["undecided_truths"], 3);
  EXPECT_EQ(all["phases"][1],
            json({{"phase", "sample of all strata"}, {"pairs", 345678}, {"milliseconds", 30040}}));
  const json& method = all["methods"][0];
  EXPECT_EQ(method["counts"]["said"]["undecided"], 77);
  EXPECT_EQ(method["claim"]["relative"], 1e-13);
  EXPECT_EQ(method["cells"].size(), 26u);
  EXPECT_EQ(all["methods"][1]["cells"][1]["wrong"], 7);
  const json& failure = all["failures"][1];
  EXPECT_EQ(failure["law"], 2);
  EXPECT_EQ(failure["severity"], "resolution");
  EXPECT_EQ(failure["failed_again"], 3);
  EXPECT_EQ(failure["known"], false);
  EXPECT_EQ(all["failures"][3]["found"]["a"]["height"], "nan");
}

TEST(GateJson, PairsAreReadBackToTheBit) {
  const GateReport report = example_report();
  const json found = json::parse(gate_json(report))["failures"][0]["found"];
  const CaseLine line = parse_case(found.dump(), 1);
  ASSERT_TRUE(line.value) << line.error;
  EXPECT_EQ(format_pair(line.value->pair), format_pair(report.failures[0].found));
  EXPECT_TRUE(std::signbit(line.value->pair.b.center[1]));
}

TEST(GateJson, BucketsComeBack) {
  const ScratchFile file(gate_json(example_report()));
  GateReport report = example_report();
  report.failures[0].bucket = "a new one";
  report.failures[2].bucket.clear();
  mark_known(report, read_buckets(file.path));
  EXPECT_FALSE(report.failures[0].known);
  EXPECT_EQ(report.failures[1].known, report.failures[1].severity == Severity::contract);
  EXPECT_FALSE(report.failures[2].known);
  mark_known(report, {report.failures[1].bucket});
  EXPECT_TRUE(report.failures[1].known);
  mark_known(report, {});
  EXPECT_FALSE(report.failures[1].known);
  mark_known(report, {""});
  EXPECT_FALSE(report.failures[2].known) << "without a bucket nothing is known";
}

TEST(GateJson, BadBasesAreRefusedByName) {
  const std::string good = gate_json(example_report());
  for (const std::string& bad : {std::string(), std::string("{"), std::string("[]"), std::string("{}"),
                                 std::string("{\"failures\":7}"), std::string("{\"failures\":[{}]}"),
                                 std::string("{\"failures\":[{\"bucket\":7}]}"),
                                 std::string("{\"failures\":[7]}"), good.substr(0, good.size() / 2)}) {
    const ScratchFile file(bad);
    try {
      read_buckets(file.path);
      ADD_FAILURE() << "read: " << bad.substr(0, 40);
    } catch (const std::runtime_error& refused) {
      EXPECT_NE(std::string(refused.what()).find(file.path), std::string::npos) << refused.what();
    }
  }
  EXPECT_THROW(read_buckets("/no/such/file"), std::runtime_error);
  EXPECT_THROW(read_buckets(std::filesystem::temp_directory_path()), std::runtime_error);
}

}  // namespace
}  // namespace cyl
