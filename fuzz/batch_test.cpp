// SPDX-License-Identifier: MIT
#include "fuzz/batch.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace cyl {
namespace {

/// Apart by 2^-4298 of their size, less than the referee can see.
const Pair hair{{{0, 0, 0}, {0, 0, 1}, 1, 2}, {{-0x1p-1074, 2, 0}, {1, 0x1p-1074, 0}, 1, 2}};

/// Asked in disputes alone here, so that a pair nobody decides is judged twice.
class Costly : public Method {
 public:
  std::string_view name() const override { return "costly"; }
  std::string_view version() const override { return "1"; }
  Claim claim() const override { return {}; }
  bool foreign() const override { return true; }
  unsigned share() const override { return 100; }
  MethodAnswer ask(const Pair&) override {
    MethodAnswer answer;
    answer.status = Status::answered;
    answer.verdict = Verdict::disjoint;
    return answer;
  }
};

TEST(Batch, AnUndecidedPairIsCountedOnceAndWithItsTimeAtTheLastStage) {
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(std::make_unique<Costly>());
  const Family families[] = {{"hair", "", [](std::uint64_t, std::uint64_t) { return hair; }}};
  const BatchRecord batch =
      run_batch({methods, families, {}}, 1, 1, 3);  // no index the costly one is asked at
  std::map<std::string, Counts> rows;
  for (const TallyRecord& t : batch.tallies) rows[t.method] = t.counts;
  ASSERT_EQ(rows["costly"].asked, 2u);
  EXPECT_EQ(rows[referee_row].asked, 2u);
  EXPECT_EQ(rows[referee_row].undecided, 2u);
  EXPECT_FALSE(rows.contains("referee-filter"));
  EXPECT_FALSE(rows.contains("referee-wide"));
  EXPECT_EQ(rows["referee-exact"].asked, 2u);
  EXPECT_GT(rows["referee-exact"].nanoseconds, 0u);
  EXPECT_EQ(rows["referee-exact"].nanoseconds, rows[referee_row].nanoseconds);
}

TEST(IsMethodRow, KnowsTheOthersByTheirWholeNames) {
  for (const char* row : {"corpus", "referee", "referee-filter", "referee-wide", "referee-exact"})
    EXPECT_FALSE(is_method_row(row)) << row;
  for (const char* row : {"", "decide", "referee2", "referee-", "corpus1"})
    EXPECT_TRUE(is_method_row(row)) << row;
}

}  // namespace
}  // namespace cyl
