// SPDX-License-Identifier: MIT
#include "props/shrink/complexity.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <set>

namespace cyl {
namespace {

int significant_bits(double x) {
  if (x == 0) return 0;
  int exponent = 0;
  const auto significand = static_cast<std::uint64_t>(std::ldexp(std::frexp(std::fabs(x), &exponent), 53));
  return 53 - std::countr_zero(significand);
}

}  // namespace

Decimal decimal_of(double x) {
  Decimal d;
  if (x == 0) return d;
  char text[40];
  const char* end = std::to_chars(text, text + sizeof text, std::fabs(x), std::chars_format::scientific).ptr;
  const char* e = std::find(static_cast<const char*>(text), end, 'e');
  for (const char* c = text; c != e; ++c)
    if (*c != '.') {
      ++d.digits;
      d.digit_sum += *c - '0';
    }
  std::from_chars(e + (e[1] == '+' ? 2 : 1), end, d.exponent);
  return d;
}

Complexity complexity(const Pair& pair) {
  Complexity c{};
  const Solid &a = pair.a, &b = pair.b;
  const std::array<double, 18> all{a.axis.x(),   a.axis.y(),   a.axis.z(),   b.axis.x(),   b.axis.y(),
                                   b.axis.z(),   a.radius,     b.radius,     a.height,     b.height,
                                   a.center.x(), a.center.y(), a.center.z(), b.center.x(), b.center.y(),
                                   b.center.z(), a.rounding,   b.rounding};
  std::set<double> distinct;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double x = all[i];
    const Decimal d = decimal_of(x);
    c.digits += d.digits;
    c.exponents += std::abs(d.exponent);
    c.digit_sum += d.digit_sum;
    c.non_zero += x != 0;
    c.fractional += x != std::round(x);
    c.bits += significant_bits(x);
    c.negative += std::signbit(x);
    c.values[i] = std::fabs(x);
    c.signs[i] = std::signbit(x);
    if (x != 0) distinct.insert(std::fabs(x));
  }
  c.rounded = (a.rounding > 0) + (b.rounding > 0);
  for (const Solid* s : {&a, &b})
    for (const double x : {s->radius, s->height, s->rounding, s->axis.cwiseAbs().maxCoeff()})
      c.extremes += std::max(0, std::abs(decimal_of(x).exponent) - 1);
  c.distinct = static_cast<int>(distinct.size());
  return c;
}

}  // namespace cyl
