// SPDX-License-Identifier: MIT
#include <cmath>

#include "solver/decide.hpp"
#include "solver/detail/frame.hpp"

namespace cyl {

Prepared prepare(const Cylinder& c) noexcept {
  Prepared p{c.center, {0, 0, 1}, c.radius, c.height, find_defect(c), false, false, false, false, c.rounding};
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

  auto within = [](double x, double limit) {
    const double size = std::fabs(x);
    return (size == 0) | ((size >= 1 / limit) & (size <= limit));
  };
  p.moderate = within(c.center.x(), 0x1p250) & within(c.center.y(), 0x1p250) & within(c.center.z(), 0x1p250) &
               within(c.radius, 0x1p200) & within(c.height, 0x1p200) & within(c.rounding, 0x1p200);
  p.ordinary = p.moderate & (c.rounding == 0);
  p.thin = p.moderate & (c.radius == 0);
  p.ball = p.thin & (c.height == 0);
  return p;
}

}  // namespace cyl
