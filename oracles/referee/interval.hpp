// SPDX-License-Identifier: MIT
// Closed intervals of doubles or long doubles, every operation rounded outward by at least one unit in the
// last place of the nearest result. Needs only that + - * / sqrt round to nearest. An overflow makes an end
// infinite; a result that is not a number becomes [-inf, inf], which proves nothing.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace cyl {

namespace interval_detail {
// Half the spacing of numbers at 1, and a bit more.
template <class R>
inline constexpr R half_spacing = [] {
  R half = 1;
  for (int digit = 0; digit < std::numeric_limits<R>::digits; ++digit) half /= 2;
  return half * (1 + 2 * half);
}();
// The successor of x, or the number after it (Rump, Zimmermann, Boldo, Melquiond, BIT 49, 2009). The rounded
// product of |x| and half_spacing is more than half the way from x to its successor. So the sum is not
// rounded back to x. If that product underflows, the least number is the whole way.
template <class R>
R next_up(R x) {
  using Limits = std::numeric_limits<R>;
  static_assert(Limits::is_iec559, "sums round to nearest");
  if (!(std::fabs(x) < Limits::infinity())) return x < 0 ? Limits::lowest() : Limits::infinity();
  return x + (std::fabs(x) * half_spacing<R> + Limits::denorm_min());
}
template <class R>
R next_down(R x) {
  return -next_up(-x);
}
}  // namespace interval_detail

template <class R>
struct BasicInterval {
  R lo, hi;
  BasicInterval() : lo(0), hi(0) {}
  BasicInterval(R x) : lo(x), hi(x) {}  // NOLINT: a number is an interval
  BasicInterval(R l, R h) : lo(l), hi(h) {}

  static BasicInterval everything() {
    return {-std::numeric_limits<R>::infinity(), std::numeric_limits<R>::infinity()};
  }
  static BasicInterval outward(R l, R h) {
    return {interval_detail::next_down(l), interval_detail::next_up(h)};
  }

  friend BasicInterval operator-(const BasicInterval& a) { return {-a.hi, -a.lo}; }
  friend BasicInterval operator+(const BasicInterval& a, const BasicInterval& b) {
    return outward(a.lo + b.lo, a.hi + b.hi);
  }
  friend BasicInterval operator-(const BasicInterval& a, const BasicInterval& b) {
    return outward(a.lo - b.hi, a.hi - b.lo);
  }
  friend BasicInterval operator*(const BasicInterval& a, const BasicInterval& b) {
    return hull(a.lo * b.lo, a.lo * b.hi, a.hi * b.lo, a.hi * b.hi);
  }
  /// The divisor does not contain 0, or the quotient is everything.
  friend BasicInterval operator/(const BasicInterval& a, const BasicInterval& b) {
    if (b.lo <= 0 && b.hi >= 0) return everything();
    if (b.hi < 0) return -a / -b;
    const R low = a.lo / (a.lo < 0 ? b.lo : b.hi), high = a.hi / (a.hi < 0 ? b.hi : b.lo);
    // not covered: the filter divides by numbers above 2^-60
    return std::isnan(low + high) ? everything() : outward(low, high);
  }
  friend BasicInterval sqrt(const BasicInterval& a) {
    return {std::max(R(0), interval_detail::next_down(std::sqrt(std::max(R(0), a.lo)))),
            interval_detail::next_up(std::sqrt(std::max(R(0), a.hi)))};
  }
  friend BasicInterval abs(const BasicInterval& a) {
    if (a.lo >= 0) return a;
    if (a.hi <= 0) return -a;
    return {0, std::max(-a.lo, a.hi)};
  }
  friend BasicInterval square(const BasicInterval& a) {
    const BasicInterval m = abs(a);
    return {std::max(R(0), interval_detail::next_down(m.lo * m.lo)), interval_detail::next_up(m.hi * m.hi)};
  }

 private:
  static BasicInterval hull(R p, R q, R r, R s) {
    if (std::isnan(p + q + r + s)) return everything();
    return outward(std::min(std::min(p, q), std::min(r, s)), std::max(std::max(p, q), std::max(r, s)));
  }
};

using Interval = BasicInterval<double>;

}  // namespace cyl
