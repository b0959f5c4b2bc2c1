// SPDX-License-Identifier: MIT
#include "base/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace cyl {
namespace {

/// Halves [low, high] around the point at which `falling` passes `level`, to 2^-60, finer than ever shown.
template <class Function>
void bisect(double& low, double& high, double level, Function falling) {
  for (int i = 0; i < 60; ++i) {
    const double middle = low / 2 + high / 2;
    (falling(middle) > level ? low : high) = middle;
  }
}

/// Returns the probability of `failures` or fewer at rate p in (0, 1).
double binomial_at_most(std::uint64_t trials, std::uint64_t failures, double p) {
  const double n = static_cast<double>(trials), odds = std::log(p) - std::log1p(-p);
  double logarithm = n * std::log1p(-p), sum = 0;
  for (std::uint64_t k = 0; k <= failures; ++k) {
    sum += std::exp(logarithm);
    const double x = static_cast<double>(k);
    logarithm += odds + std::log((n - x) / (x + 1));
  }
  return sum;
}

/// Returns the rate at which so few or fewer failures have the probability `level`.
double rate_where(std::uint64_t trials, std::uint64_t failures, double level) {
  double low = 0, high = 1;
  bisect(low, high, level, [&](double p) { return binomial_at_most(trials, failures, p); });
  return low;
}

/// Returns the probability of k or fewer events if `mean` are expected.
double poisson_at_most(std::uint64_t k, double mean) {
  double term = std::exp(-mean), sum = term;
  for (std::uint64_t i = 1; i <= k; ++i) sum += term *= mean / static_cast<double>(i);
  return sum;
}

}  // namespace

RateBounds rate_bounds(std::uint64_t trials, std::uint64_t failures) {
  constexpr double tail = 0.025;
  if (trials == 0) return {};
  RateBounds bounds{0, 1};
  if (failures > 0) bounds.lower = rate_where(trials, failures - 1, 1 - tail);
  if (failures < trials) bounds.upper = rate_where(trials, failures, tail);
  return bounds;
}

// Returns the rate at which so few wrong answers are seen with a probability of 5 %. It uses Poisson's law,
// which bounds the binomial law there. If none is wrong, e^(-np) = 0.05 and np = 3.0. Beyond `exact_cap`,
// e^-mean would vanish, so the normal approximation is used.
double error_rate_bound(std::uint64_t pairs, std::uint64_t wrong) {
  constexpr double level = 0.05, normal_quantile = 1.645;
  constexpr std::uint64_t exact_cap = 200;
  if (pairs == 0) return 1;
  const double k = static_cast<double>(wrong), n = static_cast<double>(pairs);
  if (wrong == 0) return std::min(1.0, 3 / n);
  if (wrong > exact_cap) return std::min(1.0, (k + normal_quantile * std::sqrt(k) + 1.5) / n);
  double low = k, high = 2 * k + 10;
  bisect(low, high, level, [&](double mean) { return poisson_at_most(wrong, mean); });
  return std::min(1.0, high / n);
}

double quantile(std::vector<double> values, double q) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto rank = static_cast<std::size_t>(q * static_cast<double>(values.size() - 1) + 0.5);
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(rank), values.end());
  return values[rank];
}

double spread_percent(const std::vector<double>& values) {
  return 100 * (quantile(values, 0.75) - quantile(values, 0.25)) / quantile(values, 0.5);
}

}  // namespace cyl
