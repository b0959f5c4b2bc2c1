// SPDX-License-Identifier: MIT
// What needs no referee; that verdict, margin and feature are as built: oracles/trial/contact_test.cpp.
#include "corpus/pairs/strata.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "base/fnv.hpp"
#include "corpus/pairs/pair_io.hpp"

namespace cyl {
namespace {

constexpr std::uint64_t seed = 20261121;

TEST(Strata, NameTheFeatures) {
  ASSERT_EQ(contact_features().size(), contact_feature_count);
  EXPECT_EQ(contact_features()[0], "side-side");
  EXPECT_EQ(contact_features()[6], "containment");
  for (const std::string_view name : contact_features())
    EXPECT_EQ(to_string(*find_contact_feature(name)), name);
  EXPECT_FALSE(find_contact_feature("rim-side"));
}

TEST(Strata, AreFilledButForTheCellsNamed) {
  std::set<std::string> seen;
  for (const std::string_view name : contact_features())
    for (int decade = first_decade - 1; decade <= last_decade + 1; ++decade)
      for (std::uint64_t index = 0; index < 20; ++index) {
        const ContactFeature feature = *find_contact_feature(name);
        const auto pair = draw_in_stratum(feature, decade, seed, index);
        const bool empty = decade < first_decade || decade > last_decade ||
                           (feature == ContactFeature::containment && decade == last_decade);
        ASSERT_EQ(pair.has_value(), !empty) << name << " " << decade;
        if (!pair) continue;
        EXPECT_EQ(find_defect(pair->a), Defect::none);
        EXPECT_EQ(find_defect(pair->b), Defect::none);
        EXPECT_TRUE(seen.insert(format_pair(*pair)).second) << name << " " << decade << " " << index;
        EXPECT_EQ(format_pair(*draw_in_stratum(feature, decade, seed, index)), format_pair(*pair));
        EXPECT_NE(format_pair(*draw_in_stratum(feature, decade, seed + 1, index)), format_pair(*pair));
      }
}

TEST(Strata, AreTheSameOnEveryMachine) {
  std::uint64_t digest = fnv1a({});
  for (const std::string_view name : contact_features())
    for (int decade = first_decade; decade <= last_decade; ++decade)
      for (std::uint64_t index = 0; index < 20; ++index)
        if (const auto pair = draw_in_stratum(*find_contact_feature(name), decade, seed, index))
          digest = fnv1a(format_pair(*pair), digest);
  EXPECT_EQ(digest, 9218288875759756704u);
}

}  // namespace
}  // namespace cyl
