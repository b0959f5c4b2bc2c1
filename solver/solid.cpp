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
  if (c.rounding > 0 && !std::isfinite(c.radius + c.height + c.rounding)) return Defect::rounding_overflows;
  if (c.shape == Shape::half_space && c.radius + c.height + c.rounding > 0)
    return Defect::half_space_has_lengths;
  return Defect::none;
}

const char* to_string(Verdict v) noexcept { return word(v); }
const char* to_string(Defect d) noexcept { return word(d); }  // not covered: a family's pairs are valid

}  // namespace cyl
