// SPDX-License-Identifier: MIT
// Each one-sided law catches a planted fault. If other laws catch it too, there is a reason.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>

#include "oracles/referee/referee.hpp"
#include "props/laws/laws_test.hpp"

namespace cyl {
namespace {

double centre_distance(const Pair& pair) { return (pair.b.center - pair.a.center).norm(); }

// Some radii are left out of a table that is otherwise right. To grow out of the right ones is a jump, as is
// any small change of a radius.
TEST(OneSidedLaws, CatchSolidsThatGrowApart) {
  EXPECT_EQ(laws_broken_by(plant("intersect",
                                 [](const Pair& pair, MethodAnswer& answer) {
                                   const auto bits = std::bit_cast<std::uint64_t>(pair.a.radius) ^
                                                     std::bit_cast<std::uint64_t>(pair.b.radius);
                                   if (bits % 4 == 0) answer.verdict = Verdict::disjoint;
                                 })),
            (Numbers{10, 11, 12, 22, 31}));
}

// The needles have one length, so only a copy is so much smaller.
TEST(OneSidedLaws, CatchASolidMissedInsideAnother) {
  EXPECT_EQ(laws_broken_by(plant("intersect",
                                 [](const Pair& pair, MethodAnswer& answer) {
                                   const double a = pair.a.radius + pair.a.height,
                                                b = pair.b.radius + pair.b.height;
                                   if (a < b / 1000 || b < a / 1000) answer.verdict = Verdict::disjoint;
                                 }),
                           "needles"),
            Numbers{11});
}

// Without a direction, nothing is moved along it. But (22) moves a centre across the limit.
TEST(OneSidedLaws, CatchSolidsSaidToMeetAcrossASpace) {
  EXPECT_EQ(laws_broken_by(plant("intersect",
                                 [](const Pair& pair, MethodAnswer& answer) {
                                   if (centre_distance(pair) > size_of(pair) / 2)
                                     answer.verdict = Verdict::intersecting;
                                 })),
            (Numbers{12, 22, 31}));
}

TEST(OneSidedLaws, CatchSolidsSaidToMeetWhereTheyWereMovedApart) {
  EXPECT_EQ(laws_broken_by(plant("decide",
                                 [](const Pair& pair, MethodAnswer& answer) {
                                   if (centre_distance(pair) < 100 * size_of(pair)) return;
                                   answer.verdict = Verdict::intersecting;
                                   answer.witness = CertificateKind::none;
                                 })),
            Numbers{13});
}

TEST(OneSidedLaws, CatchACapsuleThatMissesWhatItsSphereMeets) {
  const auto misses_long_ones = [](const Pair& pair, MethodAnswer& answer) {
    if (pair.a.height > pair.a.rounding) answer.verdict = Verdict::disjoint;
  };
  const Numbers violated = laws_broken_by(plant("intersect", misses_long_ones), "capsule_capsule");
  EXPECT_NE(std::find(violated.begin(), violated.end(), 14), violated.end());
}

TEST(OneSidedLaws, CatchADistanceThatStopsGrowing) {
  EXPECT_EQ(laws_broken_by(plant("distance",
                                 [](const Pair& pair, MethodAnswer& answer) {
                                   const double most = 100 * size_of(pair);
                                   if (answer.distance > most) answer.distance = most;
                                 })),
            Numbers{13});
}

}  // namespace
}  // namespace cyl
