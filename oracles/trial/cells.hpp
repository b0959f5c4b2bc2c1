// SPDX-License-Identifier: MIT
// The planes that failure maps are drawn on, and where on them a pair lies. A place is no verdict: margins
// are the solver's own, so that the places of pairs closer to touching than its rounding (about 1e-14 of
// their size) are no more than near.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/enum_words.hpp"
#include "oracles/methods/method.hpp"
#include "oracles/trial/compare.hpp"

namespace cyl {

enum class Plane : unsigned char { angle_margin, aspect_margin, scale_offset };
constexpr auto words_of(Plane) noexcept {
  return std::array{"angle-margin", "aspect-margin", "scale-offset"};
}
inline constexpr std::array planes{Plane::angle_margin, Plane::aspect_margin, Plane::scale_offset};

/// Bins are numbered from 0, and each but the open ones is named by its upper end.
struct CellAxis {
  std::string title;
  std::vector<std::string> labels;
};

/// Returns the bins of the margin |signed distance| / size: decades d of (10^(-d-1), 10^-d], from 0, all
/// above 0.1, to 16, all up to 1e-16; then what is proved to touch.
inline constexpr int margin_bins = 18, touching_bin = 17;
CellAxis margin_axis();
CellAxis x_axis(Plane plane);
CellAxis y_axis(Plane plane);

struct Cell {
  int x = 0, y = 0;
  bool operator==(const Cell&) const = default;
};

/// Returns where a legal pair lies, in the order of `planes`; `truth` is its proved verdict.
///   angle  of the lines of the axes: exactly parallel, decades of the sine, oblique, decades of the cosine,
///          exactly perpendicular
///   aspect the largest of: diameter to height or height to diameter of either solid, and size of one solid
///          (radius + height) to that of the other; infinite where a length is 0
///   scale  size of the pair; offset: the largest coordinate of a centre over it
/// Cost: that of the solver's distance, and 0.1 us.
std::array<Cell, planes.size()> cells_of(const Pair& pair, Verdict truth);

}  // namespace cyl
