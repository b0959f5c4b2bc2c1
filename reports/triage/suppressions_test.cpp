// SPDX-License-Identifier: MIT
#include "reports/triage/suppressions.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/exit_code.hpp"
#include "base/usage_error.hpp"
#include "oracles/trial/algorithm_groups.hpp"
#include "props/laws/laws_test.hpp"

namespace cyl {
namespace {

const std::string good_line =
    R"({"cause":"fcl-libccd/hang","reason":"reported","link":"https://example.org/1",)"
    R"("owner":"ada","expires":"2027-02-28"})";

std::vector<Suppression> read(const std::string& text) {
  std::istringstream in(text);
  return read_suppressions(in);
}

std::string error_of(const std::string& text) {
  try {
    read(text);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "none";
}

/// Returns good_line with the first `from` replaced.
std::string with(const std::string& from, const std::string& to) {
  std::string text = good_line;
  return text.replace(text.find(from), from.size(), to);
}

TEST(Suppressions, ReadsEveryField) {
  const auto all = read("\n" + good_line + "\r\n");
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].cause, "fcl-libccd/hang");
  EXPECT_EQ(all[0].reason, "reported");
  EXPECT_EQ(all[0].link, "https://example.org/1");
  EXPECT_EQ(all[0].owner, "ada");
  EXPECT_EQ(all[0].expires, "2027-02-28");
  EXPECT_EQ(all[0].line, 2u);
}

TEST(Suppressions, NamesLineAndColumnOfWhatIsWrong) {
  EXPECT_EQ(error_of(good_line + "\n{\"cause\":]"), "line 2, column 10: no JSON");
  EXPECT_EQ(error_of("[]"), "line 1, column 1: no object");
  EXPECT_EQ(error_of(with("\"owner\"", "\"boss\"")), "line 1, column 79: 'boss' is not a field");
  EXPECT_EQ(error_of(with("\"ada\"", "7")), "line 1, column 87: owner is not a text");
  EXPECT_EQ(error_of(with(",\"owner\":\"ada\"", "")), "line 1, column 1: owner is missing");
  EXPECT_EQ(error_of(with("2027-02-28", "2027-02-29")),
            "line 1, column 103: expires is not a day YYYY-MM-DD");
  EXPECT_EQ(error_of(with("2027-02-28", "27-2-28")), "line 1, column 103: expires is not a day YYYY-MM-DD");
  EXPECT_EQ(error_of(good_line + "\n" + good_line), "line 2, column 10: the cause has line 1 already");
}

TEST(Suppressions, HoldToTheEndOfTheirLastDay) {
  const auto all = read(good_line);
  EXPECT_FALSE(is_expired(all[0], "2027-02-28"));
  EXPECT_TRUE(is_expired(all[0], "2027-03-01"));
  EXPECT_EQ(find_suppression(all, "fcl-libccd/hang", "2026-12-31"), &all[0]);
  EXPECT_EQ(find_suppression(all, "fcl-libccd/hang", "2027-03-01"), nullptr);
  EXPECT_EQ(find_suppression(all, "fcl-libccd", "2026-12-31"), nullptr);
}

TEST(Suppressions, OfAFileThatIsNotThereAreNone) {
  EXPECT_TRUE(read_suppressions(std::nullopt, "no-such-file.jsonl").empty());
  EXPECT_TRUE(read_suppressions("", "no-such-file.jsonl").empty());
  EXPECT_THROW(read_suppressions("no-such-file.jsonl", ""), UsageError);
}

TEST(Suppressed, AFailureIsKnownByItsCauseWhateverItsSentenceSays) {
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(std::make_unique<Planted>([](const Pair& pair) {
    if (pair.b.center.x() == 5 * pair.a.radius) std::abort();
    return answered(Verdict::disjoint);
  }));
  JudgedGate gate;
  JudgedFailure& crash = gate.failures.emplace_back();
  crash.method = "planted";
  crash.law = &law_numbered(answer_law);
  crash.kind = "crash";
  crash.reason = "SIGABRT";
  crash.found = crash.simplest = Pair{{{0, 0, 0}, {0, 0, 1}, 1, 2}, {{5, 0, 0}, {0, 0, 1}, 1, 2}};
  const std::string cause = "planted/crash/sigabrt";
  for (const char* what : {"crash: SIGABRT", "crash, margin 0.25: SIGABRT"}) {
    crash.what = what;
    for (const bool same : {true, false}) {
      crash.known = false;
      const Suppression suppression{same ? cause : cause + "-elsewhere", "r", "-", "ada", "2999-12-31", 1};
      judge_suppressions(gate, methods, {}, {suppression}, "2026-01-01");
      EXPECT_EQ(crash.known, same) << what;
    }
  }
}

TEST(Suppressed, ALawIsKnownByTheCauseOfEveryWrongAnswerThatItCompares) {
  std::vector<std::unique_ptr<Method>> methods;
  // Its distances of parallel solids are 1 % too large, and it calls solids at a height of 9 apart.
  methods.push_back(std::make_unique<Planted>([](const Pair& pair) {
    MethodAnswer said = ask_ours("distance", pair);
    said.witness = CertificateKind::none;
    if (pair.a.axis == pair.b.axis) said.distance *= 1.01;
    return pair.a.height == 9 ? answered(Verdict::disjoint) : said;
  }));
  const Pair apart{{{0, 0, 0}, {0, 0, 1}, 1, 2}, {{5, 0, 0}, {0, 0, 1}, 1, 2}};
  const Pair meeting{{{0, 0, 0}, {0, 0, 1}, 1, 9}, {{1.5, 0, 0}, {0, 0, 1}, 1, 9}};
  struct Expected {
    int law;
    Pair pair;
    const char* causes;  ///< if these are suppressed, the law is known
  };
  constexpr const char *distance = "distance_outside", *verdict = "wrong_disjoint";
  for (const auto& [law, pair, cause] :
       {Expected{33, apart, distance}, Expected{22, apart, distance}, Expected{24, apart, distance},
        Expected{31, meeting, verdict}, Expected{22, meeting, nullptr}, Expected{35, apart, nullptr}}) {
    JudgedGate gate;
    JudgedFailure& failure = gate.failures.emplace_back();
    failure.method = "planted";
    failure.law = &law_numbered(law);
    failure.kind = law == verdict_law ? verdict : failure.law->name;
    failure.found = failure.simplest = pair;
    for (const char* suppressed : {distance, verdict}) {
      failure.known = false;
      const Suppression s{std::string("planted/") + suppressed, "r", "-", "ada", "2999-12-31", 1};
      judge_suppressions(gate, methods, {}, {s}, "2026-01-01");
      EXPECT_EQ(failure.known, suppressed == cause) << law << ' ' << suppressed;
    }
  }
}

TEST(Suppressed, OnlyMethodsOfANamedLibraryAreAsked) {
  std::array<std::size_t, 3> calls{};
  std::vector<std::unique_ptr<Method>> methods;
  for (const char* name : {"mine", "yours-fast", "own-like"}) {
    std::size_t& called = calls[methods.size()];
    methods.push_back(fake_method(name,
                                  [&called](const Pair&) { return ++called, answered(Verdict::disjoint); },
                                  {.is_out_of_process = true}));
  }
  Case stored;
  stored.pair = Pair{{{0, 0, 0}, {0, 0, 1}, 1, 2}, {{1, 0, 0}, {0, 0, 1}, 1, 2}};
  const Suppression wrong{"yours-fast/wrong_disjoint", "r", "-", "ada", "2999-12-31", 1};
  JudgedGate gate;
  for (const char* method : {"mine", "yours-fast"}) {
    JudgedFailure& failure = gate.failures.emplace_back();
    failure.method = method;
    failure.law = &law_numbered(verdict_law);
    failure.kind = "wrong_disjoint";
    failure.found = failure.simplest = stored.pair;
  }
  judge_suppressions(gate, methods, {&stored, 1}, {wrong}, "2026-01-01");
  EXPECT_TRUE(gate.remarks.empty()) << gate.remarks.front().text;
  EXPECT_FALSE(gate.failures[0].known);
  EXPECT_TRUE(gate.failures[1].known);
  EXPECT_EQ(calls[0] + calls[2], 0u);
  EXPECT_GT(calls[1], 0u);
}

TEST(Suppressed, RemarksNameWhatHasExpiredAndWhatNoCaseShows) {
  const std::vector<Suppression> all{{"x", "r", "l", "ada", "2026-11-20", 1},
                                     {"y", "r", "l", "ada", "2027-01-01", 2}};
  const auto remarks = suppression_remarks(all, "2026-11-22", {"x"});
  ASSERT_EQ(remarks.size(), 2u);
  EXPECT_EQ(remarks[0].text, "the suppression of x (line 1) expired on 2026-11-20; its owner is ada");
  EXPECT_EQ(remarks[0].exit_code, exit_pass);
  EXPECT_TRUE(remarks[1].text.starts_with("the suppression of y (line 2) matches no stored case"));
  EXPECT_EQ(remarks[1].exit_code, exit_findings);
  JudgedGate gate;
  EXPECT_EQ(exit_code(gate), exit_pass);
  gate.remarks = remarks;
  EXPECT_EQ(exit_code(gate), exit_findings);
  gate.remarks = {{"x", exit_undecided}};
  EXPECT_EQ(exit_code(gate), exit_undecided);
}

}  // namespace
}  // namespace cyl
