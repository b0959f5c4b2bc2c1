// SPDX-License-Identifier: MIT
#include "solver/solid.hpp"

#include <cmath>
#include <cstddef>

namespace cyl {
namespace {

/// Returns the word of a value, and the last word for a number that is not a value.
// not covered within: the verdicts of methods are values
template <typename E>
const char* word(E value) noexcept {
  static constexpr auto words = words_of(E{});
  const auto i = static_cast<std::size_t>(value);
  return i < words.size() ? words[i] : words.back();
}

}  // namespace

// not covered within: a family's pairs are valid, and tests try each defect
Defect find_defect(const Solid& c) noexcept {
  if (!c.center.allFinite()) return Defect::center_not_finite;
  if (!c.axis.allFinite()) return Defect::axis_not_finite;
  if (c.axis.x() == 0 && c.axis.y() == 0 && c.axis.z() == 0) return Defect::axis_zero;
  if (!std::isfinite(c.radius)) return Defect::radius_not_finite;
  if (c.radius < 0) return Defect::radius_negative;
  if (!std::isfinite(c.height)) return Defect::height_not_finite;
  if (c.height < 0) return Defect::height_negative;
  if (!std::isfinite(c.rounding)) return Defect::rounding_not_finite;
  if (c.rounding < 0) return Defect::rounding_negative;
  for (const double edge : c.edges) {
    if (!std::isfinite(edge)) return Defect::edge_not_finite;
    if (edge < 0) return Defect::edge_negative;
  }
  const double of_edges = c.edges[0] + c.edges[1] + c.edges[2], of_axis = c.radius + c.height;
  if (c.rounding > 0 && !std::isfinite(of_axis + c.rounding + of_edges)) return Defect::rounding_overflows;
  const double foreign = c.shape == Shape::cylinder ? of_edges
                         : c.shape == Shape::box    ? of_axis
                                                    : of_axis + c.rounding + of_edges;
  if (foreign > 0) return Defect::foreign_length;
  if (c.shape == Shape::box) {
    const auto& [w, x, y, z] = c.quaternion;
    if (!std::isfinite(w) || !std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z))
      return Defect::quaternion_not_finite;
    if (w == 0 && x == 0 && y == 0 && z == 0) return Defect::quaternion_zero;
  }
  return Defect::none;
}

const char* to_string(Verdict v) noexcept { return word(v); }
const char* to_string(Defect d) noexcept { return word(d); }  // not covered: a family's pairs are valid

}  // namespace cyl
