// SPDX-License-Identifier: MIT
// The planes of the failure maps, and the place of a pair on them. A place is not a verdict. Margins are
// approximate distances, so the place of a pair is approximate if the pair is closer to touching than about
// 1e-14 of its size.
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

enum class Plane : unsigned char { angle_margin, aspect_margin, scale_offset, margin_shapes };
constexpr auto words_of(Plane) noexcept {
  return std::array{"angle-margin", "aspect-margin", "scale-offset", "margin-shapes"};
}
inline constexpr std::array planes{Plane::angle_margin, Plane::aspect_margin, Plane::scale_offset,
                                   Plane::margin_shapes};

/// Bins are numbered from 0, and each but the open ones is named by its upper end.
struct CellAxis {
  std::string title;
  std::vector<std::string> labels;
};

/// The bins of the margin |signed distance| / size. Bin d is the decade (10^(-d-1), 10^-d]. Bin 0 also has
/// all above 0.1, bin 16 all up to 1e-16. Bin 17 has the pairs that are proved to touch.
inline constexpr int margin_bins = 18, touching_bin = 17;
CellAxis margin_axis();
CellAxis x_axis(Plane plane);
CellAxis y_axis(Plane plane);

struct Cell {
  int x = 0, y = 0;
  bool operator==(const Cell&) const = default;
};

/// Returns the place of a legal pair on each plane, in the order of `planes`. `truth` is its proved verdict.
/// Cost: that of approximate_distance(), and 0.1 us.
/// * angle: that of the lines of the axes. Exactly parallel, decades of the sine, oblique, decades of the
///   cosine, exactly perpendicular.
/// * aspect: the largest of three ratios, infinite if a length is 0. They are diameter to height of either
///   solid, height to diameter, and size of one solid (radius + height) to that of the other.
/// * scale: the size of the pair.
/// * offset: the largest coordinate of a centre, divided by the size.
/// * shapes: the kinds of both solids in either order, if the pair is_ordinary(), else the last bin.
std::array<Cell, planes.size()> cells_of(const Pair& pair, Verdict truth);

}  // namespace cyl
