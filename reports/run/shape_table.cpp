// SPDX-License-Identifier: MIT
#include "reports/run/shape_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "oracles/trial/cells.hpp"

namespace cyl {
namespace {

struct OfShapes {
  std::uint64_t answered = 0, wrong = 0;
  int widest = margin_bins;  ///< the bin of the largest margin with a wrong answer
};

}  // namespace

std::string format_shapes(const RunData& run) {
  const std::vector<std::string> shapes = y_axis(Plane::margin_shapes).labels, margins = margin_axis().labels;
  std::map<std::pair<std::size_t, std::size_t>, OfShapes> rows;  // by method and shapes
  for (const CellRecord& cell : run.cells) {
    if (cell.plane != to_string(Plane::margin_shapes)) continue;
    const auto of = static_cast<std::size_t>(cell.y);
    if (of + 1 >= shapes.size()) continue;
    for (std::size_t m = 0; m < cell.methods.size(); ++m) {
      const CellCounts& c = cell.methods[m];
      const std::uint64_t within = c.within_disjoint + c.within_intersecting,
                          wrong = c.wrong_disjoint + c.wrong_intersecting - within;
      OfShapes& row = rows[{m, of}];
      row.answered += c.asked - c.declined;
      row.wrong += wrong;
      if (wrong > 0) row.widest = std::min(row.widest, cell.x);
    }
  }
  std::string text;
  for (const auto& [key, row] : rows) {
    if (row.wrong == 0) continue;
    if (text.empty())
      text = fmt::format("\n{:<27}{:<30}{:>11}{:>14}{:>11}  margins up to\n", "shapes, at ordinary sizes",
                         "method", "answered", "beyond claim", "share");
    text += fmt::format("{:<27}{:<30}{:>11}{:>14}{:>9.3f} %  {}\n", shapes[key.second],
                        run.methods[key.first].name, row.answered, row.wrong,
                        100 * static_cast<double>(row.wrong) / static_cast<double>(row.answered),
                        margins[static_cast<std::size_t>(row.widest)]);
  }
  return text;
}

}  // namespace cyl
