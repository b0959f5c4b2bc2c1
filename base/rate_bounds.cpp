// SPDX-License-Identifier: MIT
#include "base/rate_bounds.hpp"

#include <algorithm>
#include <cmath>

namespace cyl {
namespace {

constexpr double tail = 0.025;
/// 2^-60: more than is ever shown.
constexpr int halvings = 60;

/// The probability of `failures` or fewer at rate p in (0, 1).
double at_most(std::uint64_t trials, std::uint64_t failures, double p) {
  const double n = static_cast<double>(trials), odds = std::log(p) - std::log1p(-p);
  double logarithm = n * std::log1p(-p), sum = 0;
  for (std::uint64_t k = 0; k <= failures; ++k) {
    sum += std::exp(logarithm);
    const double x = static_cast<double>(k);
    logarithm += odds + std::log((n - x) / (x + 1));
  }
  return sum;
}

/// The rate at which so few or fewer have the probability `level`; that falls as the rate grows.
double rate_where(std::uint64_t trials, std::uint64_t failures, double level) {
  double low = 0, high = 1;
  for (int i = 0; i < halvings; ++i) {
    const double p = low / 2 + high / 2;
    (at_most(trials, failures, p) > level ? low : high) = p;
  }
  return low;
}

}  // namespace

RateBounds rate_bounds(std::uint64_t trials, std::uint64_t failures) {
  if (trials == 0) return {};
  RateBounds bounds{0, 1};
  if (failures > 0) bounds.lower = rate_where(trials, failures - 1, 1 - tail);
  if (failures < trials) bounds.upper = rate_where(trials, failures, tail);
  return bounds;
}

}  // namespace cyl
