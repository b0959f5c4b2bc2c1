// SPDX-License-Identifier: MIT
#include "scenes/study/model_hierarchy.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "corpus/pairs/families.hpp"
#include "oracles/referee/referee.hpp"
#include "scenes/study/verification.hpp"

namespace cyl {
namespace {

/// Relative to the size: 1 % above or below the distance of disjoint solids, else a hundredth.
double clearance_near(const Pair& pair, std::uint64_t way) {
  const double gap = enclose_distance(pair, judge(pair)).lo / size_of(pair);
  return gap < 1e-6 || way > 1 ? 0.01 : way == 0 ? 1.01 * gap : 0.99 * gap;
}

struct Tried {
  std::array<int, level_count> apart{}, within{};
};

/// Checks that no level is wrong if it decides. Only cylinder and distance may be, within their bounds.
Tried expect_never_wrong(bool with_clearance) {
  Tried tried;
  for (const Family& family : families()) {
    for (std::uint64_t i = 0; i < 40; ++i) {
      const Pair pair = family.generate(20261121, i);
      // The solver's own tests cover needles of the smallest and greatest doubles.
      const double size = size_of(pair);
      if (!(size > 1e-100 && size < 1e100)) continue;
      const double clearance = with_clearance ? clearance_near(pair, i % 4) * size : 0;
      const auto truth = referee_within(pair, clearance);
      if (!truth) continue;
      const ProxyModels a = make_models(pair.a), b = make_models(pair.b);
      for (const Level level : enum_values<Level>) {
        const Proximity seen = proximity(level, a, b, clearance);
        EXPECT_EQ(seen, proximity(level, b, a, clearance)) << to_string(level);
        if (seen == Proximity::unclear) continue;
        ++(seen == Proximity::apart ? tried.apart : tried.within)[index_of(level)];
        if ((seen == Proximity::within) == *truth) continue;
        const double reach = size + (pair.b.center - pair.a.center).norm();
        const Enclosure d = enclose_distance(pair, judge(pair), 1e-15);  // as narrow as doubles allow
        const double miss = std::max(std::abs(d.lo - clearance), std::abs(d.hi - clearance));
        const bool proved = level != Level::cylinder && level != Level::distance;
        EXPECT_TRUE(!proved && miss <= 1e-13 * reach)
            << family.name << ' ' << i << ": " << to_string(level) << " by " << miss / reach;
      }
    }
  }
  return tried;
}

TEST(ModelHierarchy, NoLevelIsWrongAtTouch) {
  const Tried tried = expect_never_wrong(false);
  EXPECT_GT(tried.apart[0], 50);
  EXPECT_GT(tried.apart[1], 100);
  EXPECT_GT(tried.within[2], 100);
  EXPECT_GT(tried.apart[index_of(Level::box)], 100);
  EXPECT_EQ(tried.within[index_of(Level::box)], 0);
  EXPECT_EQ(tried.within[0] + tried.within[1] + tried.apart[2], 0);
}

TEST(ModelHierarchy, NoLevelIsWrongAtAClearance) {
  const Tried tried = expect_never_wrong(true);
  for (const Level level : {Level::sphere, Level::outer, Level::cylinder, Level::distance, Level::certified})
    EXPECT_GT(tried.apart[index_of(level)], 20) << to_string(level);
  for (const Level level : {Level::inner, Level::cylinder, Level::distance, Level::certified})
    EXPECT_GT(tried.within[index_of(level)], 50) << to_string(level);
}

/// Two upright rods side by side, with this gap.
std::pair<ProxyModels, ProxyModels> rods(double gap) {
  return {make_models({{0, 0, 0}, {0, 0, 1}, 1, 6}), make_models({{2 + gap, 0, 0}, {0, 0, 1}, 1, 6})};
}

TEST(ModelHierarchy, EachModelKnowsItsWorth) {
  const auto [a, b] = rods(0.5);
  EXPECT_EQ(proximity(Level::sphere, a, b, 0), Proximity::unclear);  // the balls overlap
  EXPECT_EQ(proximity(Level::outer, a, b, 0), Proximity::apart);
  EXPECT_TRUE(accepted(Level::sphere, a, b, 0));
  EXPECT_FALSE(accepted(Level::outer, a, b, 0));
  const auto [c, d] = rods(0.5);
  EXPECT_EQ(proximity(Level::outer, c, d, 0.6), Proximity::unclear);
  EXPECT_EQ(proximity(Level::inner, c, d, 0.6), Proximity::within);
  EXPECT_EQ(proximity(Level::cylinder, c, d, 0.6), Proximity::within);
  EXPECT_EQ(proximity(Level::distance, c, d, 0.6), Proximity::within);
  EXPECT_EQ(proximity(Level::certified, c, d, 0.6), Proximity::within);
}

// A plane is given by any of its points, which need not be near the other solid.
TEST(ModelHierarchy, AHalfSpaceIsAModelOfItself) {
  const ProxyModels floor = make_models({.center = {900, -70, 0}, .shape = Shape::half_space});
  const ProxyModels above = make_models({{0, 0, 1.5}, {0, 0, 1}, 1, 2}),
                    into = make_models({{0, 0, 0.5}, {0, 0, 1}, 1, 2});
  EXPECT_EQ(proximity(Level::sphere, floor, above, 0.05), Proximity::apart);
  EXPECT_EQ(proximity(Level::sphere, above, floor, 0.2), Proximity::unclear);
  EXPECT_EQ(proximity(Level::sphere, floor, into, 0), Proximity::unclear);
  EXPECT_EQ(proximity(Level::inner, floor, into, 0), Proximity::within);
}

TEST(Verification, CallsNoAnswerWrongThatOnlyRoundingDecides) {
  Verification v;
  for (const double gap : {0x1p-50, -0x1p-50, 1e-9, -1e-9}) {
    const Solid cube{.shape = Shape::box, .edges = {1, 1, 1}};
    Solid above = cube;
    above.center = {0, 0, 1 + gap};
    v.add({cube, above}, 0, 0, gap > 0);
  }
  EXPECT_EQ(v.tolerated, 2u);
  EXPECT_EQ(v.wrong, 2u);
}

TEST(ModelHierarchy, ACascadeAsksInOrder) {
  const auto [a, b] = rods(0.5);
  EXPECT_FALSE(within({{true, true, false}, Level::sphere}, a, b, 0));  // decided before the last level
  EXPECT_TRUE(within({{true, false, true}, Level::sphere}, a, b, 0));
  EXPECT_FALSE(within({{}, Level::cylinder}, a, b, 0));
  const auto [c, d] = rods(-0.5);
  EXPECT_TRUE(within({{true, true, true}, Level::cylinder}, c, d, 0));
}

}  // namespace
}  // namespace cyl
