// SPDX-License-Identifier: MIT
#include "corpus/pairs/pair_digest.hpp"

#include <gtest/gtest.h>

#include <set>

namespace cyl {
namespace {

TEST(PairDigest, EveryNumberChangesTheDigest) {
  const Solid unit{{1, 2, 3}, {4, 5, 6}, 7, 8, 9};
  Pair pair{unit, unit};
  std::set<std::uint64_t> digests{digest_of(pair, 0)};
  for (Solid* c : {&pair.a, &pair.b}) {
    for (double* x : numbers_of(*c)) {
      const double before = *x;
      *x += 1;
      EXPECT_TRUE(digests.insert(digest_of(pair, 0)).second) << before;
      *x = before;
    }
  }
}

}  // namespace
}  // namespace cyl
