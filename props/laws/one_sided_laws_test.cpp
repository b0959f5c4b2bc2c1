// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "props/laws/law_groups.hpp"
#include "props/laws/laws_test.hpp"
#include "solver/decide.hpp"

namespace cyl {
namespace {

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

}  // namespace
}  // namespace cyl
