// SPDX-License-Identifier: MIT
#include "oracles/trial/cells.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "corpus/pairs/families.hpp"
#include "corpus/pairs/near_touching.hpp"
#include "oracles/referee/referee.hpp"
#include "oracles/trial/contact.hpp"

namespace cyl {
namespace {

/// An upright cylinder of radius 1 and height 2, and another at a gap of `margin` times the size of 6.
Pair beside(double margin, const Vector3& axis = {0, 0, 1}) {
  return {{{0, 0, 0}, {0, 0, 1}, 1, 2}, {{2 + 6 * margin, 0, 0}, axis, 1, 2}};
}

Cell at(Plane plane, const Pair& pair, Verdict truth = Verdict::disjoint) {
  return cells_of(pair, truth)[static_cast<std::size_t>(plane)];
}
std::string x_label(Plane plane, const Pair& pair) {
  return x_axis(plane).labels.at(static_cast<std::size_t>(at(plane, pair).x));
}
std::string y_label(Plane plane, const Pair& pair, Verdict truth = Verdict::disjoint) {
  return y_axis(plane).labels.at(static_cast<std::size_t>(at(plane, pair, truth).y));
}
std::string angle_label(const Vector3& axis) { return x_label(Plane::angle_margin, beside(1, axis)); }

TEST(Cells, AnglesByTheirDecadesFromParallelToPerpendicular) {
  EXPECT_EQ(angle_label({0, 0, 1}), "parallel");
  EXPECT_EQ(angle_label({0, 0, -1e-200}), "parallel");
  EXPECT_EQ(angle_label({0x1p-1074, 0, 1}), "1e-16");
  EXPECT_EQ(angle_label({3e-13, 0, 1}), "1e-12");
  EXPECT_EQ(angle_label({0, 0.05, -1}), "1e-1");
  EXPECT_EQ(angle_label({1, 0, 1}), "oblique");
  EXPECT_EQ(angle_label({1, 0, 0.05}), "1e-1");
  EXPECT_EQ(angle_label({1, 0, 3e-13}), "1e-12");
  EXPECT_EQ(angle_label({0, 1, 0x1p-1074}), "1e-16");
  EXPECT_EQ(angle_label({1, 2, 0}), "perpendicular");
  int last = -1;
  for (const Vector3& axis : {Vector3(0, 0, 1), Vector3(1e-20, 0, 1), Vector3(1e-3, 0, 1), Vector3(1, 0, 1),
                              Vector3(1, 0, 1e-3), Vector3(1, 0, 1e-20), Vector3(1, 0, 0)}) {
    EXPECT_GT(at(Plane::angle_margin, beside(1, axis)).x, last);
    last = at(Plane::angle_margin, beside(1, axis)).x;
  }
}

TEST(Cells, MarginsByTheirDecadesOnEitherSideAndTouchingApart) {
  for (const Plane plane : {Plane::angle_margin, Plane::aspect_margin}) {
    EXPECT_EQ(y_label(plane, beside(1)), "1");
    EXPECT_EQ(y_label(plane, beside(0.05)), "1e-1");
    EXPECT_EQ(y_label(plane, beside(3e-7)), "1e-6");
    EXPECT_EQ(y_label(plane, beside(-3e-7), Verdict::intersecting), "1e-6");
    EXPECT_EQ(y_label(plane, beside(0), Verdict::touching), "touching");
    EXPECT_EQ(y_label(plane, beside(0), Verdict::disjoint), "1e-16");  // apart by less than is computed
  }
  EXPECT_EQ(margin_axis().labels.size(), static_cast<std::size_t>(margin_bins));
  EXPECT_EQ(margin_axis().labels[touching_bin], "touching");
}

// The solver places the margin. Pairs of known margin check that it is not far off.
TEST(Cells, MarginsKnownByConstructionAreFound) {
  for (const ContactKind kind : {ContactKind::side_side, ContactKind::side_rim, ContactKind::rim_rim,
                                 ContactKind::cap_rim, ContactKind::cap_side, ContactKind::cap_cap}) {
    for (int d = 2; d <= 13; ++d) {
      for (const double sign : {1.0, -1.0}) {
        RandomStream stream("cells_test", 1, static_cast<std::uint64_t>(d));
        const Pair pair = draw_contact_at(kind, stream, sign * 0.5 * std::pow(10, -d)).pair;
        const Verdict truth = sign > 0 ? Verdict::disjoint : Verdict::intersecting;
        EXPECT_EQ(at(Plane::angle_margin, pair, truth).y, d) << static_cast<int>(kind) << ' ' << sign;
      }
    }
  }
}

TEST(Cells, AspectIsTheMostExtremeRatio) {
  const auto label = [](double radius, double height, double scale = 1) {
    Pair pair = beside(1);
    pair.a.radius = radius;
    pair.a.height = height;
    pair.b.radius = pair.b.height = radius * scale;
    return x_label(Plane::aspect_margin, pair);
  };
  EXPECT_EQ(label(1, 2), "10");
  EXPECT_EQ(label(1, 0.1), "1e2");   // 20
  EXPECT_EQ(label(0.1, 30), "1e3");  // 150
  EXPECT_EQ(label(0.1, 30, 100), "1e3");
  EXPECT_EQ(label(1, 1, 30), "1e2");
  EXPECT_EQ(label(1, 1, 3e-8), "1e8");
  EXPECT_EQ(label(1, 1, 1e-17), "> 1e16");
  EXPECT_EQ(label(1e-300, 1e300), "> 1e16");
  EXPECT_EQ(label(0, 1), "flat, thin or a point");
  EXPECT_EQ(label(1, 0), "flat, thin or a point");
  EXPECT_EQ(label(0, 0), "flat, thin or a point");
}

TEST(Cells, ScaleAndOffset) {
  const auto labels = [](double scale, double offset) {
    Pair pair = beside(1);
    for (Solid* c : {&pair.a, &pair.b}) {
      c->radius *= scale;
      c->height *= scale;
      c->center = Vector3(0, -offset * 6 * scale, 0);
    }
    return x_label(Plane::scale_offset, pair) + ", " + y_label(Plane::scale_offset, pair);
  };
  EXPECT_EQ(labels(1, 0), "10, 1");
  EXPECT_EQ(labels(1, 0.5), "10, 1");
  EXPECT_EQ(labels(0.05, 20), "1, 1e2");
  EXPECT_EQ(labels(1e-9, 3e11), "1e-8, 1e12");
  EXPECT_EQ(labels(1e-300, 1e20), "1e-200, > 1e16");
  EXPECT_EQ(labels(1e200, 1), "> 1e100, 1");
  const Pair points{{{0, 0, 0}, {0, 0, 1}, 0, 0}, {{1, 0, 0}, {0, 0, 1}, 0, 0}};
  EXPECT_EQ(x_label(Plane::scale_offset, points), "1e-200");
  EXPECT_EQ(y_label(Plane::scale_offset, points), "> 1e16");
  EXPECT_EQ(y_label(Plane::angle_margin, points), "1");
}

TEST(Cells, EveryPairHasAPlaceOnThePlanes) {
  for (const Family& family : families()) {
    for (std::uint64_t i = 0; i < 60; ++i) {
      const Pair pair = family.generate(3, i);
      const auto cells = cells_of(pair, judge(pair).verdict);
      for (const Plane plane : planes) {
        const Cell cell = cells[static_cast<std::size_t>(plane)];
        EXPECT_TRUE(cell.x >= 0 && cell.x < static_cast<int>(x_axis(plane).labels.size())) << family.name;
        EXPECT_TRUE(cell.y >= 0 && cell.y < static_cast<int>(y_axis(plane).labels.size())) << family.name;
      }
    }
  }
}

}  // namespace
}  // namespace cyl
