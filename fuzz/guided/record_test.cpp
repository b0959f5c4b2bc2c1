// SPDX-License-Identifier: MIT
#include "fuzz/guided/record.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <limits>

namespace cyl {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Record, LaysOutSixteenDoublesInTheOrderOfTheWords) {
  const Pair pair{{{0, 1, 2}, {3, 4, 5}, 6, 7}, {{8, 9, 10}, {11, 12, 13}, 14, 15}};
  const auto numbers = std::bit_cast<std::array<double, 16>>(encode_record(pair));
  for (std::size_t i = 0; i < numbers.size(); ++i) EXPECT_EQ(numbers[i], static_cast<double>(i));
}

TEST(Record, KeepsEveryBit) {
  const Pair pair{{{-0.0, 0x1p-1074, 0x1.fffffffffffffp1023}, {nan, -nan, 1 / 3.0}, 0x1p-1022, 5},
                  {{1, 2, 3}, {4, 5, 6}, std::numeric_limits<double>::infinity(), -7}};
  const Record record = encode_record(pair);
  EXPECT_EQ(encode_record(decode_record(record)), record);
}

}  // namespace
}  // namespace cyl
