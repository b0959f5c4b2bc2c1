// SPDX-License-Identifier: MIT
#include "corpus/pairs/size_range.hpp"

#include <gtest/gtest.h>

#include "corpus/pairs/pair_numbers.hpp"

namespace cyl {
namespace {

Solid solid(double radius, double height, double rounding = 0) {
  return {Vector3(1, 0, 0), Vector3(0, 0, 1), radius, height, rounding};
}

TEST(SizeOfAPair, SumsRadiiFullHeightsAndRoundingsOfBoundedSolids) {
  EXPECT_EQ(size_of({solid(1, 2, 4), solid(8, 16, 32)}), 63);
  Solid plane = solid(0, 0);
  plane.shape = Shape::half_space;
  EXPECT_EQ(size_of({plane, solid(1, 2, 4)}), 7);
  plane.center *= 1e9;
  EXPECT_EQ(size_of({solid(1, 2, 4), plane}), 7);
}

TEST(SizeRange, LimitsTheLengthsOfASolid) {
  const SizeRange range{.least = 0.1, .greatest = 10, .aspect = 20};
  EXPECT_TRUE(range.holds(solid(0.5, 10)));
  EXPECT_FALSE(range.holds(solid(0.09, 1)));
  EXPECT_FALSE(range.holds(solid(1, 10.5)));
  EXPECT_FALSE(range.holds(solid(0.4, 10))) << "an aspect of 25";
  EXPECT_FALSE(range.holds(Pair{solid(1, 1), solid(1, 11)}));
}

TEST(SizeRange, CountsNoMissingLengthOfSpheresAndCapsules) {
  const SizeRange range{.least = 0.1, .greatest = 10, .zero_lengths = false};
  EXPECT_TRUE(range.holds(solid(0, 0, 1))) << "sphere";
  EXPECT_TRUE(range.holds(solid(0, 2, 1))) << "capsule";
  EXPECT_FALSE(range.holds(solid(1, 0, 1))) << "rounded disk";
  EXPECT_FALSE(range.holds(solid(1, 0))) << "disk";
  EXPECT_FALSE(range.holds(solid(0, 1))) << "segment";
  EXPECT_TRUE(SizeRange{.least = 0.1}.holds(solid(1, 0)));
}

TEST(SizeRange, CountsTheEdgesOfBoxes) {
  const auto box = [](std::array<double, 3> edges, double rounding = 0) {
    return Solid{.rounding = rounding, .shape = Shape::box, .edges = edges};
  };
  const SizeRange range{.least = 0.1, .greatest = 10, .aspect = 20, .zero_lengths = false};
  EXPECT_TRUE(range.holds(box({0.5, 1, 10})));
  EXPECT_FALSE(range.holds(box({0.09, 1, 1})));
  EXPECT_FALSE(range.holds(box({1, 10.5, 1})));
  EXPECT_FALSE(range.holds(box({0.4, 1, 10}))) << "an aspect of 25";
  EXPECT_FALSE(range.holds(box({8, 8, 8}, 0.3))) << "the rounding counts too";
  EXPECT_FALSE(range.holds(box({1, 0, 1})));
  EXPECT_FALSE(range.holds(box({1, 0, 1}, 1)));
  EXPECT_TRUE(SizeRange{.least = 0.1}.holds(box({1, 0, 1})));
  const Pair large{box({100, 20, 8}), solid(0, 0, 40)};
  EXPECT_EQ(numbers_of(*fitted(large, {.greatest = 10})), numbers_of(scaled(large, -4)));
  EXPECT_EQ(size_of(large), 168);
  Pair apart{box({2, 4, 4}, 1), solid(0, 0, 1)};  // their balls have the radii 4 and 1
  apart.b.center = apart.a.center + Vector3(0, 9, 0);
  EXPECT_TRUE(SizeRange{.gap = 4}.holds(apart));
  EXPECT_FALSE(SizeRange{.gap = 3.9}.holds(apart));
}

TEST(SizeRange, ScalesAPairIntoTheRange) {
  const SizeRange range{.least = 0.1, .greatest = 10};
  const Pair small{solid(0.01, 0.02), solid(0.03, 0.04)}, large{solid(100, 20), solid(8, 40)};
  ASSERT_TRUE(fitted(small, range));
  EXPECT_EQ(numbers_of(*fitted(small, range)), numbers_of(scaled(small, 4)));
  EXPECT_EQ(numbers_of(*fitted(large, range)), numbers_of(scaled(large, -4)));
  EXPECT_EQ(numbers_of(*fitted(scaled(small, 4), range)), numbers_of(scaled(small, 4)));
  EXPECT_FALSE(fitted(Pair{solid(0.01, 1), solid(1, 100)}, range)) << "no scale fits";
  EXPECT_FALSE(fitted(small, {.least = 0.1, .greatest = 0.2, .zero_lengths = false}));
}

TEST(SizeRange, LimitsCoordinatesAndGaps) {
  const SizeRange range{.coordinate = 8, .gap = 4};
  const auto at = [](double x, double y) {
    Pair pair{solid(3, 8), solid(0, 0, 1)};  // their balls have the radii 5 and 1
    pair.a.center.x() = x;
    pair.b.center.x() = y;
    return pair;
  };
  EXPECT_TRUE(range.holds(at(-2, 8)));
  EXPECT_FALSE(range.holds(at(-2.1, 8))) << "the gap";
  EXPECT_FALSE(range.holds(at(0, 8.1))) << "the coordinate";
  EXPECT_TRUE(SizeRange{}.holds(at(-1.7e308, 1.7e308)));
  EXPECT_FALSE(fitted(at(-1.7e308, 1.7e308), {.gap = 4}));
  EXPECT_EQ(numbers_of(*fitted(at(-2, 60), range)), numbers_of(scaled(at(-2, 60), -4)));
  EXPECT_FALSE(fitted(at(-2, 60), {.least = 1, .coordinate = 8})) << "too small once the coordinates are";
  EXPECT_EQ(common_range(range, {.coordinate = 9, .gap = 1}), (SizeRange{.coordinate = 8, .gap = 1}));
}

TEST(SizeRange, OfTwoMethodsIsWhatBothHold) {
  const SizeRange x{.least = 0.1, .greatest = 10}, y{.least = 1, .aspect = 5, .zero_lengths = false};
  EXPECT_EQ(common_range(x, y), (SizeRange{.least = 1, .greatest = 10, .aspect = 5, .zero_lengths = false}));
}

}  // namespace
}  // namespace cyl
