// SPDX-License-Identifier: MIT
#include "corpus/pairs/box_pairs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include "base/fnv.hpp"
#include "corpus/pairs/families.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/solid_kind.hpp"
#include "corpus/pairs/support.hpp"
#include "corpus/pairs/touch_plane.hpp"

namespace cyl {
namespace {

using Wide = long double;
using Wide3 = Vec3<Wide>;

constexpr std::uint64_t seed = 20261121;
/// Relative to the size.
constexpr Wide construction_tol = 1e-15L;

Pair draw(std::string_view name, std::uint64_t index) { return find_family(name)->generate(seed, index); }

Wide3 between_centers(const Pair& p) { return lifted<Wide>(p.b.center) - lifted<Wide>(p.a.center); }

/// Returns the gap of two boxes without roundings along the best of the fifteen directions that decide,
/// negative if they overlap. If vertices are nearest, their distance is more.
Wide gap_of_boxes(const Pair& p) {
  const Terms<Wide> a = terms_of<Wide>(p.a), b = terms_of<Wide>(p.b);
  std::vector<Wide3> directions(a.edges.begin(), a.edges.end());
  directions.insert(directions.end(), b.edges.begin(), b.edges.end());
  for (const Wide3& u : a.edges)
    for (const Wide3& v : b.edges) directions.push_back(cross(u, v));
  Wide most = -INFINITY;
  for (const Wide3& d : directions)
    if (const Wide length = norm(d); length > 1e-17L)
      most = std::max(most, -support_gap(a, b, between_centers(p), d) / length);
  return most;
}

bool has_kinds(const Pair& p, SolidKind x, SolidKind y) {
  const SolidKind a = kind_of(p.a), b = kind_of(p.b);
  return (a == x && b == y) || (a == y && b == x);
}

TEST(BoxFamilies, DrawLegalPairsOfEveryKind) {
  std::map<SolidKind, int> beside;
  std::uint64_t digest = fnv1a({});
  for (const Family& family : box_families())
    for (std::uint64_t i = 0; i < 500; ++i) {
      const Pair pair = family.generate(seed, i);
      ASSERT_TRUE(is_legal(pair) && has_box(pair) && size_of(pair) > 0) << format_pair(pair);
      ++beside[kind_of(is_box(pair.a) ? pair.b : pair.a)];
      digest = fnv1a(format_pair(pair), digest);
    }
  for (const SolidKind kind : enum_values<SolidKind>) EXPECT_GT(beside[kind], 300) << to_string(kind);
  EXPECT_EQ(digest, 13585855466523483059u);
}

TEST(TouchPlane, TheContactIsTheFarthestPointOfItsPart) {
  constexpr std::array kinds{SolidKind::sphere, SolidKind::capsule, SolidKind::cylinder, SolidKind::box};
  RandomStream s("touch_plane_test", seed, 0);
  for (int i = 0; i < 2000; ++i) {
    Solid c;
    const SolidKind kind = kinds[s.below(kinds.size())];
    if (kind == SolidKind::box) c.shape = Shape::box, c.edges = {s.unit(), s.unit(), s.unit()};
    if (kind == SolidKind::cylinder) c.radius = s.unit();
    if (kind == SolidKind::cylinder || kind == SolidKind::capsule) c.height = s.unit();
    const auto part = static_cast<TouchPart>(s.below(3));
    const Vector3 n = s.unit_vector(), u = s.perpendicular(n);
    const Vector3 contact = touch_plane(c, part, n, u, {s.between(-1, 1), s.between(-1, 1)}, s);
    const Terms<Wide> terms = terms_of<Wide>(c);
    const Wide3 x = lifted<Wide>(contact), out = lifted<Wide>(n);
    ASSERT_NEAR(static_cast<double>(dot(x, out) - core_support(terms, out)), 0, 1e-15);
    const auto [caps, wall] = beyond(terms, x);
    ASSERT_LE(std::max(caps, wall), 1e-15L);
    if (!is_box(c)) continue;
    const auto flat =
        std::ranges::count_if(terms.edges, [&](const Wide3& e) { return std::abs(dot(e, out)) < 1e-15L; });
    ASSERT_EQ(flat, static_cast<int>(part)) << "edges in the plane";
    if (part == TouchPart::point) continue;
    ASSERT_TRUE(std::ranges::any_of(
        terms.edges, [&](const Wide3& e) { return std::abs(dot(e, lifted<Wide>(u))) > 1 - 1e-15L; }));
  }
}

/// Returns the least sine of the angle between an edge of a and one of b.
Wide least_sine(const Pair& p) {
  Wide least = 1;
  for (const Wide3& u : terms_of<Wide>(p.a).edges)
    for (const Wide3& v : terms_of<Wide>(p.b).edges) least = std::min(least, norm(cross(u, v)));
  return least;
}

TEST(BoxFamilies, TouchAtTheMarginTheyName) {
  for (const char* name : {"box_box", "box_edges", "box_flush"}) {
    std::set<int> decades;
    for (std::uint64_t i = 0; i < 1200; ++i) {
      const bool turns = std::string_view(name) == "box_box";
      if (turns && i % 4 != 1 && i % 4 != 2) continue;
      const std::uint64_t index = turns ? i / 4 * 2 + i % 4 - 1 : i;
      const Pair p = draw(name, i);
      if (!has_kinds(p, SolidKind::box, SolidKind::box)) continue;
      const int decade = 1 + static_cast<int>(index / 2 % 15);
      const Wide margin = std::pow(Wide(10), -decade), size = size_of(p), gap = gap_of_boxes(p);
      decades.insert(decade);
      const Wide least = index % 2 == 1 ? -margin : turns ? 0 : margin;
      ASSERT_LE(gap, (index % 2 == 0 ? margin : decade == 1 ? 1 : 0) * size + construction_tol * size) << i;
      // The direction square to nearly parallel edges is not known so well.
      if (std::string_view(name) == "box_edges" && least_sine(p) < 1e-3L) continue;
      ASSERT_GE(gap, (least - construction_tol) * size) << name << ' ' << i;
    }
    EXPECT_EQ(decades.size(), 15u) << name;
  }
}

TEST(BoxFamilies, HaveTheAnglesTheyName) {
  for (const char* name : {"box_edges", "box_flush"}) {
    std::map<int, int> decades;
    for (std::uint64_t i = 0; i < 3000; ++i)
      if (const Pair p = draw(name, i); has_kinds(p, SolidKind::box, SolidKind::box))
        ++decades[static_cast<int>(-std::floor(std::log10(std::max(least_sine(p), 1e-17L))))];
    for (int d = 2; d <= 15; ++d) EXPECT_GT(decades[d], 5) << name << ' ' << d;
  }
}

TEST(BoxFamilies, HaveThePosesTheyName) {
  int equal = 0, touching = 0, inside = 0, through = 0;
  std::map<int, int> gaps;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    Pair p = draw("box_stacked", i);
    ASSERT_LE(least_sine(p), 1e-15L);
    equal += p.a.edges == p.b.edges;
    if (has_kinds(p, SolidKind::box, SolidKind::box)) {
      const Wide gap = gap_of_boxes(p);
      touching += gap == 0;
      if (gap > 0) ++gaps[static_cast<int>(-std::floor(std::log10(gap / size_of(p))))];
    }

    p = draw("box_nested", i);
    const bool a_outer = size_of({p.a, Solid{}}) > size_of({p.b, Solid{}});
    const Solid& outer = a_outer ? p.a : p.b;
    const Solid& inner = a_outer ? p.b : p.a;
    const Terms<Wide> of_outer = terms_of<Wide>(outer), of_inner = terms_of<Wide>(inner);
    const Wide3 delta = lifted<Wide>(inner.center) - lifted<Wide>(outer.center);
    Wide most = -INFINITY;
    for (std::size_t e = 0; e < 3; ++e)
      most = std::max(most, std::abs(dot(delta, of_outer.edges[e])) + support(of_inner, of_outer.edges[e]) -
                                of_outer.halves[e] - of_outer.rounding);
    (most < 0 ? inside : through) += 1;
    const Wide inner_size = size_of({inner, Solid{}});
    ASSERT_LE(std::abs(most), 0.11L * inner_size + 1e-14L) << i << ' ' << format_pair(p);
  }
  EXPECT_GT(equal, 400);
  EXPECT_GT(touching, 50);
  for (int d = 2; d <= 14; ++d) EXPECT_GT(gaps[d], 3) << d;
  EXPECT_GT(inside, 400);
  EXPECT_GT(through, 400);
}

}  // namespace
}  // namespace cyl
