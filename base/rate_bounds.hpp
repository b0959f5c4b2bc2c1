// SPDX-License-Identifier: MIT
// What so many failures in so many independent trials say about the rate.
#pragma once

#include <cstdint>

namespace cyl {

struct RateBounds {
  double lower = 0, upper = 1;
};

/// The exact bounds of Clopper and Pearson at 95 %: rates below `lower` show so many or more failures, rates
/// above `upper` so few or fewer, with a probability below 2.5 % each. 0 and 1 where there were no trials.
/// failures <= trials. Cost: proportional to `trials`.
RateBounds rate_bounds(std::uint64_t trials, std::uint64_t failures);

}  // namespace cyl
