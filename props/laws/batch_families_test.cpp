// SPDX-License-Identifier: MIT
// The batch kernels against intersect on the families: another instruction set, the same verdict.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "corpus/pairs/families.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "solver/intersect_batch.hpp"

namespace cyl {
namespace {

constexpr std::uint32_t pairs_per_family = 2000;
constexpr std::uint64_t family_seed = 20261121;

TEST(BatchOnFamilies, GivesWhatIntersectGives) {
  for (const Family& family : families()) {
    std::vector<Pair> pairs;
    std::vector<Prepared> a, b;
    std::vector<IndexPair> indices;
    for (std::uint32_t i = 0; i < pairs_per_family; ++i) {
      pairs.push_back(family.generate(family_seed, i));
      a.push_back(prepare(pairs[i].a));
      b.push_back(prepare(pairs[i].b));
      indices.push_back({i, i});
    }
    for (const Instructions set : {Instructions::baseline, Instructions::v3, Instructions::v4}) {
      if (set > best_instructions()) continue;
      std::vector<Verdict> verdicts(pairs_per_family);
      intersect_batch(a, b, indices, verdicts.data(), set);
      for (std::uint32_t i = 0; i < pairs_per_family; ++i)
        ASSERT_EQ(verdicts[i], intersect(a[i], b[i])) << family.name << " " << static_cast<int>(set) << "\n"
                                                      << format_pair(pairs[i]);
    }
  }
}

}  // namespace
}  // namespace cyl
