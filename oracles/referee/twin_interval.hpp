// SPDX-License-Identifier: MIT
// Sums of two doubles, which have twice the digits of one, and intervals about them. They need only that
// + - * / sqrt fma round to nearest. An overflow has an error that is not finite, or is not a number, and
// proves nothing.
//
// The bounds, with u = 2^-53, A = |a.hi| and B = |b.hi|. Each |lo| is at most u |hi|.
// 1. The rounding of a sum of two doubles is a double (Knuth). So is that of a product (fma), if it does not
//    underflow. An operation that underflows loses at most 2^-1075, and `least` covers all of them.
// 2. In a sum, `low` is rounded by at most u^2 (A + B), and the part below by at most 2 u^2 (A + B) and terms
//    of u^3. Together this is below 2^-104 (A + B), which is 4 u^2. Nothing is rounded if both lo are 0.
// 3. A product leaves out a.lo b.lo <= u^2 AB. It rounds two products (u^2 AB each), their sum (2 u^2 AB) and
//    the part below (3 u^2 AB). Together this is below 2^-102 AB, which is 16 u^2.
// 4. A quotient q of a and b is off by |a - q b| / |b|, and a root r of a by |a - r^2| / (sqrt(a) + r). Both
//    residues are computed in intervals, so nothing is assumed of q and r.
// 5. An error is a sum of positive doubles. `more` covers fewer than 2^4 roundings and the u of |lo|.
#pragma once

#include <cmath>
#include <compare>
#include <limits>

#include "base/vec3.hpp"

namespace cyl {

inline constexpr int twin_bits = 100;  ///< that the result of an operation has at least

/// Without a bound, for searches.
struct Twin {
  double hi = 0, lo = 0;

  Twin() = default;
  Twin(double x) : hi(x) {}  // NOLINT: a double is one
  static Twin sum_of(double a, double b) {
    Twin s = a + b;
    const double part = s.hi - a;
    s.lo = (a - (s.hi - part)) + (b - part);
    return s;
  }

  friend Twin operator-(Twin a) {
    a.hi = -a.hi;
    a.lo = -a.lo;
    return a;
  }
  friend Twin operator+(const Twin& a, const Twin& b) {
    const Twin high = sum_of(a.hi, b.hi);
    const double low = a.lo + b.lo;
    return sum_of(high.hi, high.lo + low);
  }
  friend Twin operator-(const Twin& a, const Twin& b) { return a + -b; }
  friend Twin operator*(const Twin& a, const Twin& b) {
    const double high = a.hi * b.hi;
    return sum_of(high, std::fma(a.hi, b.hi, -high) + (a.hi * b.lo + a.lo * b.hi));
  }
  friend Twin operator/(const Twin& a, const Twin& b) {
    const double first = a.hi / b.hi;
    return sum_of(first, (a - first * b).hi / b.hi);
  }
  friend Twin sqrt(const Twin& a) {
    if (!(a.hi > 0)) return 0.0;
    const double first = std::sqrt(a.hi);
    return sum_of(first, (a - Twin(first) * first).hi / (2 * first));
  }
  friend Twin abs(const Twin& a) { return a.hi < 0 ? -a : a; }
  friend auto operator<=>(const Twin&, const Twin&) = default;
};

struct TwinInterval {
  Twin middle;
  double error = 0;  ///< how far the number is from the middle, at most

  TwinInterval() = default;
  TwinInterval(double x) : middle(x) {}  // NOLINT: a number is an interval
  explicit TwinInterval(const Twin& x, double e = 0) : middle(x), error(e) {}
  static TwinInterval everything() { return TwinInterval(0.0, std::numeric_limits<double>::infinity()); }

  friend TwinInterval operator-(const TwinInterval& a) { return TwinInterval(-a.middle, a.error); }
  friend TwinInterval operator+(const TwinInterval& a, const TwinInterval& b) {
    const bool doubles = a.middle.lo == 0 && b.middle.lo == 0;
    const double rounding = doubles ? 0 : 0x1p-104 * (a.size() + b.size());
    return TwinInterval(a.middle + b.middle, (a.error + b.error + rounding) * more);
  }
  friend TwinInterval operator-(const TwinInterval& a, const TwinInterval& b) { return a + -b; }
  friend TwinInterval operator*(const TwinInterval& a, const TwinInterval& b) {
    const double of_factors = a.most() * b.error + b.most() * a.error;
    return TwinInterval(a.middle * b.middle, (of_factors + 0x1p-102 * (a.size() * b.size())) * more + least);
  }
  friend TwinInterval operator/(const TwinInterval& a, const TwinInterval& b) {
    const double divisor = b.size() * less - b.error;
    if (!(divisor > 0)) return everything();
    const TwinInterval quotient(a.middle / b.middle);
    return TwinInterval(quotient.middle, (a - quotient * b).most() / divisor * more + least);
  }
  /// The root of the numbers in it that are not negative.
  friend TwinInterval sqrt(const TwinInterval& a) {
    if (!(a.error < a.middle.hi)) return TwinInterval(0.0, std::sqrt(a.most()) * more + least);
    const TwinInterval root(sqrt(a.middle));
    return TwinInterval(root.middle, (a - root * root).most() / root.size() * more + least);
  }
  friend TwinInterval abs(const TwinInterval& a) { return TwinInterval(abs(a.middle), a.error); }
  /// The comparisons hold for all numbers of both intervals.
  friend bool surely_less(const TwinInterval& a, const TwinInterval& b) {
    const TwinInterval d = b - a;
    return d.middle.hi * less > d.error;
  }
  friend bool surely_at_most(const TwinInterval& a, const TwinInterval& b) {
    const TwinInterval d = b - a;
    return d.middle.hi * less >= d.error;
  }

 private:
  static constexpr double more = 1 + 0x1p-48, less = 1 - 0x1p-51, least = 0x1p-1060;
  double size() const { return std::fabs(middle.hi); }
  double most() const { return (size() + error) * more; }  ///< the greatest magnitude
};

inline Vec3<Twin> middle(const Vec3<TwinInterval>& v) { return {v.x.middle, v.y.middle, v.z.middle}; }
inline Vec3<TwinInterval> intervals(const Vec3<Twin>& v) {
  return {TwinInterval(v.x), TwinInterval(v.y), TwinInterval(v.z)};
}

}  // namespace cyl
