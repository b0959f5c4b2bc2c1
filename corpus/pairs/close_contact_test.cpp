// SPDX-License-Identifier: MIT
// The tests that need no referee. oracles/trial/close_contact_test.cpp tests that the distance is as built.
#include "corpus/pairs/close_contact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "base/fnv.hpp"
#include "corpus/pairs/pair_io.hpp"

namespace cyl {
namespace {

constexpr std::uint64_t seed = 20261121;

using Wide = long double;
using Wide3 = Eigen::Matrix<Wide, 3, 1>;

Wide3 unit(const Vector3& v) { return (v.cast<Wide>() / v.cast<Wide>().stableNorm()).eval(); }
Wide size_of(const Pair& p) { return Wide(p.a.radius) + p.a.height + p.b.radius + p.b.height; }

/// Returns the angle between two lines, or what it lacks of a right angle if that is less.
Wide small_angle(const Vector3& u, const Vector3& v) {
  const Wide3 x = unit(u), y = unit(v);
  return std::asin(std::min({Wide(1), x.cross(y).norm(), std::abs(x.dot(y))}));
}

/// Calls `see` for the contacts of every kind in the first `rounds` rounds.
template <class See>
void see_rounds(std::uint64_t rounds, See see) {
  for (std::uint64_t round = 0; round < rounds; ++round)
    for (const CloseContact& c : draw_close_round(seed, round)) see(c);
}

TEST(CloseContact, NumbersItsCells) {
  for (std::size_t i = 0; i < close_cell_count; ++i) EXPECT_EQ(number_of(close_cells[i]), i);
  EXPECT_EQ(close_cell_count, 144u);
  EXPECT_EQ(close_cells.back().decade, last_close_decade);
}

TEST(CloseContact, ARoundHasEveryCellAndEveryDecadeOfTheAngle) {
  std::map<CloseKind, std::map<std::size_t, int>> seen;
  for (const CloseKind kind : enum_values<CloseKind>)
    for (std::uint64_t i = 0; i < 8 * close_share(kind); ++i)
      ++seen[kind][number_of(draw_close_contact(kind, seed, i).cell)];
  EXPECT_EQ(seen[CloseKind::by_decade].size(), close_cell_count);
  for (const auto& [cell, count] : seen[CloseKind::by_decade]) EXPECT_EQ(count, 8) << cell;
  EXPECT_EQ(seen[CloseKind::rods].size(), 1u);
  // By angle, a margin is within the decade of the angle or the next one: 12 decades for each of 3 lies.
  std::map<int, int> decades;
  for (const auto& [cell, count] : seen[CloseKind::by_angle]) {
    decades[close_cells[cell].decade] += count;
    EXPECT_NE(close_cells[cell].band, AngleBand::none);
  }
  EXPECT_EQ(decades.size(), static_cast<std::size_t>(last_close_decade));
  for (const auto& [decade, count] : decades) EXPECT_GT(count, 40) << decade;
  std::size_t drawn = 0;
  see_rounds(1, [&](const CloseContact&) { ++drawn; });
  EXPECT_EQ(drawn, close_round);
}

TEST(CloseContact, HasTheMarginOfItsCell) {
  see_rounds(40, [](const CloseContact& c) {
    ASSERT_EQ(find_defect(c.pair.a), Defect::none);
    ASSERT_EQ(find_defect(c.pair.b), Defect::none);
    const double margin = std::abs(c.distance) / static_cast<double>(size_of(c.pair));
    ASSERT_GT(margin, std::max(1.0099e-13, std::pow(10, -c.cell.decade - 1)));
    ASSERT_LE(margin, std::pow(10, -c.cell.decade) * (1 + 1e-15));
  });
}

TEST(CloseContact, HasTheAnglesOfItsCell) {
  constexpr std::array<Wide, 5> ends{1, 1e-3L, 1e-8L, 1e-13L, -1};
  constexpr Wide rounding_error = 2e-15L;  // of three axes and the normal
  std::map<AxesLie, std::size_t> exact;
  see_rounds(40, [&](const CloseContact& c) {
    const Wide3 a = unit(c.pair.a.axis), b = unit(c.pair.b.axis);
    const Wide sine = a.cross(b).norm(), cosine = std::abs(a.dot(b));
    const auto band = static_cast<std::size_t>(c.cell.band);
    Wide small = c.cell.lie == AxesLie::near_parallel ? sine : cosine;
    if (c.cell.lie == AxesLie::generic) {
      ASSERT_GT(sine, generic_tol);
      ASSERT_GT(cosine, generic_tol);
      if (c.feature != ContactFeature::side_rim && c.feature != ContactFeature::rim_rim) return;
      small = small_angle(c.normal, c.pair.a.axis);
      const Wide other = small_angle(c.normal, c.pair.b.axis);
      // The axis of a side is square to the normal.
      if (c.feature == ContactFeature::side_rim) small = std::max(small, other);
      if (c.feature == ContactFeature::rim_rim) small = std::min(small, other);
      if (band == 0) return;  // the angle of the other rim may be smaller
    }
    exact[c.cell.lie] += small == 0;
    ASSERT_LE(small, ends[band] + rounding_error) << to_string(c.cell.lie) << ' ' << to_string(c.feature);
    // If a whole turn about the normal was free, both angles together make up the small one.
    ASSERT_GE(small, ends[band + 1] / 2 - rounding_error)
        << to_string(c.cell.lie) << ' ' << to_string(c.feature);
  });
  EXPECT_GT(exact[AxesLie::near_parallel], 100u);
  EXPECT_GT(exact[AxesLie::near_square], 20u);
}

TEST(CloseContact, RodsAreRodsAndRimsAreRims) {
  for (std::uint64_t i = 0; i < 500; ++i) {
    const CloseContact rods = draw_close_contact(CloseKind::rods, seed, i);
    const Wide angle = unit(rods.pair.a.axis).cross(unit(rods.pair.b.axis)).norm();
    ASSERT_TRUE(angle > 1.98e-13L && angle < 9.02e-13L) << static_cast<double>(angle);
    ASSERT_LT(rods.distance, 0);
    ASSERT_LE(-rods.distance, (angle + 2e-15L) * size_of(rods.pair));
    const CloseContact rims = draw_close_contact(CloseKind::rims, seed, i);
    const auto [least, most] = std::minmax(rims.pair.a.radius, rims.pair.b.radius);
    ASSERT_TRUE(least >= 1e-4 * most && least <= 1e-1 * most);
    ASSERT_EQ(rims.feature, ContactFeature::rim_rim);
  }
}

TEST(CloseContact, IsTheSameOnEveryMachine) {
  std::uint64_t digest = fnv1a({});
  std::set<std::string> seen;
  see_rounds(5, [&](const CloseContact& c) {
    const std::string line = format_pair(c.pair);
    EXPECT_TRUE(seen.insert(line).second) << line;
    digest = fnv1a(line, digest);
  });
  EXPECT_EQ(digest, 17284041777863874264u);
}

}  // namespace
}  // namespace cyl
