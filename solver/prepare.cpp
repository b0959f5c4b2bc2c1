// SPDX-License-Identifier: MIT
#include <cmath>

#include "solver/decide.hpp"
#include "solver/detail/frame.hpp"

namespace cyl {

Prepared prepare(const Solid& c) noexcept {
  Prepared p{c.center, {0, 0, 1}, c.radius, c.height, find_defect(c), false, false, false, false, c.rounding};
  if (p.defect == Defect::none && c.shape != Shape::cylinder) p.defect = Defect::not_a_cylinder;
  if (p.defect != Defect::none) return p;
  // Scales by powers of two. The largest coordinate comes to [1, 2), of the largest doubles to [2, 4), and
  // of subnormal ones to [2^-51, 1]. So squares neither overflow nor vanish.
  const int exponent = exponent_of(max_abs(c.axis));
  const Vector3 w = c.axis * (exponent > 1022 ? 0x1p-1022 : power_of_two(-exponent));
  // The solid does not know which way its axis points; here its first coordinate that is not 0 is positive.
  const double first = w.x() != 0 ? w.x() : w.y() != 0 ? w.y() : w.z();
  p.unit_axis = w / std::copysign(length(w), first);
  // Coordinates below 2^-200 go: no angle shows them, and products with them could underflow.
  for (int i = 0; i < 3; ++i)
    if (std::fabs(p.unit_axis[i]) < 0x1p-200) p.unit_axis[i] = 0;  // never -0

  mark_moderate(p);
  return p;
}

void mark_moderate(Prepared& p) noexcept {
  constexpr double coordinate_limit = power_of_two(moderate_exponent + center_exponent);
  constexpr double length_limit = power_of_two(moderate_exponent);
  auto within = [](double x, double limit) {
    const double size = std::fabs(x);
    return (size == 0) | ((size >= 1 / limit) & (size <= limit));
  };
  p.moderate = within(p.center.x(), coordinate_limit) & within(p.center.y(), coordinate_limit) &
               within(p.center.z(), coordinate_limit) & within(p.radius, length_limit) &
               within(p.height, length_limit) & within(p.rounding, length_limit);
  p.ordinary = p.moderate & (p.rounding == 0);
  p.thin = p.moderate & (p.radius == 0);
  p.ball = p.thin & (p.height == 0);
}

}  // namespace cyl
