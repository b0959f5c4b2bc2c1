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
