// SPDX-License-Identifier: MIT
// The exact laws and the text of 2017: put right it keeps them; as printed it breaks none by itself, since
// the roles are put in order and the axes made to point one way before it is asked.
#include <gtest/gtest.h>

#include <cstdint>
#include <optional>

#include "corpus/pairs/families.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "props/laws/laws.hpp"

namespace cyl {
namespace {

class Literature2017Laws : public testing::TestWithParam<std::size_t> {};

TEST_P(Literature2017Laws, HoldBitForBit) {
  const auto methods = literature_2017_methods();
  for (std::uint64_t index = 0; index < 30; ++index) {
    const Pair pair = families()[GetParam()].generate(20170416, index);
    for (const auto& method : methods)
      for (const int law : {1, 2, 3})
        EXPECT_EQ(broken_by(*method, law_numbered(law), pair), std::nullopt)
            << method->name() << ", law " << law << ", " << format_pair(pair);
  }
}

INSTANTIATE_TEST_SUITE_P(Families, Literature2017Laws, testing::Range<std::size_t>(0, families().size()),
                         [](const auto& info) { return std::string(families()[info.param].name); });

}  // namespace
}  // namespace cyl
