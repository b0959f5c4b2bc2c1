// SPDX-License-Identifier: MIT
#include "fuzz/campaign/batch.hpp"

#include <gtest/gtest.h>
#include <malloc.h>

#include <map>
#include <stdexcept>
#include <string>

#include "corpus/pairs/families.hpp"
#include "oracles/methods/fake_method_test.hpp"

namespace cyl {
namespace {

/// Apart by 2^-4298 of their size, less than the referee can see.
const Pair hair{{{0, 0, 0}, {0, 0, 1}, 1, 2}, {{-0x1p-1074, 2, 0}, {1, 0x1p-1074, 0}, 1, 2}};

/// Asked only in disputes here, so that a pair without a proof is judged twice.
std::unique_ptr<Method> costly() {
  return fake_method("costly", [](const Pair&) { return answered(Verdict::disjoint); }, {.share = 100});
}

TEST(Batch, AnUndecidedPairIsCountedOnceAndWithItsTimeAtTheLastStage) {
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(costly());
  const Family families[] = {{"hair", "", [](std::uint64_t, std::uint64_t) { return hair; }}};
  const BatchRecord batch =
      batch_maker({methods, families, {}}, 1)(1, 3);  // no index the costly one is asked at
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

/// Wrong for every pair that is apart. With a memory, it is wrong for every other call.
std::unique_ptr<Method> wrong(bool memory) {
  const auto ask = [memory, calls = 0](const Pair&) mutable {
    return answered(!memory || ++calls % 2 == 0 ? Verdict::intersecting : Verdict::disjoint);
  };
  return fake_method("wrong", ask, {.foreign = false});
}

const Family apart[] = {{"apart", "", [](std::uint64_t, std::uint64_t index) {
                           const double far = 3 + static_cast<double>(index);
                           return Pair{{{0, 0, 0}, {0, 0, 1}, 1, 2}, {{far, 0, 0}, {0, 0, 1}, 1, 2}};
                         }}};

TEST(Batch, AJobHoldsNoMoreMemoryAfterManyBatches) {
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(wrong(false));
  const Workload workload{methods, apart, {}};
  const auto make = batch_maker(workload, 1);
  constexpr std::uint64_t filled = 10, batches = 80;
  const auto in_use_after = [&](std::uint64_t first, std::uint64_t next) {
    for (std::uint64_t i = first; i < next; ++i) make(1 + i * batch_size, 1 + (i + 1) * batch_size);
    return mallinfo2().uordblks;
  };
  const std::size_t then = in_use_after(0, filled);
  EXPECT_LT(in_use_after(filled, batches), then + (1u << 16));
}

TEST(Batch, AWrongVerdictIsNotedAndTheCostlyAreAsked) {
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(costly());
  methods.push_back(wrong(false));
  const BatchRecord batch = batch_maker({methods, apart, {}}, 1)(1, 3);
  ASSERT_EQ(batch.findings.size(), 2u);
  EXPECT_EQ(batch.findings[0].kind, FindingKind::wrong_intersecting);
  std::uint64_t asked = 0;
  for (const TallyRecord& t : batch.tallies) asked += t.method == "costly" ? t.counts.asked : 0;
  EXPECT_EQ(asked, 2u);
}

TEST(Batch, AMemoryIsNoted) {
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(wrong(true));
  const BatchRecord batch = batch_maker({methods, apart, {}}, 1)(0, 2 * repeat_share + 1);
  EXPECT_GT(std::ranges::count(batch.findings, FindingKind::nondeterminism, &FindingRecord::kind), 0);
}

/// A failure after many questions that does not recur alone keeps its words, and is not counted as wrong.
TEST(Batch, AStateThatBreaksIsNamed) {
  std::vector<std::unique_ptr<Method>> methods;
  const auto ask = [calls = 0](const Pair&) mutable {
    if (++calls == 3) throw std::runtime_error("x.c:34: the cache is stale");
    return answered(Verdict::disjoint);
  };
  methods.push_back(fake_method("stateful", ask, {.foreign = true}));
  const BatchRecord batch = batch_maker({methods, apart, {}}, 1)(0, 4);
  ASSERT_EQ(batch.findings.size(), 1u);
  EXPECT_EQ(batch.findings[0].kind, FindingKind::state_dependent);
  EXPECT_EQ(batch.findings[0].reason,
            "exception: x.c:34: the cache is stale; after indices 0 to 2, not alone");
  EXPECT_EQ(batch.tallies[0].counts.failed, 1u);
  EXPECT_EQ(batch.tallies[0].counts.contract, 0u);
}

/// Every second pair would be of the first family alone.
TEST(Batch, AShareMeetsEveryFamily) {
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(
      fake_method("slow", [](const Pair&) { return answered(Verdict::disjoint); }, {.share = 2}));
  const Family two[] = {apart[0], {"other", "", apart[0].generate}};
  std::map<std::string, std::uint64_t> asked;
  for (const TallyRecord& t : batch_maker({methods, two, {}}, 1)(0, 400).tallies)
    if (t.method == "slow") asked[t.family] = t.counts.asked;
  for (const char* family : {"apart", "other"})
    EXPECT_NEAR(static_cast<double>(asked[family]), 100, 30) << family;
}

TEST(IsMethodRow, KnowsTheOthersByTheirWholeNames) {
  for (const char* row : {"corpus", "referee", "referee-filter", "referee-wide", "referee-exact"})
    EXPECT_FALSE(is_method_row(row)) << row;
  for (const char* row : {"", "decide", "referee2", "referee-", "corpus1"})
    EXPECT_TRUE(is_method_row(row)) << row;
}

}  // namespace
}  // namespace cyl
