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
  constexpr std::size_t b = solid_number_count;
  constexpr std::array<std::size_t, 2 * b> order{
      13, 14,    15, 12, 13 + b, 14 + b, 15 + b, 12 + b, 3, 4, 5, 3 + b, 4 + b, 5 + b, 6, 6 + b,
      7,  7 + b, 9,  10, 11,     9 + b,  10 + b, 11 + b, 0, 1, 2, b,     1 + b, 2 + b, 8, 8 + b};
  const std::array<double, 2 * b> numbers = numbers_of(pair);
  const auto has = [&](std::size_t place) {
    return std::ranges::count(places_of((place < b ? pair.a : pair.b).shape), place % b) > 0;
  };
  std::set<double> distinct;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (!has(order[i])) continue;
    const double x = numbers[order[i]];
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
  c.rounded = (pair.a.rounding > 0) + (pair.b.rounding > 0);
  for (const Solid* s : {&pair.a, &pair.b}) {
    const double turn = is_box(*s) ? Eigen::Vector4d(s->quaternion.data()).cwiseAbs().maxCoeff()
                                   : s->axis.cwiseAbs().maxCoeff();
    for (const double x : {s->radius, s->height, s->rounding, s->edges[0], s->edges[1], s->edges[2], turn})
      c.extremes += std::max(0, std::abs(decimal_of(x).exponent) - 1);
  }
  c.distinct = static_cast<int>(distinct.size());
  return c;
}

}  // namespace cyl
