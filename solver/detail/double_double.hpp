// SPDX-License-Identifier: MIT
// Numbers of twice the digits of double, as unevaluated sums of two doubles. sections.hpp uses them if
// rounding in double decides. The relative error of every operation is at most 2^-100 (Dekker 1971, Knuth's
// two-sum). There are no fused operations, so results are the same on any machine. Numbers must be within
// 2^-400 and 2^400.
#pragma once

#include "solver/detail/sections.hpp"

namespace cyl {

struct DoubleDouble {
  double hi, lo;  // |lo| at most half a unit in the last place of hi

  DoubleDouble() = default;
  constexpr DoubleDouble(double x) noexcept : hi(x), lo(0) {}  // NOLINT: every double is one
  constexpr DoubleDouble(double high, double low) noexcept : hi(high), lo(low) {}
};

// a + b exactly, as its rounding and what that leaves.
inline DoubleDouble exact_sum(double a, double b) noexcept {
  const double sum = a + b, part = sum - a;
  return {sum, (a - (sum - part)) + (b - part)};
}

// The same if |a| >= |b|.
inline DoubleDouble ordered_sum(double a, double b) noexcept {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

// a b exactly, from halves of 26 digits.
inline DoubleDouble exact_product(double a, double b) noexcept {
  constexpr double splitter = 0x1p27 + 1;
  const double p = a * b, wide_a = splitter * a, wide_b = splitter * b;
  const double a1 = wide_a - (wide_a - a), a2 = a - a1, b1 = wide_b - (wide_b - b), b2 = b - b1;
  return {p, ((a1 * b1 - p) + a1 * b2 + a2 * b1) + a2 * b2};
}

inline DoubleDouble operator-(const DoubleDouble& a) noexcept { return {-a.hi, -a.lo}; }

inline DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) noexcept {
  const DoubleDouble high = exact_sum(a.hi, b.hi), low = exact_sum(a.lo, b.lo);
  const DoubleDouble sum = ordered_sum(high.hi, high.lo + low.hi);
  return ordered_sum(sum.hi, sum.lo + low.lo);
}
inline DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) noexcept { return a + (-b); }

inline DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) noexcept {
  const DoubleDouble p = exact_product(a.hi, b.hi);
  return ordered_sum(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi));
}

// Three digits of long division.
inline DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) noexcept {
  const double first = a.hi / b.hi;
  const DoubleDouble rest = a - b * first;
  const double second = rest.hi / b.hi;
  const double third = (rest - b * second).hi / b.hi;
  return ordered_sum(first, second) + third;
}

inline bool operator<(const DoubleDouble& a, const DoubleDouble& b) noexcept {
  return (a.hi < b.hi) | ((a.hi == b.hi) & (a.lo < b.lo));
}
inline bool operator>(const DoubleDouble& a, const DoubleDouble& b) noexcept { return b < a; }
inline bool operator<=(const DoubleDouble& a, const DoubleDouble& b) noexcept {
  return (a.hi < b.hi) | ((a.hi == b.hi) & (a.lo <= b.lo));
}
inline bool operator>=(const DoubleDouble& a, const DoubleDouble& b) noexcept { return b <= a; }

inline DoubleDouble magnitude(const DoubleDouble& x) noexcept { return x.hi < 0 ? -x : x; }
inline DoubleDouble larger(const DoubleDouble& a, const DoubleDouble& b) noexcept { return a < b ? b : a; }
inline DoubleDouble smaller(const DoubleDouble& a, const DoubleDouble& b) noexcept { return b < a ? b : a; }
inline DoubleDouble positive(const DoubleDouble& x) noexcept { return x.hi > 0 ? x : 0.0; }
inline DoubleDouble pick(bool mask, const DoubleDouble& a, const DoubleDouble& b) noexcept {
  return mask ? a : b;
}

// One step of Newton for 1/sqrt(x) from double.
inline DoubleDouble root(const DoubleDouble& x) noexcept {
  if (!(x.hi > 0)) return 0.0;
  const double near = root(x.hi);
  return ordered_sum(near, (x - exact_product(near, near)).hi / (2 * near));
}

}  // namespace cyl
