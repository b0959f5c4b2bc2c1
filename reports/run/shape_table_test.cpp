// SPDX-License-Identifier: MIT
#include "reports/run/shape_table.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "oracles/trial/cells.hpp"

namespace cyl {
namespace {

const Pair pair{{.center = {0, 0, 0}, .shape = Shape::box, .edges = {2, 2, 2}},
                {.center = {3, 0, 0}, .rounding = 1.5}};

TEST(ShapeTable, NamesTheMethodTheShapesAndTheWidestMargin) {
  RunData run;
  run.methods = {{.name = "good"}, {.name = "bad"}};
  EXPECT_EQ(format_shapes(run), "");
  const Cell cell = cells_of(pair, Verdict::disjoint)[static_cast<std::size_t>(Plane::margin_shapes)];
  // Two wrong answers of eight that were not declined, one of them within the claim.
  const CellCounts wrong{.asked = 9, .wrong_intersecting = 2, .declined = 1, .within_intersecting = 1};
  run.cells = {{"margin-shapes", cell.x, cell.y, {{.asked = 9}, wrong}},
               {"margin-shapes", cell.x + 1, cell.y, {{}, {.asked = 2}}},
               {"angle-margin", cell.x, cell.y, {{}, {.asked = 1, .wrong_disjoint = 1}}}};
  const std::string text = format_shapes(run);
  const std::string line =
      fmt::format("\n{:<27}{:<30}{:>11}{:>14}{:>11}  1e-1\n", "sphere, box", "bad", 10, 1, "10.000 %");
  EXPECT_NE(text.find(line), std::string::npos) << text;
  EXPECT_EQ(text.find("good"), std::string::npos);
}

TEST(ShapeTable, LeavesOutOtherSizes) {
  Pair tiny = pair;
  tiny.a.edges[0] = 1e-3;
  RunData run;
  run.methods = {{.name = "bad"}};
  const Cell cell = cells_of(tiny, Verdict::disjoint)[static_cast<std::size_t>(Plane::margin_shapes)];
  run.cells = {{"margin-shapes", cell.x, cell.y, {{.asked = 1, .wrong_disjoint = 1}}}};
  EXPECT_EQ(format_shapes(run), "");
  EXPECT_EQ(y_axis(Plane::margin_shapes).labels[static_cast<std::size_t>(cell.y)], "other sizes");
}

}  // namespace
}  // namespace cyl
