// SPDX-License-Identifier: MIT
#include "scenes/broad_phase.hpp"

#include <algorithm>
#include <cmath>

namespace cyl {
namespace {

/// Rounding of a box and of the centre in it, times its coordinates and sizes.
constexpr double box_error = 0x1p-48;

}  // namespace

Box box_around(const Prepared& c, double clearance) noexcept {
  Vector3 reach;
  for (int i = 0; i < 3; ++i) {
    const double w = std::fabs(c.unit_axis[i]);
    reach[i] = c.height / 2 * w + c.radius * std::sqrt(std::max(0.0, 1 - w * w)) + c.rounding +
               clearance / 2 +
               box_error * (std::fabs(c.center[i]) + c.height + c.radius + c.rounding + clearance);
  }
  return {c.center - reach, c.center + reach};
}

}  // namespace cyl
