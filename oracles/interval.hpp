// SPDX-License-Identifier: MIT
// Closed intervals of doubles, every operation rounded outward by one unit in the last place of the nearest
// result. Needs only that + - * / sqrt round to nearest. An overflow makes an end infinite; a
// result that is not a number becomes [-inf, inf], which proves nothing.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace cyl {

struct Interval {
  double lo, hi;
  Interval() : lo(0), hi(0) {}
  Interval(double x) : lo(x), hi(x) {}  // NOLINT: a double is an interval
  Interval(double l, double h) : lo(l), hi(h) {}
};

namespace interval_detail {
inline double next_up(double x) {
  if (!(x < std::numeric_limits<double>::infinity())) return std::numeric_limits<double>::infinity();
  if (x == 0) return 0x1p-1074;
  const auto bits = std::bit_cast<std::int64_t>(x);
  return std::bit_cast<double>(bits + (x > 0 ? 1 : -1));
}
inline double next_down(double x) { return -next_up(-x); }
inline Interval outward(double lo, double hi) { return {next_down(lo), next_up(hi)}; }
}  // namespace interval_detail

inline Interval operator-(const Interval& a) { return {-a.hi, -a.lo}; }
inline Interval operator+(const Interval& a, const Interval& b) {
  return interval_detail::outward(a.lo + b.lo, a.hi + b.hi);
}
inline Interval operator-(const Interval& a, const Interval& b) {
  return interval_detail::outward(a.lo - b.hi, a.hi - b.lo);
}
inline Interval operator*(const Interval& a, const Interval& b) {
  const double p = a.lo * b.lo, q = a.lo * b.hi, r = a.hi * b.lo, s = a.hi * b.hi;
  if (std::isnan(p + q + r + s))
    return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  return interval_detail::outward(std::min(std::min(p, q), std::min(r, s)),
                                  std::max(std::max(p, q), std::max(r, s)));
}
/// The divisor does not contain 0, or the quotient is everything.
inline Interval operator/(const Interval& a, const Interval& b) {
  if (b.lo <= 0 && b.hi >= 0)
    return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  const double p = a.lo / b.lo, q = a.lo / b.hi, r = a.hi / b.lo, s = a.hi / b.hi;
  if (std::isnan(p + q + r + s))
    return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  return interval_detail::outward(std::min(std::min(p, q), std::min(r, s)),
                                  std::max(std::max(p, q), std::max(r, s)));
}
inline Interval sqrt(const Interval& a) {
  return {std::max(0.0, interval_detail::next_down(std::sqrt(std::max(0.0, a.lo)))),
          interval_detail::next_up(std::sqrt(std::max(0.0, a.hi)))};
}
inline Interval abs(const Interval& a) {
  if (a.lo >= 0) return a;
  if (a.hi <= 0) return -a;
  return {0, std::max(-a.lo, a.hi)};
}
inline Interval square(const Interval& a) {
  const Interval m = abs(a);
  return {std::max(0.0, interval_detail::next_down(m.lo * m.lo)), interval_detail::next_up(m.hi * m.hi)};
}
inline double lower(const Interval& a) { return a.lo; }
inline double upper(const Interval& a) { return a.hi; }

}  // namespace cyl
