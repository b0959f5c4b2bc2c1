// SPDX-License-Identifier: MIT
#include <tuple>

#include "base/safe_text.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "reports/gate/failure_text.hpp"
#include "reports/gate/gate_example_test.hpp"
#include "reports/gate/gate_writers.hpp"

namespace cyl {
namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(GateText, ReportsEachMethod) {
  const std::string text = gate_text(example_gate());
  EXPECT_TRUE(has(text, "1,234,567"));
  EXPECT_TRUE(has(text, "claims to be right if |distance| is at least 1e-13 of the size (derived bound)"));
  EXPECT_TRUE(has(text, "at least a length of 1e-06")) << text;
  EXPECT_TRUE(has(text, "answers intersecting to every pair"));
  EXPECT_TRUE(has(gate_text(judged(example_gate().report)), "the referee could not decide 3 pairs."));
}

TEST(GateText, ReportsWhatFailedAndHowToSeeItAgain) {
  const JudgedGate gate = example_gate();
  const std::string text = gate_text(gate);
  EXPECT_TRUE(has(text, "Fails the gate (3)"));
  EXPECT_TRUE(has(text, "intersect breaks law 1 " + std::string(law_numbered(1).name) +
                            " on 1,234 pairs: said disjoint"));
  EXPECT_TRUE(has(text, "side-rim 1e-09, seed 1, index 17"));
  EXPECT_TRUE(has(text, "fails 10 of 10 times"));
  EXPECT_TRUE(has(text, "fails 3 of 10 times, not deterministically"));
  EXPECT_TRUE(has(text, "echo '" + format_pair(gate.failures[0].simplest) +
                            "' | daylight replay - --methods intersect --laws 1"));
  EXPECT_TRUE(has(text, "Does not fail the gate: known, or within the claim (1):"));
}

TEST(GateText, ReportsOneKindOfFailureOnce) {
  JudgedGate gate = example_gate();
  JudgedFailure elsewhere = gate.failures[0];
  elsewhere.cause = "intersect/law-1/rim-rim";
  elsewhere.count = 740;
  elsewhere.in_base = 1;
  gate.failures.push_back(elsewhere);
  const std::string text = gate_text(gate);
  EXPECT_TRUE(has(text, "Fails the gate (3)"));
  EXPECT_EQ(occurrences(text, "intersect breaks law 1 "), 1u);
  EXPECT_TRUE(has(text, " on 1,974 pairs: said disjoint"));
  EXPECT_TRUE(has(text, "also       intersect/law-1/rim-rim, 740 pairs, 1 in the base"));
}

TEST(GateText, OfALawTheNewAndThenTheWorstComesFirst) {
  JudgedGate gate = example_gate();
  gate.failures.resize(1);
  for (const auto& [what, in_base, excess] :
       {std::tuple("old", 1u, 0.9), {"slight", 0u, 0.1}, {"worst", 0u, 0.5}}) {
    JudgedFailure& f = gate.failures.emplace_back(gate.failures[0]);
    f.what = what;
    f.in_base = in_base;
    f.excess = excess;
  }
  const Alike alike = alike_failures(gate, true).at(0);
  EXPECT_EQ(alike.at(0)->what, "worst");
  EXPECT_EQ(alike.at(1)->what, "slight");
  EXPECT_EQ(alike.back()->what, "old");
}

TEST(GateText, CountsWrongVerdictsOfAllCells) {
  GateMethod m = example_gate().report.methods[1];
  m.name = "fake";
  const auto unclaimed = std::ranges::find(m.close_cells, false, &CloseGateCell::claimed);
  ASSERT_NE(unclaimed, m.close_cells.end());
  const VerdictCount before = close_contacts_of(m);
  unclaimed->wrong_gaps = 1;
  EXPECT_EQ(close_contacts_of(m).wrong, before.wrong + 1);
  EXPECT_TRUE(has(proved_in_words(m), fmt::format("wrong beyond its claim on {} of {} close contacts",
                                                  before.wrong + 1, grouped(before.pairs))))
      << proved_in_words(m);
}

TEST(GateText, OneCrashIsOneWayToFail) {
  JudgedGate gate = example_gate();
  const auto crash = [](int law, const char* reason) {
    JudgedFailure f = example_failure("intersect", law, Severity::contract);
    f.failed = FindingKind::crash;
    f.reason = reason;
    return f;
  };
  gate.failures = {crash(1, "SIGSEGV"), crash(30, "SIGSEGV"), crash(10, "SIGSEGV"), crash(22, "SIGABRT"),
                   example_failure("intersect", 10, Severity::contract)};
  const std::string text = gate_text(gate);
  EXPECT_NE(text.find("\nFails the gate (3):\n1. intersect breaks law 30 "), std::string::npos) << text;
  EXPECT_NE(text.find("3,702 pairs"), std::string::npos) << text;
}

TEST(GateText, FurtherCausesAreCapped) {
  JudgedGate gate = example_gate();
  gate.failures.assign(also_cap + 4, gate.failures[0]);
  const std::string text = gate_text(gate);
  EXPECT_EQ(occurrences(text, "   also "), also_cap);
  EXPECT_TRUE(has(text, " 3 more causes, which --json FILE lists"));
  gate.failures.pop_back();
  gate.failures.pop_back();
  EXPECT_TRUE(has(gate_text(gate), " 1 more cause, which --json FILE lists"));
}

TEST(GateText, KnownFailuresDoNotFail) {
  JudgedGate gate = example_gate();
  for (JudgedFailure& f : gate.failures) f.known = true;
  const std::string text = gate_text(gate);
  EXPECT_TRUE(has(text, "Nothing fails the gate."));
  EXPECT_TRUE(has(text, "(known)"));
}

TEST(GateText, ReportsWhatWasNotAsked) {
  const std::string text = gate_text(cut_gate());
  EXPECT_TRUE(has(text, "NOT ASKED: sample of all strata: 9 of 840 rounds, since the time was over\n"));
  EXPECT_TRUE(has(text, "Nothing that was asked fails the gate."));
  EXPECT_FALSE(has(text, "Nothing fails the gate."));
}

TEST(GateText, BriefOnesAreCapped) {
  JudgedGate gate = example_gate();
  gate.failures.assign(brief_cap + 5, example_failure("intersect", 3, Severity::resolution));
  for (std::size_t i = 0; i < gate.failures.size(); ++i) gate.failures[i].kind = std::to_string(i);
  const std::string text = gate_text(gate);
  EXPECT_TRUE(has(text, "and 5 more"));
  EXPECT_EQ(occurrences(text, "said disjoint"), brief_cap);
}

TEST(GateText, StatesWhatIsProvedOneFactALine) {
  const JudgedGate gate = example_gate();
  EXPECT_EQ(
      proved_in_words(gate.report.methods[0]),
      "The verdict of intersect is right on all 57,732 independent random pairs whose margin exceeds its\n"
      "  claim.\n"
      "  The error rate is <= 5.2e-05 overall and <= 1.3e-03 in each of 24 combinations of contact feature\n"
      "  and decade of margin, at 95 % confidence.\n"
      "The verdict of intersect is never wrong beyond its claim on 117,251 close contacts.\n"
      "  The error rate is <= 2.5e-01 in each of 144 combinations of axis position, angle and margin, for\n"
      "  gaps and for overlaps, at 95 % confidence.\n");
  GateMethod other = gate.report.methods[1];
  other.name = "fake";
  const std::string fake = proved_in_words(other);
  EXPECT_TRUE(has(fake,
                  "The verdict of fake is wrong beyond its claim on 7 of 250 independent random pairs whose "
                  "margin\n  exceeds its claim.\n"))
      << fake;
  EXPECT_EQ(occurrences(fake, "  No pair was decided in 1 combination.\n"), 2u) << fake;
  EXPECT_TRUE(has(fake, "The verdict of fake is wrong beyond its claim on 3 of 27,170 close contacts.\n"))
      << fake;
  EXPECT_TRUE(has(fake, "  It is undecided on 288 more.\n")) << fake;
}

TEST(GateText, ProvesNothingFromKeptCasesAndLawsOrUndecidedPairs) {
  GateMethod m = example_gate().report.methods[0];
  for (GateCell& c : m.cells) c.undecided = c.pairs, c.pairs = 0;
  for (CloseGateCell& c : m.close_cells) c.undecided = c.gaps, c.gaps = c.overlaps = 0;
  EXPECT_TRUE(has(proved_in_words(m), "\nintersect is undecided on all close contacts.\n"))
      << proved_in_words(m);
  const std::string nothing =
      "Nothing is proved of intersect: it decided no random pair whose margin exceeds its claim.\n";
  EXPECT_TRUE(has(proved_in_words(m), nothing)) << proved_in_words(m);
  EXPECT_TRUE(has(proved_in_words(m), "\n  It is undecided on 57,732 more.\n")) << proved_in_words(m);
  m.cells.clear();
  EXPECT_EQ(m.counts.asked, 1234567u);
  EXPECT_TRUE(has(proved_in_words(m), nothing)) << proved_in_words(m);
}

TEST(GateText, ACombinationThatIsAlwaysWrongHasARate) {
  GateMethod m = example_gate().report.methods[0];
  m.close_cells.clear();
  m.cells.resize(1);
  m.cells[0] = {{ContactFeature::side_side, 3}, true, 64, 64, 0};
  EXPECT_TRUE(has(proved_in_words(m), "<= 1.0e+00 overall and <= 1.0e+00 in each of 1 combination"))
      << proved_in_words(m);
  m.cells[0].pairs = m.cells[0].wrong = 2;
  EXPECT_TRUE(has(proved_in_words(m), "unknown in some combinations")) << proved_in_words(m);
}

TEST(GateText, RoundedSolidsHaveALine) {
  GateMethod m = example_gate().report.methods[0];
  m.cells.clear();
  m.close_cells.clear();
  m.rounded = {300, 0, 5};
  EXPECT_EQ(proved_in_words(m),
            "The verdict of intersect is never wrong beyond its claim on 300 pairs with a sphere, capsule,\n"
            "  rounded cylinder, half-space or box.\n"
            "  It is undecided on 5 more.\n");
  m.by_kinds[0] = {200, 0, 5};
  EXPECT_TRUE(has(proved_in_words(m), "<= 1.0e-02 overall and <= 1.5e-02 in each of 1 combination of shapes"))
      << proved_in_words(m);
  m.rounded.wrong = 2;
  EXPECT_TRUE(
      has(proved_in_words(m), "The verdict of intersect is wrong beyond its claim on 2 of 300 pairs with a "))
      << "wrong";
}

TEST(GateText, EndsWithWhatIsProvedAndSteersNoTerminal) {
  JudgedGate gate = example_gate();
  gate.report.methods.pop_back();
  std::string proved = proved_in_words(gate.report.methods[0]), text = gate_text(gate);
  const auto without_blanks = [](std::string s) {
    std::erase_if(s, [](char c) { return c == ' ' || c == '\n'; });
    return s;
  };
  EXPECT_TRUE(without_blanks(text).ends_with(without_blanks(proved)));
  text = gate_text(example_gate());
  for (const char c : text) EXPECT_TRUE(c == '\n' || static_cast<unsigned char>(c) >= 0x20);
  EXPECT_FALSE(has(text, "\xff")) << "not UTF-8";
  EXPECT_FALSE(has(text, "\xe2\x80\xae"));
}

}  // namespace
}  // namespace cyl
