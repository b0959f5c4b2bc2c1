// SPDX-License-Identifier: MIT
#include <cmath>

#include "solver/decide.hpp"
#include "solver/detail/frame.hpp"

namespace cyl {
namespace {

// Coordinates below 2^-200 go: no angle shows them, and products with them could underflow.
void drop_tiny(Vector3& x) noexcept {
  for (int i = 0; i < 3; ++i)
    if (std::fabs(x[i]) < 0x1p-200) x[i] = 0;  // never -0
}

// The columns of the rotation (boxes.md, section 6). The largest number of the quaternion comes to [1, 2), of
// a subnormal one to [2^-51, 1].
void prepare_box(const Solid& c, Prepared& p) noexcept {
  const auto& q = c.quaternion;
  const double unit = unit_of(exponent_of(
      larger(larger(std::fabs(q[0]), std::fabs(q[1])), larger(std::fabs(q[2]), std::fabs(q[3])))));
  const double w = q[0] * unit, x = q[1] * unit, y = q[2] * unit, z = q[3] * unit;
  const double ww = w * w, xx = x * x, yy = y * y, zz = z * z, n = 1 / ((ww + xx) + (yy + zz));
  p.unit_axis = {((ww + xx) - (yy + zz)) * n, 2 * (x * y + w * z) * n, 2 * (x * z - w * y) * n};
  p.second_axis = {2 * (x * y - w * z) * n, ((ww + yy) - (xx + zz)) * n, 2 * (y * z + w * x) * n};
  drop_tiny(p.unit_axis);
  drop_tiny(p.second_axis);
  p.edges = {c.edges[0], c.edges[1], c.edges[2]};
  mark_traits(p);
}

}  // namespace

Prepared prepare(const Solid& c) noexcept {
  Prepared p{c.center, {0, 0, 1}, c.radius, c.height, find_defect(c), 0, c.shape, c.rounding};
  if (p.defect != Defect::none) return p;
  if (c.shape == Shape::box) {
    prepare_box(c, p);
    return p;
  }
  // Scales by powers of two. The largest coordinate comes to [1, 2), of the largest doubles to [2, 4), and
  // of subnormal ones to [2^-51, 1]. So squares neither overflow nor vanish.
  const double unit = unit_of(exponent_of(max_abs(c.axis)));
  const Vector3 w = c.axis * unit;
  // The solid does not know which way its axis points; here its first coordinate that is not 0 is positive.
  // A half-space does.
  double first = w.x() != 0 ? w.x() : w.y() != 0 ? w.y() : w.z();
  if (c.shape == Shape::half_space) {
    first = 1;
    p.second_axis = w / unit == c.axis ? w : c.axis;
  }
  p.unit_axis = w / std::copysign(length(w), first);
  drop_tiny(p.unit_axis);
  mark_traits(p);
  return p;
}

void mark_traits(Prepared& p) noexcept {
  p.traits = 0;
  constexpr double coordinate_limit = power_of_two(moderate_exponent + center_exponent);
  constexpr double length_limit = power_of_two(moderate_exponent);
  auto within = [](double x, double limit) {
    const double size = std::fabs(x);
    return (size == 0) | ((size >= 1 / limit) & (size <= limit));
  };
  if (!(within(p.center.x(), coordinate_limit) & within(p.center.y(), coordinate_limit) &
        within(p.center.z(), coordinate_limit) & within(p.radius, length_limit) &
        within(p.height, length_limit) & within(p.rounding, length_limit) &
        within(p.edges.x(), length_limit) & within(p.edges.y(), length_limit) &
        within(p.edges.z(), length_limit)))
    return;
  p.traits = Prepared::moderate;
  if (p.shape != Shape::cylinder) return;
  if (p.rounding == 0) p.traits |= Prepared::ordinary;
  if (p.radius == 0) p.traits |= p.height == 0 ? Prepared::thin | Prepared::ball : Prepared::thin;
}

}  // namespace cyl
