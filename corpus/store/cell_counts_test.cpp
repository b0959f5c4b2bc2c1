// SPDX-License-Identifier: MIT
#include "corpus/store/cell_counts.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace cyl {
namespace {

constexpr std::uint64_t most = std::numeric_limits<std::uint64_t>::max();

TEST(CellCounts, AreWrittenShortAndReadBack) {
  const std::vector<CellCounts> counts{{12}, {12, 0, 3}, {}, {7, 1, 2, 3, most, 4, 5, 6}, {}, {}};
  const std::string text = format_cell_counts(counts);
  EXPECT_EQ(text, "12;12 0 3;;7 1 2 3 18446744073709551615 4 5 6");
  EXPECT_EQ(parse_cell_counts(text), std::vector<CellCounts>(counts.begin(), counts.begin() + 4));
  EXPECT_EQ(format_cell_counts({{}, {}}), "");
  EXPECT_EQ(format_cell_counts({{}, {1}}), ";1");
  EXPECT_EQ(parse_cell_counts(";1"), (std::vector<CellCounts>{{}, {1}}));
  EXPECT_TRUE(parse_cell_counts("").empty());
}

TEST(CellCounts, WhatIsNoneIsRefused) {
  for (const char* text : {"x", "1 ", "1 2 3 4 5 6 7 8 9", "1,2", "-1", "1 x;2", "99999999999999999999"})
    EXPECT_THROW(parse_cell_counts(text), std::runtime_error) << text;
}

TEST(CountAnswer, EachAnswerIsCountedOnce) {
  const auto counted = [](Status status, Verdict said, std::optional<FindingKind> kind,
                          Severity severity = Severity::contract) {
    MethodAnswer answer;
    answer.status = status;
    answer.verdict = said;
    std::optional<Finding> wrong;
    if (kind) wrong = Finding{*kind, severity, {}};
    CellCounts counts;
    count_answer(counts, answer, wrong);
    return counts;
  };
  using K = FindingKind;
  const auto answered = Status::answered;
  EXPECT_EQ(counted(answered, Verdict::disjoint, {}), (CellCounts{1, 0, 0, 0, 0}));
  EXPECT_EQ(counted(answered, Verdict::disjoint, K::wrong_disjoint), (CellCounts{1, 1, 0, 0, 0}));
  EXPECT_EQ(counted(answered, Verdict::touching, K::wrong_intersecting), (CellCounts{1, 0, 1, 0, 0}));
  EXPECT_EQ(counted(Status::failed, Verdict::undecided, K::crash), (CellCounts{1, 0, 0, 1, 0}));
  EXPECT_EQ(counted(answered, Verdict::disjoint, K::non_finite), (CellCounts{1, 0, 0, 1, 0}));
  EXPECT_EQ(counted(answered, Verdict::undecided, {}), (CellCounts{1, 0, 0, 0, 1}));
  EXPECT_EQ(counted(Status::declined, Verdict::undecided, {}), (CellCounts{1, 0, 0, 0, 0, 1}));
  const auto within = Severity::resolution;
  EXPECT_EQ(counted(answered, Verdict::disjoint, K::wrong_disjoint, within),
            (CellCounts{1, 1, 0, 0, 0, 0, 1, 0}));
  EXPECT_EQ(counted(answered, Verdict::touching, K::wrong_intersecting, within),
            (CellCounts{1, 0, 1, 0, 0, 0, 0, 1}));
  EXPECT_EQ(counted(answered, Verdict::invalid, K::wrong_invalid), (CellCounts{1, 0, 0, 0, 1}));
  for (const K kind : {K::distance_outside, K::bad_witness, K::wrong_touching, K::nondeterminism})
    EXPECT_EQ(counted(answered, Verdict::disjoint, kind), (CellCounts{1, 0, 0, 0, 0}));
}

TEST(CellTable, AddsRecordsOfUnequalLength) {
  CellTable table;
  table.add({"p", 1, 2, {{1, 1, 0, 0, 0}}});
  table.add({"o", 3, 2, {{9}}});
  table.add({"p", 1, 2, {{2, 0, 0, 1, 0}, {4, 0, 1, 0, 3}}});
  ++table.at("p", 1, 2, 3)[2].asked;
  const std::vector<CellRecord> wanted{{"o", 3, 2, {{9}}},
                                       {"p", 1, 2, {{3, 1, 0, 1, 0}, {4, 0, 1, 0, 3}, {1}}}};
  EXPECT_EQ(table.records(), wanted);
}

}  // namespace
}  // namespace cyl
