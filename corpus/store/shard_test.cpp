// SPDX-License-Identifier: MIT
#include "corpus/store/shard.hpp"

#include <gtest/gtest.h>

namespace cyl {
namespace {

TEST(Shard, EveryIndexIsOfOneShardAndIsCounted) {
  for (std::uint64_t count : {1u, 2u, 3u, 7u}) {
    for (std::uint64_t batch : {1u, 4u, 5u}) {
      for (std::uint64_t i = 0; i < 100; ++i) {
        int owners = 0;
        std::uint64_t below = 0;
        for (std::uint64_t index = 0; index < count; ++index) {
          const Shard shard{index, count, batch};
          const bool own = i / batch % count == index;
          owners += shard.first_from(i) == i;
          EXPECT_EQ(shard.first_from(i) == i, own);
          EXPECT_EQ(shard.below(i + 1) - shard.below(i), own ? 1u : 0u);
          EXPECT_EQ(shard.below(shard.first_from(i)), shard.below(i)) << "nothing of its own is passed over";
          EXPECT_GT(shard.batch_end(i), i);
          EXPECT_EQ(shard.batch_end(i) % batch, 0u);
          below += shard.below(i);
        }
        EXPECT_EQ(owners, 1);
        EXPECT_EQ(below, i);
      }
    }
  }
}

}  // namespace
}  // namespace cyl
