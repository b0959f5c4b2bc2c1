// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "corpus/pairs/families.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "props/gate/sample.hpp"

namespace cyl {
namespace {

constexpr std::uint64_t seed = 20261121, rounds = 80;

std::set<std::string> kinds_of(SampleRound (*draw)(std::uint64_t, std::uint64_t)) {
  std::set<std::string> kinds;
  for (std::uint64_t round = 0; round < rounds; ++round)
    for (const std::string& origin : draw(seed, round).origins)
      kinds.insert(origin.substr(0, origin.find(", seed ")));
  return kinds;
}

TEST(LawPairs, KindsTakeTurns) {
  const std::set<std::string> kinds = kinds_of(draw_law_pairs);
  EXPECT_TRUE(kinds.contains("grid"));
  EXPECT_GT(kinds.size(), 50u);
  for (const std::string& kind : kinds_of(draw_close_law_pairs))
    EXPECT_TRUE(kind.starts_with("close ") || kind.starts_with("family close_") ||
                kind == "family range_ends" || kind == "family whiskers")
        << kind;
  const std::set<std::string> rounded = kinds_of(draw_rounded_law_pairs);
  EXPECT_TRUE(rounded.contains("stratum sphere-box"));
  for (const Family& family : campaign_families().subspan(families().size()))
    EXPECT_TRUE(rounded.contains("family " + std::string(family.name))) << family.name;
}

TEST(LawPairs, AreAPureFunctionOfSeedAndRound) {
  for (const auto draw : {draw_law_pairs, draw_close_law_pairs, draw_rounded_law_pairs}) {
    const SampleRound once = draw(seed, 3), again = draw(seed, 3);
    ASSERT_EQ(once.pairs.size(), once.origins.size());
    ASSERT_EQ(once.origins, again.origins);
    EXPECT_GT(once.pairs.size(), draws_per_round * pairs_per_draw / 2);
    for (std::size_t i = 0; i < once.pairs.size(); ++i) {
      EXPECT_EQ(format_pair(once.pairs[i]), format_pair(again.pairs[i]));
      EXPECT_EQ(find_defect(once.pairs[i].a), Defect::none);
    }
    EXPECT_NE(format_pair(draw(seed, 4).pairs[0]), format_pair(once.pairs[0]));
    EXPECT_NE(format_pair(draw(seed + 1, 3).pairs[0]), format_pair(once.pairs[0]));
  }
}

}  // namespace
}  // namespace cyl
