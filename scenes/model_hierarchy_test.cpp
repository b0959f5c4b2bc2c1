// SPDX-License-Identifier: MIT
#include "scenes/model_hierarchy.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "corpus/pairs/families.hpp"
#include "oracles/referee/referee.hpp"

namespace cyl {
namespace {

/// Whether the referee proves them within the clearance (1), apart (0), or neither (-1).
int truth_of(const Pair& pair, double clearance) {
  if (clearance == 0) {
    const Verdict v = judge_verdict(pair).verdict;
    return v == Verdict::disjoint ? 0 : v == Verdict::intersecting || v == Verdict::touching ? 1 : -1;
  }
  const Enclosure d = enclose_distance(pair, judge(pair));
  return d.lo > clearance ? 0 : d.hi <= clearance ? 1 : -1;
}

/// In sizes: 1 % above or below the distance where they are apart, else some.
double clearance_near(const Pair& pair, std::uint64_t way) {
  const double gap = enclose_distance(pair, judge(pair)).lo / size_of(pair);
  return gap < 1e-6 || way > 1 ? 0.01 : way == 0 ? 1.01 * gap : 0.99 * gap;
}

struct Tried {
  std::array<int, rung_count> apart{}, within{};
};

/// No rung is wrong where it decides; the exact ones may be inside the bounds that they tell.
Tried expect_never_wrong(bool with_clearance) {
  Tried tried;
  for (const Family& family : families()) {
    for (std::uint64_t i = 0; i < 40; ++i) {
      const Pair pair = family.generate(20261121, i);
      // Needles of the smallest and greatest doubles are for the solver's own tests.
      const double size = size_of(pair);
      if (!(size > 1e-100 && size < 1e100)) continue;
      const double clearance = with_clearance ? clearance_near(pair, i % 4) * size : 0;
      const int truth = truth_of(pair, clearance);
      if (truth < 0) continue;
      const Models a = make_models(pair.a, clearance), b = make_models(pair.b, clearance);
      for (const Rung rung : all_rungs) {
        const Look seen = look(rung, a, b, clearance);
        EXPECT_EQ(seen, look(rung, b, a, clearance)) << to_string(rung);
        if (seen == Look::closer) continue;
        ++(seen == Look::apart ? tried.apart : tried.within)[static_cast<std::size_t>(rung)];
        if ((seen == Look::within) == (truth == 1)) continue;
        const double reach = size + (pair.b.center - pair.a.center).norm();
        const Enclosure d = enclose_distance(pair, judge(pair), 1e-15);  // as narrow as doubles have it
        const double miss = std::max(std::abs(d.lo - clearance), std::abs(d.hi - clearance));
        const bool proved = rung != Rung::cylinder && rung != Rung::distance;
        EXPECT_TRUE(!proved && miss <= 1e-13 * reach)
            << family.name << ' ' << i << ": " << to_string(rung) << " by " << miss / reach;
      }
    }
  }
  return tried;
}

TEST(Ladder, NoRungIsWrongAtTouch) {
  const Tried tried = expect_never_wrong(false);
  EXPECT_GT(tried.apart[0], 50);
  EXPECT_GT(tried.apart[1], 100);
  EXPECT_GT(tried.within[2], 100);
  EXPECT_EQ(tried.within[0] + tried.within[1] + tried.apart[2], 0);
}

TEST(Ladder, NoRungIsWrongAtAClearance) {
  const Tried tried = expect_never_wrong(true);
  for (const Rung rung : {Rung::sphere, Rung::outer, Rung::cylinder, Rung::distance, Rung::certified})
    EXPECT_GT(tried.apart[static_cast<std::size_t>(rung)], 20) << to_string(rung);
  for (const Rung rung : {Rung::inner, Rung::cylinder, Rung::distance, Rung::certified})
    EXPECT_GT(tried.within[static_cast<std::size_t>(rung)], 50) << to_string(rung);
}

/// Two upright rods side by side, `gap` apart.
std::pair<Models, Models> rods(double gap, double clearance) {
  return {make_models({{0, 0, 0}, {0, 0, 1}, 1, 6}, clearance),
          make_models({{2 + gap, 0, 0}, {0, 0, 1}, 1, 6}, clearance)};
}

TEST(Ladder, EachModelKnowsItsWorth) {
  const auto [a, b] = rods(0.5, 0);
  EXPECT_EQ(look(Rung::sphere, a, b, 0), Look::closer);  // the balls overlap
  EXPECT_EQ(look(Rung::outer, a, b, 0), Look::apart);
  EXPECT_TRUE(trusted(Rung::sphere, a, b, 0));
  EXPECT_FALSE(trusted(Rung::outer, a, b, 0));
  const auto [c, d] = rods(0.5, 0.6);
  EXPECT_EQ(look(Rung::outer, c, d, 0.6), Look::closer);
  EXPECT_EQ(look(Rung::inner, c, d, 0.6), Look::within);
  EXPECT_EQ(look(Rung::cylinder, c, d, 0.6), Look::closer);  // the grown ones meet, the given ones do not
  EXPECT_EQ(look(Rung::distance, c, d, 0.6), Look::within);
  EXPECT_EQ(look(Rung::certified, c, d, 0.6), Look::within);
}

TEST(Ladder, APlanAsksInOrder) {
  const auto [a, b] = rods(0.5, 0);
  EXPECT_FALSE(within({{true, true, false}, Rung::sphere}, a, b, 0));  // settled before the last
  EXPECT_TRUE(within({{true, false, true}, Rung::sphere}, a, b, 0));
  EXPECT_FALSE(within({{}, Rung::cylinder}, a, b, 0));
  const auto [c, d] = rods(-0.5, 0);
  EXPECT_TRUE(within({{true, true, true}, Rung::cylinder}, c, d, 0));
}

}  // namespace
}  // namespace cyl
