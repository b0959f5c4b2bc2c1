// SPDX-License-Identifier: MIT
#include "fuzz/campaign/derived.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/methods/method.hpp"
#include "oracles/trial/trial.hpp"

namespace cyl {
namespace {

/// A ball of wire beside another, 2 apart along x.
Pair apart() { return {{{0, 0, 0}, {0, 0, 1}, 1, 2}, {{4, 0, 0}, {0, 0, 1}, 1, 2}}; }

TEST(Derived, FeedsBackWhatIsSaid) {
  const Pair touching = fed_back(Feedback::into_contact, apart()).value();
  EXPECT_EQ(touching.b.center.x(), 2);
  EXPECT_EQ(fed_back(Feedback::to_the_other_side, apart())->b.center.x(), 0);
  EXPECT_EQ(fed_back(Feedback::onto_the_point, apart())->b.center.x(), 1);
  EXPECT_EQ(fed_back(Feedback::points_together, apart())->b.center.x(), 2);
  EXPECT_EQ(std::abs(fed_back(Feedback::axis_along_normal, apart())->b.axis.x()), 1);
  EXPECT_EQ(fed_back(Feedback::length_of_distance, apart())->a.radius, 2);
}

TEST(Derived, IsAFunctionOfSeedAndIndexAndComesNearTouching) {
  std::size_t near = 0;
  for (std::uint64_t i = 0; i < 500; ++i) {
    const Pair pair = derived_family().generate(7, i);
    EXPECT_EQ(format_pair(pair), format_pair(derived_family().generate(7, i)));
    ASSERT_TRUE(is_legal(pair));
    Trial trial(pair);
    near +=
        trial.decided() && size_of(pair) > 0 && std::abs(trial.distance_at(1e-15).lo) < 1e-14 * size_of(pair);
  }
  EXPECT_GT(near, 100u) << "a fifth is within some units in the last place of touching";
}

TEST(Derived, OursAreNeverWrong) {
  const auto methods = own_methods();
  std::vector<Pair> pairs;
  for (std::uint64_t i = 0; i < 2000; ++i) pairs.push_back(derived_family().generate(11, i));
  for (const Trial& trial : try_methods(methods, pairs, Caps{}))
    for (std::size_t m = 0; m < methods.size(); ++m)
      EXPECT_FALSE(trial.findings[m] && trial.findings[m]->severity == Severity::contract)
          << methods[m]->name() << ' ' << format_pair(trial.pair);
}

}  // namespace
}  // namespace cyl
