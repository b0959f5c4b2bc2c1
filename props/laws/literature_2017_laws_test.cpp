// SPDX-License-Identifier: MIT
// The exact laws and the text of 2017: put right it keeps them; as printed its verdict turns where the solids
// are swapped or an axis is reversed.
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
    for (const auto& method : methods) {
      if (method->name() == "seed2017-printed") continue;
      for (const int law : {1, 2, 3})
        EXPECT_EQ(broken_by(*method, law_numbered(law), pair), std::nullopt)
            << method->name() << ", law " << law << ", " << format_pair(pair);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Families, Literature2017Laws, testing::Range<std::size_t>(0, families().size()),
                         [](const auto& info) { return std::string(families()[info.param].name); });

// One quarter circle ends all, and which one that is depends on the roles and on the axes' senses.
TEST(Printed2017Laws, AVerdictTurnsWithTheRolesAndTheAxes) {
  const auto methods = literature_2017_methods();
  Method& printed = *methods.back();
  ASSERT_EQ(printed.name(), "seed2017-printed");
  const Family& random = *find_family("random");
  int swapped = 0, reversed0 = 0, reversed1 = 0;
  for (std::uint64_t index = 0; index < 20000; ++index) {
    const Pair pair = random.generate(1, index);
    const Verdict said = printed.ask(pair).verdict;
    const auto turns = [&](Pair other, double sign0, double sign1) {
      other.a.axis *= sign0;
      other.b.axis *= sign1;
      return printed.ask(other).verdict != said;
    };
    swapped += turns({pair.b, pair.a}, 1, 1);
    reversed0 += turns(pair, -1, 1);
    reversed1 += turns(pair, 1, -1);
  }
  EXPECT_GT(swapped, 40);
  EXPECT_GT(reversed0, 40);
  EXPECT_GT(reversed1, 40);
  RecordProperty("swapped", swapped);
  RecordProperty("reversed", reversed0);
}

}  // namespace
}  // namespace cyl
