// SPDX-License-Identifier: MIT
#include "corpus/pairs/families.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "base/fnv.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/pair_numbers.hpp"

namespace cyl {
namespace {

constexpr std::uint64_t seed = 20261121;

using Wide = long double;
using Wide3 = Eigen::Matrix<Wide, 3, 1>;

Wide3 wide(const Vector3& v) { return v.cast<Wide>(); }
Wide3 unit_axis(const Solid& c) { return (wide(c.axis) / wide(c.axis).stableNorm()).eval(); }
Wide wide_size(const Pair& p) { return Wide(p.a.radius) + p.a.height + p.b.radius + p.b.height; }

/// Returns the greatest x.m over the solid, with x relative to its centre.
Wide support(const Solid& c, const Wide3& m) {
  const Wide3 w = unit_axis(c);
  return c.radius * m.cross(w).norm() + Wide(c.height) / 2 * std::abs(m.dot(w));
}

Wide sine(const Pair& p) { return unit_axis(p.a).cross(unit_axis(p.b)).norm(); }
Wide cosine(const Pair& p) { return unit_axis(p.a).dot(unit_axis(p.b)); }

Pair draw(std::string_view name, std::uint64_t index) {
  const Family* family = find_family(name);
  EXPECT_NE(family, nullptr) << name;
  return family->generate(seed, index);
}

TEST(Families, HaveNamesAndSummaries) {
  std::set<std::string_view> names;
  for (const Family& f : campaign_families()) {
    EXPECT_TRUE(names.insert(f.name).second) << f.name;
    EXPECT_FALSE(f.summary.empty());
    EXPECT_EQ(find_family(f.name), &f);
  }
  EXPECT_EQ(families().size(), 36u);
  EXPECT_EQ(names.size(), families().size() + rounded_families().size() + half_space_families().size() +
                              box_families().size());
  EXPECT_EQ(find_family("axes"), nullptr);
}

TEST(Families, DrawDistinctPairs) {
  std::set<std::string> seen;
  std::size_t drawn = 0;
  for (const Family& f : families())
    for (std::uint64_t s : {seed, seed + 1, std::uint64_t{0}})
      for (std::uint64_t i = 0; i < 100; ++i, ++drawn) seen.insert(format_pair(f.generate(s, i)));
  EXPECT_EQ(seen.size(), drawn);
}

TEST(Families, KeepTheirPairsForEver) {
  EXPECT_EQ(fnv1a(format_pair(find_family("touching_rim_rim")->generate(seed, 1000000007))),
            376926449179026472u);
  std::uint64_t digest = fnv1a({});  // over the families before the close contacts, then of the others
  for (const Family& f : families()) {
    if (f.name == "close_contacts") {
      EXPECT_EQ(digest, 12863362681524556228u);
    }
    for (std::uint64_t i = 0; i < 500; ++i) {
      const Pair pair = f.generate(seed, i);
      EXPECT_TRUE(is_legal(pair)) << f.name << ' ' << i;
      digest = fnv1a(format_pair(pair), digest);
    }
  }
  EXPECT_EQ(digest, 15129444820110717u);
  digest = fnv1a({});
  for (const Family& f : half_space_families())
    for (std::uint64_t i = 0; i < 500; ++i) {
      const Pair pair = f.generate(seed, i);
      EXPECT_TRUE(is_legal(pair) && has_half_space(pair)) << f.name << ' ' << i;
      digest = fnv1a(format_pair(pair), digest);
    }
  EXPECT_EQ(digest, 9001784708597669980u);
}

/// Relative to the size.
constexpr Wide construction_tol = 5e-16L;

TEST(Families, HaveTheAnglesTheyName) {
  std::set<int> decades;
  int same = 0, beside = 0;
  for (std::uint64_t i = 0; i < 600; ++i) {
    const Pair parallel = draw("axes_parallel", i);
    ASSERT_TRUE(parallel.a.axis == parallel.b.axis || parallel.a.axis == -parallel.b.axis);

    const Pair nearly = draw("axes_nearly_parallel", i);
    const int decade = -2 - static_cast<int>(i / 2 % 15);
    decades.insert(decade);
    const Wide angle = std::pow(Wide(10), decade);
    ASSERT_NEAR(static_cast<double>(sine(nearly) / angle), 1, 0.05) << i;
    ASSERT_EQ(cosine(nearly) > 0, i % 2 == 0);
    same += cosine(nearly) > 0;

    const Pair right = draw("axes_perpendicular", i);
    ASSERT_LE(std::abs(cosine(right)), 1e-15L);
    beside += right.a.axis.dot(right.b.axis) == 0;

    // The axes meet, so the centres differ by nothing square to both.
    const Pair crossing = draw("axes_crossing", i);
    const Wide3 d = wide(crossing.b.center) - wide(crossing.a.center);
    ASSERT_LE(std::abs(d.dot(unit_axis(crossing.a).cross(unit_axis(crossing.b)))), 1e-14L) << i;
  }
  EXPECT_EQ(decades.size(), 15u);
  EXPECT_EQ(same, 300);
  EXPECT_GT(beside, 200);
}

TEST(Families, HaveThePosesTheyName) {
  int a_inside = 0;
  for (std::uint64_t i = 0; i < 600; ++i) {
    Pair p = draw("contained", i);
    const bool inside_a = p.a.radius > p.b.radius && p.a.height > p.b.height;
    const Solid &outer = inside_a ? p.a : p.b, &inner = inside_a ? p.b : p.a;
    a_inside += !inside_a;
    // The inner solid's extent along the outer axis, and across it from the outer axis.
    const Wide3 w = unit_axis(outer), d = wide(inner.center) - wide(outer.center);
    const Wide along = std::abs(d.dot(w)) + support(inner, w);
    ASSERT_LE(along, Wide(outer.height) / 2) << i;
    const Wide3 across = d - d.dot(w) * w;
    ASSERT_LE(across.norm() + std::hypot(Wide(inner.radius), Wide(inner.height) / 2), outer.radius) << i;

    p = draw("coaxial", i);
    const Wide3 u = unit_axis(p.a), e = wide(p.b.center) - wide(p.a.center);
    ASSERT_LE(sine(p), 1e-18L);
    ASSERT_LE((e - e.dot(u) * u).norm(), 1e-15L * wide_size(p)) << i;
    const Wide shift = std::abs(e.dot(u)), sum = (Wide(p.a.height) + p.b.height) / 2;
    const Wide difference = std::abs(Wide(p.a.height) - p.b.height) / 2;
    const Wide bound = construction_tol * wide_size(p);
    const bool overlapping = shift >= difference - bound && shift <= sum + bound;
    const bool nested = shift < difference && (p.a.radius < p.b.radius) == (p.a.height < p.b.height);
    ASSERT_TRUE(i % 3 == 0 ? overlapping : i % 3 == 1 ? nested : shift > sum) << i;

    p = draw("equal", i);
    ASSERT_TRUE(p.a.center == p.b.center && p.a.radius == p.b.radius && p.a.height == p.b.height);
    ASSERT_EQ(p.b.axis, i % 2 == 0 ? p.a.axis : Vector3(-p.a.axis));
  }
  EXPECT_GT(a_inside, 200);
  EXPECT_LT(a_inside, 400);
}

}  // namespace
}  // namespace cyl
