// SPDX-License-Identifier: MIT
#include <cstdlib>

#include "reports/gate/gate_example_test.hpp"
#include "reports/gate/gate_writers.hpp"

namespace cyl {
namespace {

/// Whether a shell command succeeds, its own words kept off the terminal.
bool succeeds(const std::string& command) {
  return std::system(("(" + command + ") >/dev/null 2>&1").c_str()) == 0;
}

bool valid(const std::string& document) {
  const ScratchFile file(document);
  return succeeds("xmllint --noout --nonet --schema '" DAYLIGHT_SOURCE_DIR "/reports/schemas/junit.xsd' '" +
                  file.path.string() + "'");
}

TEST(GateJunit, KeepsToItsSchema) {
  if (!succeeds("xmllint --version")) {
    if (const char* ci = std::getenv("CI"); ci && ci == std::string("true"))
      FAIL() << "with CI=true nothing may be skipped: apt-get install libxml2-utils";
    GTEST_SKIP() << "apt-get install libxml2-utils";
  }
  const std::string document = gate_junit(example_gate());
  EXPECT_TRUE(valid(document)) << document;
  EXPECT_TRUE(valid(gate_junit({})));
  EXPECT_TRUE(valid(gate_junit(cut_gate())));
  EXPECT_FALSE(valid(replaced(document, "<testcase ", "<testcase colour=\"red\" ")));
  EXPECT_FALSE(valid(replaced(document, " failures=", " mistakes=")));
  EXPECT_FALSE(valid(replaced(document, "&lt;a b=", "<a b=")));
  EXPECT_FALSE(valid(replaced(document, "said disjoint", "said \x01")));
}

TEST(GateJunit, OneTestALawAndOneACaseThatFailed) {
  const std::string document = gate_junit(example_gate());
  const std::size_t laws = all_laws().size();
  EXPECT_EQ(occurrences(document, "<testsuite "), 2u);
  EXPECT_EQ(occurrences(document, "<testcase "), 2 * laws + 1);
  EXPECT_EQ(occurrences(document, "<failure "), 4u) << "law 1, law 2 by luck, law 30, and its case";
  EXPECT_NE(document.find("failures=\"4\" errors=\"0\" time=\"32.690\""), std::string::npos);
  EXPECT_NE(document.find("name=\"case corpus/cases/found.jsonl:2 fuzz"), std::string::npos);
  EXPECT_NE(document.find("name=\"seed\" value=\"18446744073709551615\""), std::string::npos);
}

TEST(GateJunit, OfAGuestNoPathOfOurs) {
  JudgedGate gate = example_gate();
  JudgedFailure& f = gate.failures[3];
  f.origin = DAYLIGHT_SOURCE_DIR "/corpus/cases/found.jsonl:2 fuzz";
  f.options = "--plugin mine=./libmine.so";
  EXPECT_NE(gate_junit(gate).find("name=\"case daylight's corpus/cases/found.jsonl:2 fuzz\""),
            std::string::npos);
}

TEST(GateJunit, WhatWasNotAskedIsAnError) {
  const std::string document = gate_junit(cut_gate());
  EXPECT_EQ(occurrences(document, "<testsuite "), 3u);
  EXPECT_EQ(occurrences(document, "<error "), 2u);
  EXPECT_EQ(occurrences(document, "errors=\"2\""), 2u) << "of the suite and of all";
  EXPECT_NE(document.find("message=\"not asked: sample of all strata: 9 of 840 rounds"), std::string::npos);
}

TEST(GateJunit, ADoubtIsAnError) {
  JudgedGate gate;
  gate.remarks = {{"x is gone"}, {"z abstains", exit_undecided}};
  const std::string document = gate_junit(gate);
  EXPECT_EQ(occurrences(document, "errors=\"1\""), 2u) << "of the suite and of all";
  EXPECT_NE(document.find("<error type=\"undecided\" message=\"z abstains\""), std::string::npos);
}

TEST(GateJunit, WithinTheClaimOrKnownIsNoFailure) {
  JudgedGate gate = example_gate();
  const std::string before = gate_junit(gate);
  const std::size_t out = before.find("<system-out>");
  ASSERT_NE(out, std::string::npos);
  EXPECT_NE(before.find("within its claim, law 3 ", out), std::string::npos);
  for (JudgedFailure& f : gate.failures) f.known = true;
  const std::string after = gate_junit(gate);
  EXPECT_EQ(occurrences(after, "<failure "), 0u);
  EXPECT_NE(after.find("known, law 1 "), std::string::npos);
}

}  // namespace
}  // namespace cyl
