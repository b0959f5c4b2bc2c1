// SPDX-License-Identifier: MIT
#include "solver/cylinder.hpp"

#include <cmath>

namespace cyl {

Defect find_defect(const Cylinder& c) noexcept {
  if (!c.center.allFinite()) return Defect::center_not_finite;
  if (!c.axis.allFinite()) return Defect::axis_not_finite;
  if (c.axis.x() == 0 && c.axis.y() == 0 && c.axis.z() == 0) return Defect::axis_zero;
  if (!std::isfinite(c.radius)) return Defect::radius_not_finite;
  if (c.radius < 0) return Defect::radius_negative;
  if (!std::isfinite(c.height)) return Defect::height_not_finite;
  if (c.height < 0) return Defect::height_negative;
  return Defect::none;
}

const char* to_string(Verdict v) noexcept {
  switch (v) {
    case Verdict::disjoint:
      return "disjoint";
    case Verdict::intersecting:
      return "intersecting";
    case Verdict::touching:
      return "touching";
    case Verdict::undecided:
      return "undecided";
    case Verdict::invalid:
      return "invalid";
  }
  return "invalid";
}

const char* to_string(Defect d) noexcept {
  switch (d) {
    case Defect::none:
      return "nothing is wrong";
    case Defect::center_not_finite:
      return "center is not finite";
    case Defect::axis_not_finite:
      return "axis is not finite";
    case Defect::axis_zero:
      return "axis is zero";
    case Defect::radius_not_finite:
      return "radius is not finite";
    case Defect::radius_negative:
      return "radius is negative";
    case Defect::height_not_finite:
      return "height is not finite";
    case Defect::height_negative:
      return "height is negative";
  }
  return "nothing is wrong";
}

}  // namespace cyl
