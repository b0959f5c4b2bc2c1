// SPDX-License-Identifier: MIT
// Each one-sided law catches a planted fault. If other laws catch it too, there is a reason.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>

#include "oracles/referee/referee.hpp"
#include "props/laws/law_groups.hpp"
#include "props/laws/laws_test.hpp"
#include "solver/decide.hpp"

namespace cyl {
namespace {

double centre_distance(const Pair& pair) { return (pair.b.center - pair.a.center).norm(); }

// Points of the widest part, in the solid's own axis and radius.
TEST(OneSidedLaws, CapsulesContainAndAreContained) {
  int inside = 0;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    for (const Solid& c : {find_family("random")->generate(7, i).a, find_family("far")->generate(7, i).a}) {
      const Solid outer = capsule_around(c), inner = capsule_inside(c);
      const Vector3 w = prepare(c).unit_axis, across = w.unitOrthogonal();
      for (const double end : {-0.5, 0.2, 0.5}) {
        const Solid rim{c.center + c.radius * across + end * c.height * w, w, 0, 0};
        EXPECT_EQ(intersect(outer, rim), Verdict::intersecting);
        if (inner.rounding < 0) continue;
        ++inside;
        const Vector3 x = end * inner.height * w + inner.rounding * (across + 2 * end * w).normalized();
        EXPECT_LE(x.cross(w).norm(), c.radius);
        EXPECT_LE(std::abs(x.dot(w)), c.height / 2);
      }
    }
  }
  EXPECT_GT(inside, 1000);
  EXPECT_LT(capsule_inside({{1, 2, 3}, {1, 1, 1}, 0, 2}).rounding, 0) << "nothing is inside a segment";
  EXPECT_LT(capsule_inside({{1, 2, 3}, {1, 1, 1}, 2, 0}).rounding, 0) << "nothing is inside a disk";
}

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
