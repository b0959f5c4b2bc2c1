// SPDX-License-Identifier: MIT
#include "fuzz/guided/mutator.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>

#include "corpus/pairs/families.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/touch_plane.hpp"
#include "fuzz/guided/counters.hpp"
#include "oracles/methods/adapter.hpp"

namespace cyl {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

const Move& move_named(std::string_view name) {
  return *std::find_if(moves().begin(), moves().end(), [&](const Move& m) { return m.name == name; });
}

/// Applies the move to many pairs of a family.
template <class Accept>
void look_at(std::string_view name, Accept look, std::string_view family = "random") {
  for (std::uint64_t i = 0; i < 200; ++i) {
    Pair pair = find_family(family)->generate(1, i);
    RandomStream stream("mutator_test", 1, i);
    move_named(name).apply(pair, stream);
    look(pair);
  }
}

double sine(const Pair& p) { return unit_axis(p.a.axis).cross(unit_axis(p.b.axis)).norm(); }
double cosine(const Pair& p) { return std::fabs(inner_product(unit_axis(p.a.axis), unit_axis(p.b.axis))); }

TEST(Mutator, KeepsLegalPairsLegalOfAnyForm) {
  for (const Family& family : campaign_families())
    for (std::uint64_t i = 0; i < 100; ++i) {
      const Pair before = family.generate(1, i), after = mutate(before, i);
      EXPECT_TRUE(is_legal(after)) << format_pair(before);
    }
}

TEST(Mutator, MakesNumbersOfAnyBitsLegal) {
  RandomStream stream("bits", 1, 0);
  Pair pair{{{NAN, infinity, 0}, {0, 0, 0}, -1, -infinity, -2},
            {{1, 2, 3}, {-0.0, 0, NAN}, NAN, 5e-324, NAN}};
  for (std::uint64_t i = 0; i < 100; ++i) EXPECT_TRUE(is_legal(mutate(pair, i)));
}

TEST(Mutator, IsAFunctionOfPairAndSeed) {
  const Pair pair = find_family("random")->generate(1, 0);
  std::map<std::string, int> different;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    EXPECT_EQ(format_pair(mutate(pair, seed)), format_pair(mutate(pair, seed)));
    ++different[format_pair(mutate(pair, seed))];
  }
  EXPECT_GT(different.size(), 90u);
}

TEST(Mutator, TurnsAxesToEveryDecadeOfTheAngle) {
  std::map<std::size_t, int> parallel, right;
  const auto decade = [](double x) {
    return x == 0 ? std::size_t{99} : static_cast<std::size_t>(-std::floor(std::log10(x)));
  };
  look_at("turn_to_parallel", [&](const Pair& p) { ++parallel[decade(sine(p))]; });
  look_at("turn_to_perpendicular", [&](const Pair& p) { ++right[decade(cosine(p))]; });
  for (std::size_t d = 3; d <= 15; ++d) EXPECT_GT(parallel[d], 0) << d;
  for (std::size_t d = 3; d <= 15; ++d) EXPECT_GT(right[d], 0) << d;
  EXPECT_GT(parallel[99], 20);
}

TEST(Mutator, SlidesToEveryDecadeOfTheMargin) {
  std::map<std::size_t, int> decades;
  look_at("slide_to_touching",
          [&](const Pair& p) { ++decades[stratum_of(p, approximate_distance(p)).decade]; });
  for (std::size_t d = 1; d <= 14; ++d) EXPECT_GT(decades[d], 0) << d;
  EXPECT_GT(decades[16] + decades[15], 40);
}

TEST(Mutator, MakesWhatTheNamesSay) {
  look_at("flatten",
          [](const Pair& p) { EXPECT_LE(std::min(p.a.height / p.a.radius, p.b.height / p.b.radius), 1.01); });
  look_at("make_equal", [](const Pair& p) { EXPECT_EQ(format_pair({p.a, p.b}), format_pair({p.b, p.a})); });
  look_at("make_coaxial", [](const Pair& p) {
    EXPECT_EQ(sine(p), 0);
    const Vector3 apart = p.b.center - p.a.center;
    EXPECT_LE(unit_axis(p.a.axis).cross(apart).norm(), 1e-13 * (p.a.center.norm() + apart.norm()));
  });
  std::map<SolidKind, int> kinds;
  const auto count = [&](const Pair& p) { ++kinds[kind_of(p.a)], ++kinds[kind_of(p.b)]; };
  for (const char* name : {"round_edges", "round_off", "make_half_space", "make_box"}) look_at(name, count);
  look_at("round_edges", count, "box_box");
  for (const SolidKind kind : enum_values<SolidKind>) EXPECT_GT(kinds[kind], 20) << to_string(kind);
  look_at("move_to_origin", [](const Pair& p) { EXPECT_TRUE(p.a.center.isZero(0)); });
  look_at("snap_to_grid", [](const Pair& p) {
    EXPECT_EQ(std::ldexp(p.a.radius, 10), std::nearbyint(std::ldexp(p.a.radius, 10)));
  });
}

TEST(CrossOver, TakesASolidOfEachParent) {
  Pair x = find_family("random")->generate(1, 0), y = find_family("random")->generate(1, 1);
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const Pair child = cross_over(x, y, seed);
    EXPECT_TRUE(child.a.radius == x.a.radius || child.a.radius == x.b.radius);
    EXPECT_TRUE(child.b.radius == y.a.radius || child.b.radius == y.b.radius);
  }
}

}  // namespace
}  // namespace cyl
