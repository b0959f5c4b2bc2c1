// SPDX-License-Identifier: MIT
// The kinds of solids that engines have shapes for.
#pragma once

#include <array>

#include "base/enum_words.hpp"
#include "solver/solid.hpp"

namespace cyl {

enum class SolidKind : unsigned char {
  sphere,    ///< a point with rounding
  capsule,   ///< a segment with rounding
  cylinder,  ///< without rounding, with any lengths
  rounded,   ///< any other cylinder with rounding
  half_space,
  box,         ///< without rounding
  rounded_box  ///< with rounding
};
constexpr auto words_of(SolidKind) noexcept {
  return std::array{"sphere", "capsule", "cylinder", "rounded", "half_space", "box", "rounded_box"};
}

inline SolidKind kind_of(const Solid& c) noexcept {
  if (c.shape == Shape::half_space) return SolidKind::half_space;
  if (c.shape == Shape::box) return c.rounding == 0 ? SolidKind::box : SolidKind::rounded_box;
  if (c.rounding == 0) return SolidKind::cylinder;
  if (c.radius > 0) return SolidKind::rounded;
  return c.height > 0 ? SolidKind::capsule : SolidKind::sphere;
}

}  // namespace cyl
