// SPDX-License-Identifier: MIT
// The tests that need no referee. oracles/trial/contact_test.cpp tests verdict, margin and feature.
#include "corpus/pairs/strata.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "base/fnv.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/pairs/pair_numbers.hpp"

namespace cyl {
namespace {

constexpr std::uint64_t seed = 20261121;

TEST(Strata, AreFilledButForTheCellsNamed) {
  std::set<std::string> seen;
  for (const ContactFeature feature : enum_values<ContactFeature>)
    for (int decade = first_decade - 1; decade <= last_decade + 1; ++decade)
      for (std::uint64_t index = 0; index < 20; ++index) {
        const auto pair = draw_in_stratum(feature, decade, seed, index);
        const bool empty = decade < first_decade || decade > last_decade ||
                           (feature == ContactFeature::containment && decade == last_decade);
        ASSERT_EQ(pair.has_value(), !empty) << to_string(feature) << " " << decade;
        if (!pair) continue;
        EXPECT_EQ(find_defect(pair->a), Defect::none);
        EXPECT_EQ(find_defect(pair->b), Defect::none);
        EXPECT_TRUE(seen.insert(format_pair(*pair)).second)
            << to_string(feature) << " " << decade << " " << index;
        EXPECT_EQ(format_pair(*draw_in_stratum(feature, decade, seed, index)), format_pair(*pair));
        EXPECT_NE(format_pair(*draw_in_stratum(feature, decade, seed + 1, index)), format_pair(*pair));
      }
}

TEST(Strata, AreTheSameOnEveryMachine) {
  std::uint64_t digest = fnv1a({});
  for (const Pair& pair : draw_in_all_strata(20, seed)) digest = fnv1a(format_pair(pair), digest);
  EXPECT_EQ(digest, 9218288875759756704u);
}

TEST(Strata, OfShapesHaveTheKindsTheyName) {
  std::set<std::string> seen;
  for (std::size_t k = 0; k < drawn_kinds.size(); ++k)
    for (std::uint64_t index = 0; index < 300; ++index) {
      const Pair pair = draw_in_stratum(drawn_kinds[k], seed, index);
      ASSERT_TRUE(is_legal(pair)) << format_pair(pair);
      EXPECT_EQ(number_of_kinds(pair), k) << format_pair(pair);
      EXPECT_TRUE(seen.insert(format_pair(pair)).second) << format_pair(pair);
    }
  EXPECT_EQ(number_of_kinds({{}, {}}), drawn_kinds.size());
}

}  // namespace
}  // namespace cyl
