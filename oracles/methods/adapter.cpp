// SPDX-License-Identifier: MIT
#include "oracles/methods/adapter.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/touch_plane.hpp"

namespace cyl {

std::optional<MethodAnswer> decline_invalid(const Pair& pair) {
  if (is_legal(pair)) return std::nullopt;
  const Defect a = find_defect(pair.a), b = find_defect(pair.b);
  return declined_answer(a != Defect::none   ? std::string("a: ") + to_string(a)
                         : b != Defect::none ? std::string("b: ") + to_string(b)
                                             : "both solids are half-spaces");
}

Solid with_rounded_rims(Solid c, double rounding) noexcept {
  if (c.rounding > 0 || !(rounding > 0)) return c;
  if (is_box(c)) {
    if (2 * rounding > *std::ranges::min_element(c.edges)) return c;
    for (double& edge : c.edges) edge -= 2 * rounding;
  } else {
    if (rounding > c.radius || 2 * rounding > c.height) return c;
    c.radius -= rounding;
    c.height -= 2 * rounding;
  }
  c.rounding = rounding;
  return c;
}

// The axis is first scaled by a power of two, exactly, so that squares neither overflow nor vanish. If a
// coordinate becomes subnormal by it, it is below 2^-1000 of the largest.
Vector3 unit_axis(const Vector3& axis) noexcept {
  const int exponent = std::ilogb(axis.cwiseAbs().maxCoeff());
  const Vector3 scaled(std::scalbn(axis.x(), -exponent), std::scalbn(axis.y(), -exponent),
                       std::scalbn(axis.z(), -exponent));
  return scaled / scaled.norm();
}

// Duff et al., Building an Orthonormal Basis, Revisited (JCGT 6:1, 2017): |sign + z| >= 1, so nothing
// cancels.
Eigen::Matrix3d rotation_to(const Vector3& u) noexcept {
  const double sign = std::copysign(1.0, u.z());
  const double a = -1 / (sign + u.z());
  const double b = u.x() * u.y() * a;
  Eigen::Matrix3d m;
  m.col(0) << 1 + sign * u.x() * u.x() * a, sign * b, -sign * u.x();
  m.col(1) << b, sign + u.y() * u.y() * a, -u.y();
  m.col(2) = u;
  return m;
}

Eigen::Matrix3d rotation_of(const Solid& c) noexcept {
  if (!is_box(c)) return rotation_to(unit_axis(c.axis));
  Eigen::Matrix3d m;
  for (int i = 0; i < 3; ++i) m.col(i) = edge_direction(c, static_cast<std::size_t>(i));
  return m;
}

}  // namespace cyl
