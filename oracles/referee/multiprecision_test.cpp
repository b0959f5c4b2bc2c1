// SPDX-License-Identifier: MIT
#include "oracles/referee/multiprecision.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

namespace cyl {
namespace {

MpFloat third_at(int bits) {
  const PrecisionScope precision(bits);
  return MpFloat(1) / MpFloat(3);
}

// On both sides of the cap below which digits are kept inside the object.
constexpr int precisions[] = {53, 128, 256, 257, 512};

TEST(MpFloat, KeepsItsDigitsThroughCopiesAndMoves) {
  for (const int from : precisions)
    for (const int to : precisions) {
      MpFloat third = third_at(from);
      const mpq_class digits = third.to_rational();
      MpFloat copy(third), assigned = third_at(to);
      third = -third;  // not through the copy
      assigned = copy;
      EXPECT_EQ(assigned.to_rational(), digits);
      EXPECT_EQ(copy.to_rational(), digits);
      MpFloat moved(std::move(copy)), move_assigned = -third_at(to);
      move_assigned = std::move(assigned);
      EXPECT_EQ(moved.to_rational(), digits);
      EXPECT_EQ(move_assigned.to_rational(), digits);
      move_assigned = third_at(to);
      EXPECT_EQ(move_assigned.to_rational(), third_at(to).to_rational());
    }
}

TEST(MpFloat, MovesWithItsDigitsWhereAVectorGrows) {
  std::vector<MpFloat> numbers;
  for (int i = 0; i < 100; ++i) numbers.push_back(third_at(precisions[i % 5]));
  for (int i = 0; i < 100; ++i)
    EXPECT_EQ(numbers[static_cast<std::size_t>(i)].to_rational(), third_at(precisions[i % 5]).to_rational());
}

TEST(MpFloat, KeepsTheSignOfZero) { EXPECT_TRUE(std::signbit(MpFloat(-0.0).to_double())); }

}  // namespace
}  // namespace cyl
