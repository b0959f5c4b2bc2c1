// SPDX-License-Identifier: MIT
#include "bench/stability/backward.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/json.hpp"
#include "corpus/pairs/near_touching.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "oracles/methods/fake_method_test.hpp"
#include "oracles/referee/referee.hpp"

namespace cyl {
namespace {

/// Upright, side by side, at a margin relative to the size (6).
Pair beside(double margin) {
  return {{{0, 0, 0}, {0, 0, 1}, 1, 2}, {{2 + 6 * margin, 0, 0}, {0, 0, 1}, 1, 2}};
}

TEST(Backward, IsTheDistanceOfAWrongVerdict) {
  for (const double margin : {0.1, 1e-3, 1e-9}) {
    const auto apart = backward_error(beside(margin), Verdict::intersecting);
    ASSERT_TRUE(apart);
    EXPECT_NEAR(*apart, margin, 2e-3 * margin);
    const auto deep = backward_error(beside(-margin), Verdict::disjoint);
    ASSERT_TRUE(deep);
    EXPECT_NEAR(*deep, margin, 2e-3 * margin);
    EXPECT_TRUE(backward_error(beside(margin), Verdict::touching));
    EXPECT_TRUE(backward_error(beside(-margin), Verdict::touching));
    EXPECT_FALSE(backward_error(beside(margin), Verdict::disjoint));
    EXPECT_FALSE(backward_error(beside(-margin), Verdict::intersecting));
  }
  EXPECT_EQ(backward_error(beside(0), Verdict::disjoint), 0);
  EXPECT_FALSE(backward_error(beside(0), Verdict::intersecting));
  Pair far = beside(0);
  far.a.center.x() = -1e308;
  far.b.center.x() = 1e308;
  const auto most = backward_error(far, Verdict::intersecting);
  ASSERT_TRUE(most);
  EXPECT_TRUE(std::isfinite(*most));
  EXPECT_GT(*most, 1e307);
  Pair invalid = beside(1);
  invalid.a.radius = -1;
  EXPECT_FALSE(backward_error(invalid, Verdict::disjoint));
}

bool apart(const Pair& pair) { return judge_verdict(pair).verdict == Verdict::disjoint; }

// Changes of both solids that together move their points by less than the distance turn no verdict; the
// translation by a little more turns it.
TEST(Backward, NothingLessMakesTheAnswerRight) {
  constexpr double less = 0.99, more = 1.01;
  for (int k = 0; k <= static_cast<int>(ContactKind::parallel_sides); ++k) {
    for (const double margin : {1e-3, -1e-3}) {
      RandomStream stream("backward", 1, static_cast<std::uint64_t>(k));
      const Contact c = draw_contact_at(static_cast<ContactKind>(k), stream, margin);
      const double size = size_of(c.pair);
      const auto moved = backward_error(c.pair, margin > 0 ? Verdict::intersecting : Verdict::disjoint);
      ASSERT_TRUE(moved);
      EXPECT_NEAR(*moved, 1e-3, 2e-6);
      const double length = *moved * size;
      Pair turned = c.pair;
      turned.b.center -= std::copysign(more * length, margin) * c.normal;
      EXPECT_NE(apart(turned), apart(c.pair)) << k;
      for (int i = 0; i < 200; ++i) {
        Pair other = c.pair;
        // Shares of what may move: b's centre, a's radius, b's half height, a's axis.
        double shares[4], sum = 0;
        for (double& share : shares) sum += share = i < 50 ? 0 : stream.unit();
        if (i < 50) sum = shares[0] = 1;
        for (double& share : shares) share *= less * length / sum;
        const Vector3 way = i % 2 == 0 ? stream.unit_vector() : Vector3(stream.sign() * c.normal);
        other.b.center += shares[0] * way;
        other.a.radius += stream.sign() * shares[1];
        other.b.height += stream.sign() * 2 * shares[2];
        const double reach = std::hypot(other.a.radius, c.pair.a.height / 2);
        other.a.axis = normalise(other.a.axis) + shares[3] / reach * stream.perpendicular(other.a.axis);
        EXPECT_EQ(apart(other), apart(c.pair)) << k << ' ' << i;
      }
    }
  }
}

FindingRecord finding(const char* method, FindingKind kind, const Pair& pair) {
  FindingRecord f;
  f.method = method;
  f.kind = kind;
  Case line;
  line.pair = pair;
  f.pair = format_case(line);
  return f;
}

TEST(Backward, OfFindingsThatAreVerdicts) {
  const std::vector<WrongVerdict> wrong = wrong_verdicts(
      {finding("x", FindingKind::wrong_disjoint, beside(-1e-4)), finding("x", FindingKind::crash, beside(1)),
       finding("y", FindingKind::wrong_intersecting, beside(1e-2)),
       finding("x", FindingKind::wrong_intersecting, beside(1e-2)),
       finding("x", FindingKind::distance_outside, beside(1e-2)),
       finding("x", FindingKind::wrong_disjoint, beside(1))});
  ASSERT_EQ(wrong.size(), 3u);
  EXPECT_EQ(wrong[0].method, "x");
  EXPECT_NEAR(wrong[0].backward, 1e-4, 1e-6);
  EXPECT_EQ(wrong[1].method, "y");
  EXPECT_NEAR(wrong[1].backward, 1e-2, 1e-4);
  EXPECT_EQ(wrong[2].backward, wrong[1].backward);
}

TEST(Backward, QuantilesAreOfTheSample) {
  std::vector<WrongVerdict> wrong{{"one", 7}};
  for (int i = 200; i > 0; --i) wrong.push_back({"many", i * 1.0});
  const std::vector<BackwardError> errors = backward_errors(wrong);
  ASSERT_EQ(errors.size(), 2u);
  EXPECT_EQ(backward_json(errors).dump(),
            R"([{"max":7.0,"method":"one","p50":7.0,"p99":7.0,"wrong":1},)"
            R"({"max":200.0,"method":"many","p50":100.0,"p99":198.0,"wrong":200}])");
}

TEST(Backward, OfAMethodWrongByALengthIsThatLength) {
  std::vector<std::unique_ptr<Method>> methods = select_methods(own_methods(), "exact");
  constexpr double wrong_by = 3e-5;  // it takes gaps of less, relative to the size, for none
  const auto fat = [](const Pair& pair) {
    const Truth truth = judge(pair);
    const bool near = truth.verdict == Verdict::disjoint &&
                      enclose_distance(pair, truth, 1e-9).lo < wrong_by * size_of(pair);
    return answered(near ? Verdict::intersecting : truth.verdict);
  };
  methods.push_back(fake_method("fat", fat, {.claim = {.relative = 1, .source = "the test"}}));
  const std::vector<BackwardError> errors = backward_errors(wrong_verdicts(methods));
  ASSERT_EQ(errors.size(), 1u);  // what is right has none
  EXPECT_EQ(errors[0].method, "fat");
  EXPECT_GT(errors[0].wrong, 100u);
  EXPECT_LE(errors[0].max, 1.001 * wrong_by);
  EXPECT_GT(errors[0].max, wrong_by / 3);
  EXPECT_LT(errors[0].p50, errors[0].p99);
  EXPECT_LE(errors[0].p99, errors[0].max);
}

}  // namespace
}  // namespace cyl
