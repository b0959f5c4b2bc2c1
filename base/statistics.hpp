// SPDX-License-Identifier: MIT
// Bounds on a rate from trials, and quantiles.
#pragma once

#include <cstdint>
#include <vector>

namespace cyl {

struct RateBounds {
  double lower = 0, upper = 1;
};

/// Returns the exact bounds of Clopper and Pearson at 95 %: rates below `lower` show so many or more
/// failures, rates above `upper` so few or fewer, with a probability below 2.5 % each. 0 and 1 where there
/// were no trials. failures <= trials. Cost: proportional to `failures`.
RateBounds rate_bounds(std::uint64_t trials, std::uint64_t failures);

/// Returns the greatest error rate that `wrong` errors in `pairs` independent trials leave possible at 95 %,
/// one-sided: 3/n where none was seen. 1 where there were no trials.
double error_rate_bound(std::uint64_t pairs, std::uint64_t wrong);

/// Returns the probability that `count` events, each in one of `all` places alike, all fall among the same
/// `part` of them: what it is worth that none fell elsewhere. 1 where `all` is 0.
double chance_of_all_in(std::uint64_t count, std::uint64_t part, std::uint64_t all);

/// Returns the value of rank q (count - 1), rounded; NaN where there are none.
double quantile(std::vector<double> values, double q);

/// Returns the least of the values, sorted and not none, that so great a share of them does not exceed.
double least_above(const std::vector<double>& sorted, double share);

/// Returns the range of the middle half of the values, in % of their median.
double spread_percent(const std::vector<double>& values);

}  // namespace cyl
