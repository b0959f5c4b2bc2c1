// SPDX-License-Identifier: MIT
// Closed intervals of doubles or long doubles, every operation rounded outward by at least one unit in the
// last place of the nearest result. Needs only that + - * / sqrt round to nearest. An overflow makes an end
// infinite; a result that is not a number becomes [-inf, inf], which proves nothing.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace cyl {

namespace interval_detail {
inline double next_up(double x) {
  if (!(x < std::numeric_limits<double>::infinity())) return std::numeric_limits<double>::infinity();
  if (x == 0) return 0x1p-1074;
  const auto bits = std::bit_cast<std::int64_t>(x);
  return std::bit_cast<double>(bits + (x > 0 ? 1 : -1));
}
// Of long doubles near 1, relative.
inline constexpr long double long_spacing = [] {
  long double spacing = 1;
  for (int digit = 1; digit < std::numeric_limits<long double>::digits; ++digit) spacing /= 2;
  return spacing;
}();
// |x| times the relative spacing is at least the spacing at x, and of the least numbers the last term is; a
// sum rounded to nearest does not fall short of a number that the sum itself reaches.
inline long double next_up(long double x) {
  using Limits = std::numeric_limits<long double>;
  static_assert(Limits::is_iec559, "sums of long doubles round to nearest");
  if (!(x < Limits::infinity())) return Limits::infinity();
  if (x < Limits::lowest()) return Limits::lowest();
  return x + (std::fabs(x) * long_spacing + Limits::denorm_min());
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
