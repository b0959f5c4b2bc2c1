// SPDX-License-Identifier: MIT
// The bisection of the text of 2017, sections 6 and 8: on the sign of a derivative, looking at the function
// on the way.
#pragma once

#include "solver/literature/document.hpp"

namespace cyl::literature {

/// Whether a gap of this size separates.
inline bool below_zero(double gap, const Options& options) noexcept {
  return options.touching_apart ? gap <= 0 : gap < 0;
}

/// Between low and high, `unit` long in each; true as soon as `found(r)` is.
template <class Found, class Slope>
bool bisect(double low, double high, double unit, const Options& options, Found&& found,
            Slope&& slope) noexcept {
  for (int i = 0; i < options.step_cap && (high - low) * unit > options.tolerance; ++i) {
    const double mid = 0.5 * (low + high);
    if (found(mid)) return true;
    const double rise = slope(mid);
    if (rise > 0)
      high = mid;
    else if (rise < 0)
      low = mid;
    else
      break;
  }
  return false;
}

}  // namespace cyl::literature
