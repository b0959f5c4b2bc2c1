// SPDX-License-Identifier: MIT
#include "corpus/pairs/pair_digest.hpp"

#include <gtest/gtest.h>

#include <set>

#include "base/enum_words.hpp"

namespace cyl {
namespace {

TEST(PairDigest, EveryNumberChangesTheDigest) {
  const Solid cylinder{{1, 2, 3}, {4, 5, 6}, 7, 8, 9};
  const Solid box{.center = {1, 2, 3},
                  .rounding = 9,
                  .shape = Shape::box,
                  .edges = {10, 11, 12},
                  .quaternion = {13, 14, 15, 16}};
  std::set<std::uint64_t> digests;
  for (Pair pair : {Pair{cylinder, cylinder}, Pair{cylinder, box}, Pair{box, cylinder}, Pair{box, box}}) {
    EXPECT_TRUE(digests.insert(digest_of(pair, 0)).second);
    for (Solid* c : {&pair.a, &pair.b}) {
      for (const std::size_t place : places_of(c->shape)) {
        double& x = *numbers_of(*c)[place];
        const double before = x;
        x += 1;
        EXPECT_TRUE(digests.insert(digest_of(pair, 0)).second) << to_string(c->shape) << ' ' << before;
        x = before;
      }
    }
  }
}

}  // namespace
}  // namespace cyl
