// SPDX-License-Identifier: MIT
#include "reports/gate/gate_json.hpp"

#include <cmath>
#include <stdexcept>

#include "base/error_of_test.hpp"
#include "base/json.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "reports/gate/gate_example_test.hpp"

namespace cyl {
namespace {

using json = nlohmann::json;

TEST(GateJson, HasWhatWasAskedAndEachFailure) {
  const json all = parse_json(gate_json(example_gate()));
  EXPECT_EQ(all["seed"], std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(all["phases"][3], json({{"phase", "sample of all strata"},
                                    {"rounds", 831},
                                    {"pairs", 345678},
                                    {"milliseconds", 30040},
                                    {"digest", "0000000000000000"}}));
  EXPECT_EQ(all["pairs"], 350'000);
  EXPECT_EQ(all["laws"].size(), all_laws().size());
  EXPECT_EQ(all["not_asked"], json::array());
  EXPECT_EQ(parse_json(gate_json(cut_gate()))["not_asked"].size(), 2u);
  EXPECT_EQ(all["methods"][0]["counts"]["asked"], 1234567);
  const json& failure = all["failures"][1];
  EXPECT_EQ(failure["law"], 2);
  EXPECT_EQ(failure["severity"], "contract");
  EXPECT_EQ(failure["failed_again"], 3);
  EXPECT_EQ(failure["known"], false);
  EXPECT_EQ(all["failures"][3]["found"]["a"]["height"], "nan");
}

TEST(GateJson, PairsAreReadBackToTheBit) {
  const JudgedGate gate = example_gate();
  const json found = parse_json(gate_json(gate))["failures"][0]["found"];
  const CaseLine line = parse_case(found.dump(), 1);
  ASSERT_TRUE(line.value) << line.error;
  EXPECT_EQ(format_pair(line.value->pair), format_pair(gate.failures[0].found));
  EXPECT_TRUE(std::signbit(line.value->pair.b.center[1]));
}

TEST(GateJson, TheBaseComesBack) {
  const ScratchFile file(gate_json(example_gate()));
  const GateBase base = read_base(file.path);
  EXPECT_EQ(base.seed, example_gate().report.seed);
  EXPECT_EQ(base.pairs, example_gate().report.pairs);
  EXPECT_EQ(base.methods.size(), 2u);
  EXPECT_EQ(base.cases, (std::vector<std::string>{"0000000000000011", "0000000000000012"}));
  EXPECT_EQ(base.amount.cases_under_laws, 7u) << "not all of 12";
  EXPECT_EQ(base.amount.law_rounds, 9u);
  EXPECT_EQ(base.amount.sample_rounds, 831u);
  EXPECT_EQ(base.amount.close_law_rounds, 5u);
  EXPECT_EQ(base.amount.close_rounds, 70u);
  EXPECT_EQ(base.causes.size(), 3u) << "those beyond a claim";
  EXPECT_EQ(base.causes.at("intersect/law-1/side-rim"), 1234u);
}

TEST(GateJson, KnownIsWhatTheBaseHasOnAsManyPairs) {
  const auto known = [](const JudgedFailure& failure, const GateBase& base) {
    JudgedGate gate{{}, {failure}, {}};
    mark_known(gate, base);
    return gate.failures[0].known;
  };
  JudgedFailure f = example_failure("fake", 31, Severity::contract);
  GateBase base;
  EXPECT_FALSE(known(f, base));
  base.causes[f.cause] = f.count;
  EXPECT_TRUE(known(f, base));
  base.causes[f.cause] = f.count - 1;
  EXPECT_FALSE(known(f, base)) << "it has grown";
  f.failed_again = 3;
  EXPECT_TRUE(known(f, base)) << "by luck";
  f.failed_again = f.reruns;
  f.kind = "hang";
  EXPECT_TRUE(known(f, base)) << "a slower machine";
  f.cause.clear();
  base.causes[""] = f.count;
  EXPECT_FALSE(known(f, base)) << "without a cause nothing is known";
}

TEST(GateJson, WithinAClaimNothingIsExcusedButSaidToBeOld) {
  const ScratchFile file(gate_json(example_gate()));
  const GateBase base = read_base(file.path);
  EXPECT_EQ(base.within.size(), 1u);
  JudgedGate gate = example_gate();
  mark_known(gate, base);
  EXPECT_EQ(gate.failures[2].in_base, 1234u);
  EXPECT_FALSE(gate.failures[2].known);
  gate.failures[2].severity = Severity::contract;
  gate.failures[2].in_base = 0;
  mark_known(gate, base);
  EXPECT_FALSE(gate.failures[2].known) << "beyond the claim now";
  EXPECT_EQ(gate.failures[2].in_base, 0u);
}

TEST(GateJson, WhatTheBaseAskedAndThisGateDidNotIsSaid) {
  const JudgedGate gate = example_gate();
  const ScratchFile file(gate_json(gate));
  const auto gaps = [&](const JudgedGate& now, const std::string& file_of_base) {
    JudgedGate reported = now;
    note_gaps(reported, read_base(file_of_base));
    return reported.not_asked;
  };
  JudgedGate now = gate;
  now.report.cases = {18, 17, 19};
  // The name is as it is written. Bytes that are not UTF-8 do not survive that.
  now.report.methods[1].name = parse_json(gate_json(gate))["methods"][1]["name"];
  EXPECT_EQ(gaps(now, file.path), std::vector<std::string>{}) << "more cases, in another order";
  JudgedGate other = now;
  other.report.cases = {17, 19, 20};
  other.report.methods[0].name = "another";
  other.report.phases[3].digest = 1;
  other.report.phases[5].digest = 1;
  const ScratchFile lawless(replaced(gate_json(gate), "\"laws\": [\n", "\"laws\": [\n  999,\n"));
  EXPECT_EQ(gaps(other, lawless.path),
            (std::vector<std::string>{"method intersect, which the base has", "law 999, which the base has",
                                      "1 of 2 cases, which the base has",
                                      "sample of all strata: the pairs, which the base has",
                                      "sample of close contacts: the pairs, which the base has"}));
}

TEST(GateJson, AFailureOfTheBaseThatIsGoneIsSaid) {
  const JudgedGate gate = example_gate();
  const ScratchFile file(gate_json(gate));
  const auto remarks = [&](JudgedGate now) {
    const std::size_t before = now.remarks.size();
    now.report.methods[1].name = parse_json(gate_json(gate))["methods"][1]["name"];
    GateBase base = read_base(file.path);
    std::erase_if(base.causes, [](const auto& b) { return b.first.starts_with("fake"); });  // not UTF-8
    note_gaps(now, base);
    std::vector<std::string> said;
    for (std::size_t i = before; i < now.remarks.size(); ++i) said.push_back(now.remarks[i].text);
    return said;
  };
  JudgedGate now = gate;
  now.not_asked.clear();
  EXPECT_EQ(remarks(now), std::vector<std::string>{});
  const std::string cause = now.failures[0].cause;
  std::erase_if(now.failures, [&](const JudgedFailure& f) { return f.cause == cause; });
  EXPECT_EQ(remarks(now), std::vector<std::string>{"1 failure of the base is gone: " + cause});
  now.not_asked.push_back("a phase");
  EXPECT_EQ(remarks(now), std::vector<std::string>{}) << "perhaps it was not asked";
}

TEST(GateJson, BadBasesAreRefusedByName) {
  const std::string good = gate_json(example_gate());
  for (const std::string& bad :
       {std::string(), std::string("{"), std::string("[]"), std::string("{}"),
        std::string("{\"failures\":7}"), std::string("{\"failures\":[{}]}"),
        std::string("{\"failures\":[{\"cause\":7}]}"), std::string("{\"failures\":[7]}"),
        replaced(good, "\"seed\"", "\"seeds\""), replaced(good, "\"laws\": [\n", "\"laws\": [\n \"x\",\n"),
        replaced(good, "\"rounds\": 9", "\"rounds\": -1"), good.substr(0, good.size() / 2)}) {
    const ScratchFile file(bad);
    const std::string refused = error_of([&] { read_base(file.path); });
    EXPECT_NE(refused.find(file.path), std::string::npos) << refused << ": " << bad.substr(0, 40);
  }
  EXPECT_THROW(read_base("/no/such/file"), std::runtime_error);
  EXPECT_THROW(read_base(std::filesystem::temp_directory_path()), std::runtime_error);
}

}  // namespace
}  // namespace cyl
