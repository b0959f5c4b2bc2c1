// SPDX-License-Identifier: MIT
// Methods that misbehave, side by side with an honest one. Each is counted, law 30 reports it, and the
// honest one is as it is alone.
#include "props/laws/examine.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <limits>
#include <stdexcept>

#include "props/laws/laws_test.hpp"

namespace cyl {
namespace {

using std::chrono::milliseconds;

// Only a method that spins can use so much CPU time. The load of the machine hurries no method.
constexpr Caps short_caps{.call_cpu = milliseconds(200), .call_wall = std::chrono::hours(1), .hangs = 2};
constexpr std::uint64_t pair_count = 8;

enum Behaviour : std::size_t { throws, spins, garbles, crashes, honest };

std::vector<std::unique_ptr<Method>> misbehaving() {
  const auto method = [](std::string_view name, Planted::Ask ask) {
    return std::make_unique<Planted>(std::move(ask), name);
  };
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(
      method("throws", [](const Pair&) -> MethodAnswer { throw std::runtime_error("no support point"); }));
  methods.push_back(method("spins", [](const Pair&) {
    for (volatile bool forever = true; forever;) {
    }
    return MethodAnswer{};
  }));
  methods.push_back(method("garbles", [](const Pair& pair) {
    MethodAnswer answer = ask_ours("distance", pair);
    if (pair.a.radius < pair.b.radius)
      answer.verdict = static_cast<Verdict>(77);
    else
      answer.distance = std::numeric_limits<double>::quiet_NaN();
    answer.has_distance = true;
    return answer;
  }));
  methods.push_back(method("crashes", [](const Pair&) -> MethodAnswer { std::abort(); }));
  methods.push_back(method("honest", [](const Pair& pair) { return ask_ours("decide", pair); }));
  return methods;
}

std::vector<Pair> some_pairs() {
  std::vector<Pair> pairs;
  for (std::uint64_t i = 0; i < pair_count; ++i)
    pairs.push_back(find_family("random")->generate(family_seed, i));
  return pairs;
}

bool every_law(std::size_t, const Law&) { return true; }

class Misbehaving : public testing::Test {
 protected:
  const std::vector<std::unique_ptr<Method>> methods = misbehaving();
  const std::vector<Pair> pairs = some_pairs();
  const Examined examined = examine(methods, pairs, every_law, short_caps);
};

TEST_F(Misbehaving, IsCounted) {
  for (const Behaviour b : {throws, garbles, crashes}) {
    EXPECT_EQ(examined.counts[b].asked, pair_count);
    EXPECT_EQ(examined.counts[b].failed, pair_count) << methods[b]->name();
    EXPECT_EQ(examined.counts[b].hung_seconds, 0) << methods[b]->name();
  }
  // After two hangs it is not asked any more.
  EXPECT_GT(examined.counts[spins].hung_seconds, 0);
  EXPECT_GT(examined.counts[spins].hangs, 0u);
  EXPECT_EQ(examined.counts[spins].failed, 2u);
  EXPECT_EQ(examined.counts[spins].asked, 2u);
  EXPECT_EQ(examined.counts[spins].declined, 0u);
}

TEST(Examine, SeesWhoBreaksDownOnAChangedPairAlone) {
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(std::make_unique<Planted>([](const Pair& pair) {
    if (pair.a.radius > pair.b.radius) throw std::runtime_error("roles");
    return ask_ours("intersect", pair);
  }));
  Pair pair;
  pair.a.radius = 1;
  pair.b.radius = 2;
  const Examined examined =
      examine(methods, {&pair, 1}, [](std::size_t, const Law& law) { return law.number == 1; });
  ASSERT_EQ(examined.violations.size(), 1u);
  EXPECT_EQ(examined.violations[0].law->number, 1);
  EXPECT_EQ(examined.violations[0].violation.what, "fails on a changed pair: roles");
}

TEST_F(Misbehaving, BreaksLaw30AndNoOther) {
  std::vector<std::uint64_t> violations(methods.size(), 0);
  for (const LawViolation& b : examined.violations) {
    EXPECT_EQ(b.law->number, 30) << methods[b.method]->name() << ": " << b.violation.what;
    EXPECT_EQ(b.violation.severity, Severity::contract);
    ++violations[b.method];
  }
  EXPECT_EQ(violations, (std::vector<std::uint64_t>{pair_count, 2, pair_count, pair_count, 0}));
}

TEST_F(Misbehaving, LeavesTheHonestOneAlone) {
  std::vector<std::unique_ptr<Method>> alone;
  alone.push_back(std::move(misbehaving()[honest]));
  const Examined expected = examine(alone, pairs, every_law);
  EXPECT_EQ(examined.counts[honest].said, expected.counts[0].said);
  EXPECT_EQ(examined.counts[honest].failed, 0u);
  EXPECT_EQ(examined.truths, expected.truths);
  for (std::size_t p = 0; p < pairs.size(); ++p)
    EXPECT_TRUE(same_answer(examined.answers[p * methods.size() + honest], expected.answers[p]));
}

// A law asks only methods that answered, and only those for which it is wanted.
TEST(Examine, HoldsAMethodToTheLawsThatAreWanted) {
  std::vector<std::unique_ptr<Method>> methods;
  for (int i = 0; i < 2; ++i)
    methods.push_back(std::make_unique<Planted>(
        plant("decide", [](const Pair&, MethodAnswer& answer) { answer.steps = answer.step_cap + 1; })));
  const auto pairs = some_pairs();
  const Examined examined =
      examine(methods, pairs, [](std::size_t m, const Law& law) { return m == 1 && law.number == 38; });
  ASSERT_EQ(examined.violations.size(), pairs.size());
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    EXPECT_EQ(examined.violations[p].method, 1u);
    EXPECT_EQ(examined.violations[p].pair, p);
    EXPECT_EQ(examined.violations[p].law->number, 38);
  }
}

TEST(Examine, PairsThatAreNotSentAreNotCounted) {
  std::vector<std::unique_ptr<Method>> methods;
  methods.push_back(fake_method("program", [](const Pair&) { return failed_answer(Failure::crash, "gone"); },
                                {.is_out_of_process = true}));
  const Examined examined = examine(methods, some_pairs(), every_law, {.program_crashes = 2});
  EXPECT_EQ(examined.counts[0].asked, 2u);
  EXPECT_EQ(examined.counts[0].failed, 2u);
  EXPECT_EQ(examined.counts[0].declined, 0u);
}

}  // namespace
}  // namespace cyl