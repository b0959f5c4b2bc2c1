// SPDX-License-Identifier: MIT
#include "bench/curves.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

namespace cyl {
namespace {

BenchRow row_of(const char* method, std::string family, const char* query = "verdict", double ns = 10,
                std::size_t pairs = 600) {
  BenchRow row;
  row.method = method;
  row.family = std::move(family);
  row.query = query;
  row.pairs = pairs;
  row.median_ns = ns;
  row.p99_ns = 2 * ns;
  row.max_ns = 3 * ns;
  return row;
}

/// Right at margins 1e-1 to 1e-`right`, then with one fault a margin, to 1e-15.
std::vector<BenchRow> rows_of(int right, std::size_t pairs = 600, std::size_t BenchRow::*fault = nullptr) {
  std::vector<BenchRow> rows;
  for (int d = 1; d <= 15; ++d) {
    rows.push_back(row_of("m", fmt::format("margin_1e-{:02}", d), "verdict", 10, pairs));
    if (d > right) rows.back().*(fault ? fault : &BenchRow::wrong_disjoint) = 1;
  }
  return rows;
}

// The curves that settings were added for have several points, and no point stands twice.
TEST(Curves, NoTwoMethodsAreOnePoint) {
  std::map<std::string, std::set<std::string>> settings;
  std::set<std::string> names;
  for (const auto& methods : {all_methods(), setting_methods()}) {
    for (const auto& m : methods) {
      BenchRow row = row_of("", "margin_1e-01");
      row.name = m->name_parts();
      const SpeedPoint point = speed_points({&row, 1})[0];
      EXPECT_TRUE(settings[point.curve].insert(point.setting).second) << m->name();
      EXPECT_TRUE(names.emplace(m->name()).second) << m->name();
    }
  }
  for (const char* curve : {"fcl-libccd", "fcl-indep", "fcl-distance-libccd", "bullet-hull", "libccd-mpr",
                            "mujoco", "nlopt-direct"})
    EXPECT_GE(settings[curve].size(), 5u) << curve;
  EXPECT_TRUE(settings["libccd-mpr"].contains("tol1e-12") && settings["ode"].contains("default"));
}

TEST(Curves, TheMarginOfAFamilyIsInItsName) {
  EXPECT_EQ(margin_of_family("margin_1e-06"), 6);
  EXPECT_EQ(margin_of_family("margin_1e-15"), 15);
  for (const char* other : {"random", "margin_1e-", "margin_1e-x", "margin_1e-06b"})
    EXPECT_FALSE(margin_of_family(other)) << other;
  for (const Family& family : margin_families()) EXPECT_TRUE(margin_of_family(family.name)) << family.name;
}

TEST(Digits, EndAtTheFirstMarginThatIsNotRight) {
  EXPECT_EQ(digits_of(rows_of(6)).right, 6);
  EXPECT_EQ(digits_of(rows_of(15)).right, 15);
  EXPECT_EQ(digits_of(rows_of(0)).right, 0);
  EXPECT_FALSE(digits_of({}).right);
  for (const auto fault : {&BenchRow::wrong_intersecting, &BenchRow::undecided, &BenchRow::failed})
    EXPECT_EQ(digits_of(rows_of(9, 600, fault)).right, 9);
  std::vector<BenchRow> again = rows_of(15);
  again[3].wrong_intersecting = 1;  // right again below it
  EXPECT_EQ(digits_of(again).right, 3);
  again.erase(again.begin() + 1);  // not measured
  EXPECT_EQ(digits_of(again).right, 1);
  again[0].pairs = 0;
  EXPECT_EQ(digits_of(again).right, 0);
  const BenchRow random = row_of("m", "random");
  EXPECT_FALSE(digits_of({&random, 1}).right);
}

// 0.999^2994 is above 0.05 and 0.999^2995 below.
TEST(Digits, TheLowOnesNeedTwoThousandNineHundredAndNinetyFiveRightAnswers) {
  EXPECT_GT(std::pow(0.999, 2994), 0.05);
  EXPECT_LT(std::pow(0.999, 2995), 0.05);
  EXPECT_EQ(digits_of(rows_of(6, 2995)).low, 6);
  EXPECT_EQ(digits_of(rows_of(6, 2994)).low, 5);
  EXPECT_EQ(digits_of(rows_of(6, 600)).low, 2);
  EXPECT_EQ(digits_of(rows_of(5, 600)).low, 1);
  EXPECT_FALSE(digits_of(rows_of(4, 600)).low);
  EXPECT_FALSE(digits_of(rows_of(0, 600)).low);
}

TEST(SpeedPoints, OneOverAllMargins) {
  std::vector<BenchRow> rows = rows_of(6);
  rows[8].wrong_intersecting = 4;
  rows[8].max_ns = 500;
  rows[9].median_ns = not_measured;
  rows.push_back(row_of("m", "random", "verdict", 1000));
  rows.push_back(row_of("m", "random", "raw"));
  rows.push_back(row_of("m", "random", "depth"));
  rows.push_back(row_of("m", "margin_1e-01", "distance", 7));
  const std::vector<SpeedPoint> points = speed_points(rows);
  ASSERT_EQ(points.size(), 2u);
  const SpeedPoint& all = points[0];
  EXPECT_EQ(all.ns, 10);
  EXPECT_EQ(all.p99_ns, 20);
  EXPECT_EQ(all.max_ns, 500);
  EXPECT_EQ(all.asked, 15u * 600);
  EXPECT_EQ(all.wrong_disjoint, 9u);
  EXPECT_EQ(all.wrong_intersecting, 4u);
  EXPECT_EQ(all.digits.right, 6);
  EXPECT_EQ(all.digits.low, 2);
  EXPECT_EQ(points[1].query, "distance");
  EXPECT_EQ(points[1].ns, 7);
  const std::string text = format_curves(points);
  EXPECT_NE(text.find("verdict"), std::string::npos);
  EXPECT_EQ(text.find("1000"), std::string::npos);
}

}  // namespace
}  // namespace cyl
