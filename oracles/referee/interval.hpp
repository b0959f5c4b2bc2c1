// SPDX-License-Identifier: MIT
// Closed intervals of doubles, every operation rounded outward by at least one unit in the
// last place of the nearest result. Needs only that + - * / sqrt round to nearest. An overflow makes an end
// infinite; a result that is not a number becomes [-inf, inf], which proves nothing.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace cyl {

namespace interval_detail {
using Limits = std::numeric_limits<double>;
static_assert(Limits::is_iec559, "sums round to nearest");

// Half the spacing of numbers at 1, and a bit more.
inline constexpr double half_spacing = 0x1p-53 * (1 + 0x1p-52);
// The successor of x, or the number after it (Rump, Zimmermann, Boldo, Melquiond, BIT 49, 2009). The rounded
// product of |x| and half_spacing is more than half the way from x to its successor. So the sum is not
// rounded back to x. If that product underflows, the least number is the whole way.
inline double next_up(double x) {
  if (!(std::fabs(x) < Limits::infinity())) return x < 0 ? Limits::lowest() : Limits::infinity();
  return x + (std::fabs(x) * half_spacing + Limits::denorm_min());
}
inline double next_down(double x) { return -next_up(-x); }
}  // namespace interval_detail

struct Interval {
  double lo, hi;
  Interval() : lo(0), hi(0) {}
  Interval(double x) : lo(x), hi(x) {}  // NOLINT: a number is an interval
  Interval(double l, double h) : lo(l), hi(h) {}

  static Interval everything() {
    return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  }
  static Interval outward(double l, double h) {
    return {interval_detail::next_down(l), interval_detail::next_up(h)};
  }

  /// The comparisons hold for all numbers of both intervals.
  friend bool surely_less(const Interval& a, const Interval& b) { return a.hi < b.lo; }
  friend bool surely_at_most(const Interval& a, const Interval& b) { return a.hi <= b.lo; }

  friend Interval operator-(const Interval& a) { return {-a.hi, -a.lo}; }
  friend Interval operator+(const Interval& a, const Interval& b) {
    return outward(a.lo + b.lo, a.hi + b.hi);
  }
  friend Interval operator-(const Interval& a, const Interval& b) {
    return outward(a.lo - b.hi, a.hi - b.lo);
  }
  friend Interval operator*(const Interval& a, const Interval& b) {
    return hull(a.lo * b.lo, a.lo * b.hi, a.hi * b.lo, a.hi * b.hi);
  }
  /// The divisor does not contain 0, or the quotient is everything.
  friend Interval operator/(const Interval& a, const Interval& b) {
    if (b.lo <= 0 && b.hi >= 0) return everything();
    if (b.hi < 0) return -a / -b;
    const double low = a.lo / (a.lo < 0 ? b.lo : b.hi), high = a.hi / (a.hi < 0 ? b.hi : b.lo);
    // not covered: the filter divides by numbers above 2^-60
    return std::isnan(low + high) ? everything() : outward(low, high);
  }
  friend Interval sqrt(const Interval& a) {
    return {std::max(0.0, interval_detail::next_down(std::sqrt(std::max(0.0, a.lo)))),
            interval_detail::next_up(std::sqrt(std::max(0.0, a.hi)))};
  }
  friend Interval abs(const Interval& a) {
    if (a.lo >= 0) return a;
    if (a.hi <= 0) return -a;
    return {0, std::max(-a.lo, a.hi)};
  }
  friend Interval square(const Interval& a) {
    const Interval m = abs(a);
    return {std::max(0.0, interval_detail::next_down(m.lo * m.lo)), interval_detail::next_up(m.hi * m.hi)};
  }

 private:
  static Interval hull(double p, double q, double r, double s) {
    if (std::isnan(p + q + r + s)) return everything();
    return outward(std::min(std::min(p, q), std::min(r, s)), std::max(std::max(p, q), std::max(r, s)));
  }
};

}  // namespace cyl
