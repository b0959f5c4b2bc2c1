// SPDX-License-Identifier: MIT
#include "oracles/trial/contact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>

#include "corpus/pairs/families.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/strata.hpp"

namespace cyl {
namespace {

constexpr std::uint64_t seed = 20261121;

/// Rounding of a margin that was built (near_touching.hpp).
constexpr double built_margin_error = 5e-16;
/// The width of the narrowest enclosures, in sizes.
constexpr double enclosure_width = 4e-14;
/// The last decade whose pairs the referee must find as they were built.
constexpr int checked_decade = 13;

// The verdict, the margin and the feature of strata are as built.
TEST(ContactFeatureOf, StrataIsAsBuilt) {
  int pairs = 0, other_feature = 0;
  for (const ContactFeature built : enum_values<ContactFeature>) {
    for (int decade = first_decade; decade <= checked_decade; ++decade)
      for (std::uint64_t index = 0; index < 100; ++index) {
        const Pair p = *draw_in_stratum(built, decade, seed, index);
        const Truth truth = judge(p);
        const bool gap = built != ContactFeature::containment && (index % 2 == 0 || decade == 1);
        ASSERT_EQ(truth.verdict, gap ? Verdict::disjoint : Verdict::intersecting) << format_pair(p);
        const double power = std::pow(10, -decade);
        const Enclosure d = enclose_distance(p, truth, std::max(1e-15, 1e-3 * power));
        const double size = size_of(p);
        const double low = (gap ? d.lo : -d.hi) / size, high = (gap ? d.hi : -d.lo) / size;
        EXPECT_LE(low, power + built_margin_error)
            << to_string(built) << " " << decade << " " << format_pair(p);
        EXPECT_GE(high, power / 10 - built_margin_error)
            << to_string(built) << " " << decade << " " << format_pair(p);
        EXPECT_LE(high, power * 1.01 + enclosure_width)
            << to_string(built) << " " << decade << " " << format_pair(p);
        ++pairs;
        const ContactFeature found = contact_feature(p, truth).value();
        other_feature += found != built;
        if (found != built)
          std::printf("%s %d is %s: %s\n", to_string(built), decade, to_string(found),
                      format_pair(p).c_str());
      }
  }
  EXPECT_LE(other_feature, pairs / 100);
  std::printf("%d of %d pairs meet with other features\n", other_feature, pairs);
}

using enum ContactFeature;

Solid solid(Vector3 center, Vector3 axis, double radius, double height) {
  return {center, axis, radius, height};
}
const Vector3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1), origin(0, 0, 0);

TEST(ContactFeatureOf, PlainScenes) {
  struct Scene {
    ContactFeature feature;
    Solid a, b;
  };
  const Scene scenes[] = {
      {cap_cap, solid(origin, z, 1, 2), solid({0, 0, 3}, z, 1, 2)},
      {cap_cap, solid(origin, z, 1, 2), solid({0, 0, 2}, -z, 1, 2)},  // touching
      {side_side, solid(origin, z, 1, 2), solid({3, 0, 0}, z, 1, 2)},
      {side_side, solid(origin, z, 1, 2), solid({2, 0, 0}, z, 1, 2)},  // touching
      {side_side, solid(origin, z, 1, 8), solid({0, 2.5, 0}, x, 1, 8)},
      {side_side, solid(origin, z, 1, 8), solid({0, 2, 0}, x, 1, 8)},  // touching
      {side_side, solid(origin, z, 1, 8), solid({0, 1.9, 0}, x, 1, 8)},
      {cap_side, solid(origin, z, 1, 2), solid({0, 0, 2.5}, x, 1, 1)},
      {cap_side, solid(origin, x, 1, 1), solid({0, 0, 2}, z, 1, 2)},  // touching
      {cap_rim, solid(origin, z, 2, 2), solid({0, 0, 3}, {1, 0, 1}, 1, 1)},
      {rim_rim, solid(origin, z, 1, 2), solid({3, 0, 3}, z, 1, 2)},  // parallel axes
      {side_side, solid(origin, z, 1, 2),
       solid({2, 0, 2}, z, 1, 2)},  // touching in one point: as well cap-cap
      {side_rim, solid(origin, z, 1, 8), solid({4, 0, 0}, {1, 0, 1}, 1, 2)},
      {containment, solid(origin, z, 2, 4), solid({0.5, 0, 0}, {1, 2, 3}, 0.5, 1)},
      {containment, solid({0.5, 0, 0}, {1, 2, 3}, 0, 0), solid(origin, z, 2, 4)},  // a point
      {containment, solid(origin, z, 1, 2), solid(origin, -z, 1, 2)},              // equal
      // Disks have no side, segments have no cap, and points have neither.
      {rim_rim, solid(origin, z, 1, 0), solid({3, 0, 0}, z, 1, 0)},
      {cap_cap, solid(origin, z, 1, 0), solid({0, 0, 1}, z, 1, 0)},
      {rim_rim, solid(origin, z, 0, 2), solid({0, 0, 3}, z, 0, 2)},
      {side_side, solid(origin, z, 0, 2), solid({1, 0, 0}, x + y, 0, 2)},
      {rim_rim, solid(origin, z, 0, 0), solid({1, 0, 0}, x, 0, 0)},
      {rim_rim, solid(origin, z, 0, 0), solid(origin, x, 0, 0)},
      {side_rim, solid(origin, z, 1, 2), solid({3, 0, 0}, z, 0, 0)},
  };
  for (const Scene& s : scenes)
    for (const double unit : {1.0, 1e-200, 1e150})
      for (const bool swapped : {false, true}) {
        Pair p{swapped ? s.b : s.a, swapped ? s.a : s.b};
        for (Solid* c : {&p.a, &p.b}) {
          c->center *= unit;
          c->radius *= unit;
          c->height *= unit;
        }
        const auto found = contact_feature(p);
        ASSERT_TRUE(found);
        EXPECT_EQ(to_string(*found), to_string(s.feature)) << format_pair(p);
      }
  for (const Verdict none : {Verdict::undecided, Verdict::invalid}) {
    Truth truth;
    truth.verdict = none;
    EXPECT_FALSE(contact_feature({}, truth));
  }
}

Solid box(Vector3 center, std::array<double, 3> edges, std::array<double, 4> quaternion = {1, 0, 0, 0}) {
  Solid s;
  s.shape = Shape::box;
  s.center = center;
  s.edges = edges;
  s.quaternion = quaternion;
  return s;
}
/// Turned by a right angle's half about x, so that an edge points along z.
constexpr std::array<double, 4> on_edge{0.92387953251128674, 0.38268343236508977, 0, 0};
/// Turned so that a corner points along z, nearly.
constexpr std::array<double, 4> on_corner{1, 0.3, 0.2, 0};

TEST(ContactFeatureOf, BoxesHaveWordsOfTheirOwn) {
  struct Scene {
    ContactFeature feature;
    const char* words;
    Solid a, b;
    Verdict truth = Verdict::disjoint;
  };
  const Solid below = box(origin, {4, 4, 2});
  const Scene scenes[] = {
      {cap_cap, "facet-facet", below, box({0.5, 0, 3}, {1, 2, 3})},
      {cap_side, "facet-edge", below, box({0, 0, 3}, {2, 2, 2}, on_edge)},
      {cap_rim, "facet-vertex", below, box({0, 0, 4}, {2, 2, 2}, on_corner)},
      {cap_rim, "facet-vertex", below, box({0, 0, 2.5}, {2, 2, 2}, on_corner), Verdict::intersecting},
      {side_side, "edge-edge", below, box({0, 4, 4}, {2, 2, 2})},
      {rim_rim, "vertex-vertex", below, box({5, 6, 7}, {2, 2, 2})},
      {containment, "containment", below, box(origin, {1, 1, 1}, on_corner), Verdict::intersecting},
      {cap_cap, "cap-facet", below, solid({0, 0, 3}, z, 1, 2)},
      {cap_side, "facet-side", below, solid({0, 0, 3}, x, 1, 2)},
      {cap_rim, "facet-rim", below, solid({0, 0, 5}, {1, 0, 1}, 1, 2)},
      {side_side, "edge-side", below, solid({5, 5, 0}, z, 1, 2)},
      {cap_rim, "cap-vertex", box({0, 0, 4}, {2, 2, 2}, on_corner), solid({0, 0, 0}, z, 3, 2)},
      {side_rim, "edge-rim", below, solid({0, 4, 3}, {1, 0, 1}, 0, 1)},
      {side_rim, "side-vertex", below, solid({5, 5, 2}, {1, -1, 0}, 0.5, 2)},
      {containment, "containment", below, solid({0.5, 0, 0}, x, 0.5, 2), Verdict::intersecting},
      // A rectangle has facets and edges.
      {cap_cap, "facet-facet", box(origin, {4, 4, 0}), box({0, 0, 3}, {1, 2, 0})},
      {side_side, "edge-edge", box(origin, {4, 4, 0}), box({4, 0, 0}, {2, 2, 0})},
  };
  for (const Scene& s : scenes)
    for (const bool swapped : {false, true}) {
      const Pair p{swapped ? s.b : s.a, swapped ? s.a : s.b};
      Truth truth;
      truth.verdict = s.truth;
      EXPECT_EQ(to_string(contact_feature(p, truth).value()), to_string(s.feature)) << format_pair(p);
      EXPECT_EQ(contact_in_words(p, truth), s.words) << format_pair(p);
    }
  const Pair cylinders{solid(origin, z, 1, 2), solid({0, 0, 4}, {1, 0, 1}, 1, 1)};
  EXPECT_EQ(contact_in_words(cylinders, judge(cylinders)), "cap-rim");
  EXPECT_EQ(contact_in_words(cylinders, Truth{}), "unknown");
}

TEST(Contains, BoxesToo) {
  const Solid outer = box({1, 2, 3}, {2, 4, 6}, on_edge), round = solid({1, 2, 3}, z, std::sqrt(2.0), 2);
  for (const double off : {-1e-12, 1e-12}) {
    const bool in = off < 0;
    EXPECT_EQ(contains(outer, box(outer.center, {2 + 2 * off, 4, 6}, on_edge)), in);
    EXPECT_EQ(contains(outer, solid(outer.center, x, 2 + off, 2)), in);
    EXPECT_EQ(contains(outer, Solid{outer.center, x, 0, 0, 1 + off}), in);
    EXPECT_EQ(contains(round, box(round.center, {2, 2 + 2 * off, 2})), in);
    EXPECT_EQ(contains(round, box(round.center, {2, 2, 2 + 2 * off})), in);
  }
}

TEST(Contains, IsSharp) {
  const Solid outer = solid({1, 2, 3}, {1, 2, 2}, 2, 4);
  const Vector3 w = Vector3(1, 2, 2) / 3, u = Vector3(2, 1, -2) / 3, v = Vector3(2, -2, 1) / 3;
  for (const double off : {-1e-12, 1e-12}) {
    const bool in = off < 0;
    EXPECT_EQ(contains(outer, solid(outer.center + (1.5 + off) * u, w, 0.5, 4)), in);
    EXPECT_EQ(contains(outer, solid(outer.center + (1 + off) * w, -w, 0.5, 2)), in);
    // Square axes: the radius counts along the outer axis, the corner of half height and radius across it.
    EXPECT_EQ(contains(outer, solid(outer.center + (1.5 + off) * w, u, 0.5, 1)), in);
    EXPECT_EQ(contains(outer, solid(outer.center + (1.5 + off) * u, u, 0.5, 1)), false);
    EXPECT_EQ(contains(outer, solid(outer.center + (std::sqrt(3.75) - 0.5 + off) * u, u, 0.5, 1)), in);
    EXPECT_EQ(contains(outer, solid(outer.center + (1.5 + off) * v, u, 0.5, 0)), in);
    // A tilted disk about the axis looks like an ellipse, whose long half axis is the radius.
    EXPECT_EQ(contains(outer, solid(outer.center, w + u, 2 + off, 0)), in);
  }
  EXPECT_TRUE(contains(outer, outer));
}

TEST(AngleClassOf, IsExactWhereItSaysSo) {
  const auto of = [](const Vector3& a, const Vector3& b) {
    return angle_class({solid(origin, a, 1, 1), solid(origin, b, 1, 1)});
  };
  EXPECT_EQ(of({1, 2, 3}, {-2, -4, -6}), AngleClass::parallel);
  EXPECT_EQ(of({0.1, 0.2, 0.3}, {0.2, 0.4, 0.6}), AngleClass::parallel);
  EXPECT_EQ(of({0.1, 0.2, 0.3}, {1, 2, 3}), AngleClass::within_1e_12);  // 0.1 is not a tenth
  EXPECT_EQ(of({0, 0, 1}, {0, 5e-324, 1}), AngleClass::within_1e_12);
  EXPECT_EQ(of({0, 0, 1e300}, {1e-300, 0, 1e-290}), AngleClass::within_1e_7);
  EXPECT_EQ(of({0, 0, 1}, {0, 0.9e-12, 1}), AngleClass::within_1e_12);
  EXPECT_EQ(of({0, 0, 1}, {0, 1.1e-12, 1}), AngleClass::within_1e_7);
  EXPECT_EQ(of({0, 0, 1}, {0, 0.9e-7, -1}), AngleClass::within_1e_7);
  EXPECT_EQ(of({0, 0, 1}, {0, 1.1e-7, 1}), AngleClass::within_1e_2);
  EXPECT_EQ(of({0, 0, 1}, {0, 0.99e-2, 1}), AngleClass::within_1e_2);
  EXPECT_EQ(of({0, 0, 1}, {0, 1.01e-2, 1}), AngleClass::generic);
  EXPECT_EQ(of({0, 0, 1}, {0, 1, 1.01e-2}), AngleClass::generic);
  EXPECT_EQ(of({0, 0, 1}, {0, 1, 0.99e-2}), AngleClass::near_right);
  EXPECT_EQ(of({0, 0, 1}, {0, 1, 5e-324}), AngleClass::near_right);
  EXPECT_EQ(of({0, 0, 1}, {0, 1, 0}), AngleClass::right);
  EXPECT_EQ(of({1, 2, 2}, {2, 1, -2}), AngleClass::right);
  EXPECT_EQ(of({0.1, 0.1, 0.1}, {1, 1, -2}), AngleClass::right);
  EXPECT_EQ(of({0.1, 0.3, 1}, {3, -1, 0}), AngleClass::near_right);  // neither is exact
  EXPECT_EQ(to_string(AngleClass::near_right), "near-90");
  EXPECT_EQ(to_string(AngleClass::within_1e_12), "<1e-12");
}

// The smallest angle of any two lines counts.
TEST(AngleClassOf, BoxesByAllTheirEdges) {
  const Solid plain = box(origin, {1, 2, 3});
  EXPECT_EQ(angle_class({plain, box(origin, {1, 1, 1}, {3, 1, 0, 0})}), AngleClass::parallel);
  EXPECT_EQ(angle_class({plain, box(origin, {1, 1, 1}, {3, 1, 1, 0})}), AngleClass::generic);
  EXPECT_EQ(angle_class({plain, box(origin, {1, 1, 1}, {1, 1e-9, 1e-9, 0})}), AngleClass::within_1e_7);
  EXPECT_EQ(angle_class({plain, solid(origin, y, 1, 1)}), AngleClass::parallel);
  EXPECT_EQ(angle_class({solid(origin, {0, 5e-324, 1}, 1, 1), plain}), AngleClass::within_1e_12);
  EXPECT_EQ(angle_class({plain, solid(origin, {1, 1, 1}, 1, 1)}), AngleClass::generic);
  // An edge of this box has exactly the direction (-3, 0, -4).
  const Solid turned = box(origin, {1, 1, 1}, {1, 2, 2, -4});
  EXPECT_EQ(angle_class({turned, solid(origin, {0.75, 0, 1}, 1, 1)}), AngleClass::parallel);
  EXPECT_EQ(angle_class({turned, solid(origin, {0.3, 0, 0.4}, 1, 1)}), AngleClass::within_1e_12);
}

TEST(MarginDecade, IsOpenBelow) {
  EXPECT_EQ(margin_decade(std::numeric_limits<double>::infinity()), 0);
  EXPECT_EQ(margin_decade(0.11), 0);
  EXPECT_EQ(margin_decade(0.1), 1);
  EXPECT_EQ(margin_decade(0.011), 1);
  EXPECT_EQ(margin_decade(1e-2), 2);
  EXPECT_EQ(margin_decade(1e-15), 15);
  EXPECT_EQ(margin_decade(0.99e-15), 15);
  EXPECT_EQ(margin_decade(1e-16), 16);
  EXPECT_EQ(margin_decade(0), 16);
}

}  // namespace
}  // namespace cyl
