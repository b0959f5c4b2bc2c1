// SPDX-License-Identifier: MIT
// The distances of close contacts are as built, and the referee decides all of them.
#include "corpus/pairs/close_contact.hpp"

#include <gtest/gtest.h>

#include <map>

#include "base/from_environment_test.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "oracles/referee/referee.hpp"
#include "oracles/trial/compare.hpp"

namespace cyl {
namespace {

/// Relative to the size. It covers the roundings of two axes, two contacts and a centre.
constexpr double construction_error = 4e-15;

TEST(CloseContact, GapsAreAsBuiltAndOverlapsNoDeeper) {
  std::map<Verdict, std::uint64_t> overlaps;
  std::uint64_t gaps = 0;
  const std::uint64_t rounds = from_environment("DAYLIGHT_CLOSE_ROUNDS", 3);
  for (std::uint64_t round = 0; round < rounds; ++round) {
    for (const CloseContact& c : draw_close_round(20261121, round)) {
      const Truth truth = judge(c.pair);
      const double size = size_of(c.pair), off = construction_error * size;
      if (c.distance < 0) {
        ++overlaps[truth.verdict];
        // The enclosure of a small depth takes too many cells.
        const double margin = -c.distance / size;
        if (truth.verdict == Verdict::intersecting && margin > 1e-4) {
          ASSERT_GE(enclose_distance(c.pair, truth, margin / 4).hi, c.distance - off) << format_pair(c.pair);
        }
        continue;
      }
      ++gaps;
      ASSERT_EQ(truth.verdict, Verdict::disjoint) << format_pair(c.pair);
      const Enclosure proved = enclose_distance(c.pair, truth, 1e-15);
      ASSERT_LE(proved.lo, c.distance + off) << format_pair(c.pair);
      ASSERT_GE(proved.hi, c.distance - off) << format_pair(c.pair);
    }
  }
  EXPECT_EQ(overlaps[Verdict::undecided], 0u);
  EXPECT_GT(overlaps[Verdict::intersecting], 125 * rounds);
  EXPECT_GT(overlaps[Verdict::disjoint], 4 * rounds) << "flat solids that passed through each other";
  EXPECT_GT(gaps, 166 * rounds);
}

}  // namespace
}  // namespace cyl
