// SPDX-License-Identifier: MIT
// Nearly touching pairs that are extreme in other ways too: almost parallel or perpendicular axes, contacts
// at a feature's border, flat solids, small rims on large ones. Built from the contact outwards, as
// near_touching.hpp does, but with angles, places and lengths drawn by their decades down to their exact
// ends.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/enum_words.hpp"
#include "corpus/pairs/random_stream.hpp"
#include "corpus/pairs/stratum.hpp"
#include "solver/solid.hpp"

namespace cyl {

/// How the lines of the axes lie.
enum class AxesLie : unsigned char {
  generic,        ///< more than generic_tol from parallel and from square
  near_parallel,  ///< at the cell's angle
  near_square     ///< at the cell's angle from a right one
};
constexpr auto words_of(AxesLie) noexcept { return std::array{"generic", "near-parallel", "near-square"}; }

/// Sine or cosine from which on axes are generic.
inline constexpr double generic_tol = 0.1;

/// The small angle in radians, between the axes or to a right angle. For generic axes it is the angle between
/// the contact normal and one axis, or its difference to a right angle.
enum class AngleBand : unsigned char {
  wide,   ///< above 1e-3
  small,  ///< above 1e-8
  tiny,   ///< above 1e-13
  none    ///< below, half of them exactly 0, as far as doubles have such axes
};
constexpr auto words_of(AngleBand) noexcept {
  return std::array{"> 1e-03", "1e-03..1e-08", "1e-08..1e-13", "< 1e-13"};
}

/// Margins of decade d are in (10^(-d-1), 10^-d]. In the last decade they are above least_close_margin, so
/// that a claim from 1e-13 on covers them despite rounding.
inline constexpr int first_close_decade = 1, last_close_decade = 12;
inline constexpr double least_close_margin = 1.01e-13;

struct CloseCell {
  AxesLie lie;
  AngleBand band;
  int decade;
};

/// All cells: by lie, then by band, then by decade. Each is drawn from.
inline constexpr std::size_t close_decade_count = last_close_decade - first_close_decade + 1;
inline constexpr std::size_t close_cell_count =
    enum_values<AxesLie>.size() * enum_values<AngleBand>.size() * close_decade_count;
constexpr std::size_t number_of(const CloseCell& cell) noexcept {
  const std::size_t angle = static_cast<std::size_t>(cell.lie) * enum_values<AngleBand>.size() +
                            static_cast<std::size_t>(cell.band);
  return angle * close_decade_count + static_cast<std::size_t>(cell.decade - first_close_decade);
}
inline constexpr auto close_cells = [] {
  std::array<CloseCell, close_cell_count> all{};
  for (const AxesLie lie : enum_values<AxesLie>)
    for (const AngleBand band : enum_values<AngleBand>)
      for (int decade = first_close_decade; decade <= last_close_decade; ++decade)
        all[number_of({lie, band, decade})] = {lie, band, decade};
  return all;
}();

/// How the margin is drawn.
enum class CloseKind : unsigned char {
  by_decade,  ///< at any angle: each cell equally often
  by_angle,   ///< 0.1 to 1 of the small angle, which is 1e-1 to 1e-13: what a neglected angle moves decides
  rods,       ///< the same of overlapping rods, 2e-13 to 9e-13 from parallel, that meet at an end of one
  rims        ///< by decade, rim on rim, one radius 1e-4 to 1e-1 of the other
};
constexpr auto words_of(CloseKind) noexcept { return std::array{"by decade", "by angle", "rods", "rims"}; }

/// A pair and the facts by which it was made.
struct CloseContact {
  Pair pair;
  CloseCell cell;  ///< aimed at: of an overlap the depth may be less
  ContactFeature feature;
  Vector3 normal;   ///< unit, from a to b
  double distance;  ///< minus f(normal), up to rounding. A gap if positive. Else the solids overlap by at
                    ///< most this, or flat solids have passed through each other and are apart.
};

/// By decade, the cells (and rims) alternate fastest, then gap and overlap, then the features of the cell.
/// Half of the rims have generic axes at wide angles in every turn. By angle, the positions of the axes
/// alternate, then the decades of the angle, gap and overlap, and the features.
CloseContact draw_close_contact(CloseKind kind, RandomStream& stream, std::uint64_t index);
/// The same from a stream of its own: a pure function of its arguments.
CloseContact draw_close_contact(CloseKind kind, std::uint64_t seed, std::uint64_t index);

/// How many pairs of a kind a round has: in each as many of every cell and of every decade of the angle.
constexpr std::uint64_t close_share(CloseKind kind) {
  constexpr std::array<std::uint64_t, enum_words<CloseKind>.size()> shares{close_cell_count, close_cell_count,
                                                                           12, 60};
  return shares[static_cast<std::size_t>(kind)];
}
inline constexpr std::uint64_t close_round = [] {
  std::uint64_t sum = 0;
  for (const CloseKind kind : enum_values<CloseKind>) sum += close_share(kind);
  return sum;
}();

/// Returns the pairs of a round: kind by kind, of consecutive indices in consecutive rounds.
std::vector<CloseContact> draw_close_round(std::uint64_t seed, std::uint64_t round);

}  // namespace cyl
