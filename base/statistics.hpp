// SPDX-License-Identifier: MIT
// Bounds on a rate from trials, and quantiles.
#pragma once

#include <cstdint>
#include <vector>

namespace cyl {

struct RateBounds {
  double lower = 0, upper = 1;
};

/// Returns the exact bounds of Clopper and Pearson at 95 %. A rate below `lower` shows this many or more
/// failures, and a rate above `upper` this few or fewer, with a probability below 2.5 % each. Returns 0 and 1
/// without trials. failures <= trials. Cost: proportional to `failures`.
RateBounds rate_bounds(std::uint64_t trials, std::uint64_t failures);

/// Returns the one-sided upper bound at 95 % of the error rate, from `wrong` errors in `pairs` independent
/// trials: about 3/n if none is wrong. Returns 1 without trials.
double error_rate_bound(std::uint64_t pairs, std::uint64_t wrong);

/// Returns the value of rank q (count - 1), rounded, or NaN without values.
double quantile(std::vector<double> values, double q);

/// Returns the range of the middle half of the values, in % of their median.
double spread_percent(const std::vector<double>& values);

}  // namespace cyl
