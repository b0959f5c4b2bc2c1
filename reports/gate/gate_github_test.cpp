// SPDX-License-Identifier: MIT
#include <sstream>

#include "reports/gate/gate_example_test.hpp"
#include "reports/gate/gate_writers.hpp"

namespace cyl {
namespace {

TEST(GateGithub, OneCommandALine) {
  std::istringstream lines(gate_github(example_gate()));
  std::size_t errors = 0;
  for (std::string line; std::getline(lines, line);) {
    errors += line.starts_with("::error file=");
    EXPECT_EQ(line.find('\r'), std::string::npos);
    const std::size_t end = line.find("::", 2);  // the end of the properties, which escape colons
    ASSERT_NE(end, std::string::npos);
    EXPECT_EQ(occurrences(line.substr(0, end), ","), 2u) << line;
    EXPECT_NE(line.find("| daylight replay - --methods "), std::string::npos) << line;
  }
  EXPECT_EQ(errors, 3u);
}

TEST(GateGithub, EscapesWhatCommandsReserve) {
  JudgedGate gate = example_gate();
  gate.failures = {gate.failures[0]};
  gate.failures[0].method = "m:1,50%";
  gate.failures[0].what = "50%, at: x\ny";
  const std::string text = gate_github(gate);
  EXPECT_NE(text.find("title=m%3A1%2C50%25 breaks law 1 "), std::string::npos) << text;
  EXPECT_NE(text.find("::50%25, at: x\\ny%0A1,234 pairs"), std::string::npos) << text;
  EXPECT_NE(text.find("::error file=props/laws/exact_laws.cpp,line="), std::string::npos) << text;
}

TEST(GateGithub, OfAGuestWhatItWasBuiltFromElseNoFile) {
  JudgedGate gate = example_gate();
  gate.failures = {gate.failures[3]};
  gate.failures[0].options = "--plugin mine=./libmine.so";
  EXPECT_TRUE(gate_github(gate).starts_with("::error title=")) << gate_github(gate);
  gate.failures[0].at = SourceLine{"src/mine.cpp", 10};
  EXPECT_TRUE(gate_github(gate).starts_with("::error file=src/mine.cpp,line=10,title=")) << gate_github(gate);
}

TEST(GateGithub, AtMostTenThenHowManyMore) {
  JudgedGate gate = example_gate();
  gate.failures.assign(annotations_cap + 4, example_failure("intersect", 1, Severity::contract));
  for (std::size_t i = 0; i < gate.failures.size(); ++i) gate.failures[i].kind = std::to_string(i);
  const std::string text = gate_github(gate);
  EXPECT_EQ(occurrences(text, "::error file="), annotations_cap);
  EXPECT_NE(text.find("::4 more that fail the gate"), std::string::npos);
  EXPECT_EQ(occurrences(text, " more "), 1u);
}

TEST(GateGithub, OneOfALawAndKind) {
  JudgedGate gate = example_gate();
  gate.failures.assign(3, example_failure("intersect", 1, Severity::contract));
  const std::string text = gate_github(gate);
  EXPECT_EQ(occurrences(text, "::error file="), 1u);
  EXPECT_NE(text.find("3,702 pairs"), std::string::npos) << text;
}

TEST(GateGithub, ARemarkThatFailsTheGateIsAnError) {
  JudgedGate gate;
  gate.remarks = {{"x expired"}, {"y matches no case", exit_findings}, {"z abstains", exit_undecided}};
  EXPECT_EQ(gate_github(gate),
            "::notice title=daylight gate::x expired\n"
            "::error title=daylight gate::y matches no case\n"
            "::warning title=daylight gate::z abstains\n");
}

TEST(GateGithub, WarnsOfWhatWasNotAsked) {
  const std::string text = gate_github(cut_gate());
  EXPECT_EQ(occurrences(text, "\n"), 2u) << text;
  EXPECT_TRUE(
      text.starts_with("::warning title=daylight gate, not asked::sample of all strata: 9 of 840 rounds"));
}

TEST(GateGithub, KnownIsNotShown) {
  JudgedGate gate = example_gate();
  gate.failures = {gate.failures[0]};
  gate.failures[0].known = true;
  EXPECT_EQ(gate_github(gate), "");
}

}  // namespace
}  // namespace cyl
