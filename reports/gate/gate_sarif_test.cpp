// SPDX-License-Identifier: MIT
#include "base/json.hpp"
#include "reports/gate/failure_text.hpp"
#include "reports/gate/gate_example_test.hpp"
#include "reports/gate/gate_writers.hpp"

namespace cyl {
namespace {

using json = nlohmann::json;

bool valid(const std::string& document) { return keeps_to("sarif.json", document); }

TEST(GateSarif, KeepsToItsSchema) {
  if (schema_python().empty()) SKIP_WITHOUT("python3-jsonschema");
  const std::string document = gate_sarif(example_gate(), "0.1.0", true);
  EXPECT_TRUE(valid(document)) << document;
  EXPECT_TRUE(valid(gate_sarif({}, "0.1.0", false)));
  EXPECT_TRUE(valid(gate_sarif(cut_gate(), "0.1.0", false)));
  const json good = parse_json(document);
  for (
      const char* planted :
      {R"([{"op":"remove","path":"/runs/0/results/0/locations"}])",
       R"([{"op":"add","path":"/runs/0/results/0/colour","value":"red"}])",
       R"([{"op":"replace","path":"/runs/0/results/0/level","value":"bad"}])",
       R"([{"op":"replace","path":"/runs/0/results/0/locations/0/physicalLocation/region/startLine","value":0}])",
       R"([{"op":"remove","path":"/runs/0/tool/driver/name"}])"})
    EXPECT_FALSE(valid(good.patch(parse_json(planted)).dump())) << planted;
}

TEST(GateSarif, ARuleALawAndAResultAFailure) {
  const json run = parse_json(gate_sarif(example_gate(), "0.1.0", false))["runs"][0];
  const json& rules = run["tool"]["driver"]["rules"];
  ASSERT_EQ(rules.size(), all_laws().size());
  EXPECT_EQ(rules[0]["id"], "law-1");
  const json& results = run["results"];
  ASSERT_EQ(results.size(), 4u);
  EXPECT_EQ(results[0]["ruleId"], "law-1");
  EXPECT_EQ(results[0]["level"], "error");
  EXPECT_EQ(results[1]["level"], "error") << "by luck";
  EXPECT_EQ(results[2]["level"], "note");
  EXPECT_EQ(results[0]["partialFingerprints"]["bucket/v1"], "intersect/law-1/side-rim");
  EXPECT_FALSE(results[0].contains("baselineState"));
  EXPECT_EQ(run["properties"]["seed"], std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(run["properties"]["versions"]["intersect"], "0.1.0");
}

TEST(GateSarif, WhatWasNotAskedIsNoSuccess) {
  const auto invocation = [](const JudgedGate& gate) {
    return parse_json(gate_sarif(gate, "0.1.0", false))["runs"][0]["invocations"][0];
  };
  EXPECT_EQ(invocation(example_gate())["executionSuccessful"], true);
  const json cut = invocation(cut_gate());
  EXPECT_EQ(cut["executionSuccessful"], false);
  ASSERT_EQ(cut["toolExecutionNotifications"].size(), 2u);
  EXPECT_EQ(cut["toolExecutionNotifications"][0]["message"]["text"],
            "Not asked: sample of all strata: 9 of 840 rounds, since the time was over");
  JudgedGate remarked;
  remarked.remarks = {{"x expired"}, {"y matches no case", exit_findings}, {"z abstains", exit_undecided}};
  const json remarks = invocation(remarked)["toolExecutionNotifications"];
  EXPECT_EQ(remarks[0]["level"], "warning");
  EXPECT_EQ(remarks[1]["level"], "error");
  EXPECT_EQ(remarks[2]["level"], "warning");
}

TEST(GateSarif, PlacesAreTheCaseElseTheLawFromTheTopOfTheSources) {
  const json results = parse_json(gate_sarif(example_gate(), "0.1.0", false))["runs"][0]["results"];
  const json& law = results[0]["locations"][0]["physicalLocation"];
  EXPECT_EQ(law["artifactLocation"]["uri"], "props/laws/exact_laws.cpp");
  EXPECT_EQ(law["region"]["startLine"], law_numbered(1).line);
  const json& kept = results[3]["locations"][0]["physicalLocation"];
  EXPECT_EQ(kept["artifactLocation"]["uri"], "corpus/cases/found.jsonl");
  EXPECT_EQ(kept["region"]["startLine"], 2);
}

TEST(GateSarif, PlacesOfAGuestAreItsOwnOrNone) {
  if (schema_python().empty()) SKIP_WITHOUT("python3-jsonschema");
  JudgedGate gate = example_gate();
  for (JudgedFailure& f : gate.failures) f.options = "--plugin mine=./libmine.so";
  const auto locations = [&](std::size_t i) {
    const std::string document = gate_sarif(gate, "0.1.0", false);
    EXPECT_TRUE(valid(document));
    return parse_json(document)["runs"][0]["results"][i]["locations"];
  };
  EXPECT_EQ(locations(0), json::array()) << "of a law";
  EXPECT_EQ(locations(3), json::array()) << "of a case";
  const std::string here = std::filesystem::current_path().string();
  for (JudgedFailure& f : gate.failures) f.at = source_line(here + "/src/mine.cpp:10");
  for (const std::size_t i : {std::size_t{0}, std::size_t{3}}) {
    const json place = locations(i)[0]["physicalLocation"];
    EXPECT_EQ(place["artifactLocation"]["uri"], "src/mine.cpp");
    EXPECT_EQ(place["region"]["startLine"], 10);
  }
}

TEST(GateSarif, OddFileNames) {
  JudgedGate gate = example_gate();
  const auto uri = [&](const std::string& origin) {
    gate.failures[3].origin = origin;
    return parse_json(gate_sarif(
        gate, "0.1.0",
        false))["runs"][0]["results"][3]["locations"][0]["physicalLocation"]["artifactLocation"]["uri"]
        .get<std::string>();
  };
  EXPECT_EQ(uri("a b:c%.jsonl:7 id:8 more"), "a%20b%3Ac%25.jsonl");
  EXPECT_EQ(uri("./cases/../x.jsonl:7"), "x.jsonl");
  EXPECT_EQ(uri("/no/such folder/x.jsonl:7 id"), "file:///no/such%20folder/x.jsonl");
  EXPECT_EQ(uri((std::filesystem::current_path() / "x.jsonl").string() + ":7 id"), "x.jsonl");
  EXPECT_EQ(uri("x.jsonl:0 id"), uri("no place")) << "lines count from 1: the law's place instead";
}

TEST(GateSarif, ASuppressedFailureHasItsReason) {
  JudgedGate gate = example_gate();
  gate.failures[0].known = true;
  gate.failures[0].suppressed = "thin rods";
  const json results = parse_json(gate_sarif(gate, "0.1.0", false))["runs"][0]["results"];
  EXPECT_EQ(results[0]["suppressions"],
            json::array({{{"kind", "external"}, {"justification", "thin rods"}}}));
  EXPECT_FALSE(results[1].contains("suppressions"));
}

TEST(GateSarif, SaysWhatIsNewWhereThereIsABase) {
  JudgedGate gate = example_gate();
  gate.failures[0].known = true;
  const json results = parse_json(gate_sarif(gate, "0.1.0", true))["runs"][0]["results"];
  EXPECT_EQ(results[0]["baselineState"], "unchanged");
  EXPECT_EQ(results[1]["baselineState"], "new");
  EXPECT_EQ(results[2]["baselineState"], "new") << "a note";
  gate.failures[2].in_base = 1;
  EXPECT_EQ(parse_json(gate_sarif(gate, "0.1.0", true))["runs"][0]["results"][2]["baselineState"],
            "unchanged");
}

}  // namespace
}  // namespace cyl
