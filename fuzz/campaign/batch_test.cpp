// SPDX-License-Identifier: MIT
#include "fuzz/campaign/batch.hpp"

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

/// Wrong of every pair that is apart; where it has a memory, of every other call.
class Wrong : public Costly {
 public:
  explicit Wrong(bool memory) : memory_(memory) {}
  std::string_view name() const override { return "wrong"; }
  bool foreign() const override { return false; }
  unsigned share() const override { return 1; }
  MethodAnswer ask(const Pair& pair) override {
    MethodAnswer answer = Costly::ask(pair);
    if (!memory_ || ++calls_ % 2 == 0) answer.verdict = Verdict::intersecting;
    return answer;
  }

 private:
  bool memory_;
  int calls_ = 0;
};

const Family apart[] = {{"apart", "", [](std::uint64_t, std::uint64_t index) {
                           const double far = 3 + static_cast<double>(index);
                           return Pair{{{0, 0, 0}, {0, 0, 1}, 1, 2}, {{far, 0, 0}, {0, 0, 1}, 1, 2}};
                         }}};

TEST(Batch, AWrongVerdictIsNotedAndTheCostlyAreAsked) {
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(std::make_unique<Costly>());
  methods.push_back(std::make_unique<Wrong>(false));
  const BatchRecord batch = run_batch({methods, apart, {}}, 1, 1, 3);
  ASSERT_EQ(batch.findings.size(), 2u);
  EXPECT_EQ(batch.findings[0].kind, "wrong_intersecting");
  std::uint64_t asked = 0;
  for (const TallyRecord& t : batch.tallies) asked += t.method == "costly" ? t.counts.asked : 0;
  EXPECT_EQ(asked, 2u);
}

TEST(Batch, AMemoryIsNoted) {
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(std::make_unique<Wrong>(true));
  bool noted = false;
  for (const FindingRecord& f : run_batch({methods, apart, {}}, 1, 0, 2 * repeat_share + 1).findings)
    noted = noted || f.kind == "nondeterminism";
  EXPECT_TRUE(noted);
}

TEST(IsMethodRow, KnowsTheOthersByTheirWholeNames) {
  for (const char* row : {"corpus", "referee", "referee-filter", "referee-wide", "referee-exact"})
    EXPECT_FALSE(is_method_row(row)) << row;
  for (const char* row : {"", "decide", "referee2", "referee-", "corpus1"})
    EXPECT_TRUE(is_method_row(row)) << row;
}

}  // namespace
}  // namespace cyl
