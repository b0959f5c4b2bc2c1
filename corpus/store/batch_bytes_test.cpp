// SPDX-License-Identifier: MIT
#include "corpus/store/batch_bytes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace cyl {
namespace {

TEST(BatchBytes, ComesBackAsItWent) {
  BatchRecord batch;
  batch.tallies = {{"m", "f", Counts{1, 2, 3, 4, 5, 6, ~0ull}}, {"n", "f", {}}};
  batch.groups = {{{"m", FindingKind::hang, Severity::contract, "f"}, 9, GroupRecord::no_binade}};
  FindingRecord f;
  f.index = ~0ull;
  f.family = "f";
  f.family_index = 8;
  f.method = "m";
  f.kind = FindingKind::hang;
  f.severity = Severity::contract;
  f.margin = Enclosure{5e-324, std::numeric_limits<double>::infinity()};
  f.pair = "{\"a\":\"\n\0x\"}";
  f.answers = "</script>";
  f.truth = "t";
  f.reason = "not UTF-8: \xff";
  batch.findings = {f, f, f};
  batch.findings[1].margin.reset();
  batch.findings[2].margin = Enclosure{std::numeric_limits<double>::quiet_NaN(), -0.0};
  batch.cells = {{"a-b", 0, 17, {{1}, {}, {1, 1}}}, {"c", 5, 6, {}}};

  const BatchRecord back = parse_batch(format_batch(batch));
  ASSERT_EQ(back.tallies.size(), 2u);
  EXPECT_EQ(back.tallies[0].counts.declined, 2u);
  EXPECT_EQ(back.tallies[0].counts.nanoseconds, ~0ull);
  ASSERT_EQ(back.groups.size(), 1u);
  EXPECT_EQ(back.groups[0].count, 9u);
  EXPECT_EQ(back.groups[0].binade, GroupRecord::no_binade);
  EXPECT_EQ(back.cells, batch.cells);
  ASSERT_EQ(back.findings.size(), 3u);
  EXPECT_EQ(back.findings[0].index, ~0ull);
  EXPECT_EQ(back.findings[0].family_index, 8u);
  EXPECT_EQ(back.findings[0].margin->lo, 5e-324);
  EXPECT_EQ(back.findings[0].margin->hi, std::numeric_limits<double>::infinity());
  EXPECT_FALSE(back.findings[1].margin);
  EXPECT_TRUE(std::isnan(back.findings[2].margin->lo));
  EXPECT_TRUE(std::signbit(back.findings[2].margin->hi));
  for (const FindingRecord& found : back.findings) {
    EXPECT_EQ(found.pair, f.pair);
    EXPECT_EQ(found.answers, f.answers);
    EXPECT_EQ(found.truth, "t");
    EXPECT_EQ(found.reason, "not UTF-8: \xef\xbf\xbd");
  }
}

TEST(BatchBytes, AFindingMoreOfOnePairCostsNoMoreAnswers) {
  BatchRecord one;
  one.findings.resize(1);
  one.findings[0].answers = std::string(100'000, 'x');
  BatchRecord many = one;
  many.findings.resize(50, one.findings[0]);
  EXPECT_LT(format_batch(many).size(), format_batch(one).size() + 50 * 300);
}

TEST(BatchBytes, OneThatIsCutIsRefused) {
  const std::string whole = format_batch({});
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_THROW(parse_batch(whole.substr(0, size)), std::runtime_error);
  }
}

TEST(BatchBytes, AWordThatIsNoKindIsRefused) {
  BatchRecord batch;
  batch.groups = {{{"m", FindingKind::hang, Severity::contract, "f"}, 9, 0}};
  std::string bytes = format_batch(batch);
  bytes.replace(bytes.find("hang"), 4, "bang");
  EXPECT_THROW(parse_batch(bytes), std::runtime_error);
}

}  // namespace
}  // namespace cyl
