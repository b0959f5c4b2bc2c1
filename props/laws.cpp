// SPDX-License-Identifier: MIT
#include "props/laws.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "corpus/pair_io.hpp"

namespace cyl {
namespace {

/// What a law expects of the second answer: the first one's distance and point times `length`, its direction
/// times `direction`.
struct Expected {
  double length = 1;
  double direction = 1;
};

std::string differ(const char* what, double wanted, double got) {
  return std::string(what) + " is " + format_double(got) + ", expected " + format_double(wanted);
}

// Numbers are the same by ==, so 0 is -0, and where the first one times `factor` has lost bits to underflow,
// on either side of the product, within the bits lost.
bool same(double first, double second, double factor) {
  const double lost = std::max(1.0, std::fabs(factor)) * std::numeric_limits<double>::denorm_min();
  return second == factor * first || std::fabs(second - factor * first) <= lost;
}

std::string difference(const MethodAnswer& first, const MethodAnswer& second, const Expected& expected,
                       Agreement agreement) {
  if (first.status != Status::answered || second.status != Status::answered) return {};
  if (first.verdict != second.verdict) {
    return std::string("the verdict turns from ") + to_string(first.verdict) + " to " +
           to_string(second.verdict);
  }
  if (agreement == Agreement::verdict) return {};
  if (first.has_distance != second.has_distance) return "only one answer has a distance";
  if (first.has_distance && !same(first.distance, second.distance, expected.length)) {
    return differ("the distance", expected.length * first.distance, second.distance);
  }
  if (first.witness != second.witness) return "the witnesses are of different kinds";
  if (first.witness == WitnessKind::none) return {};
  const bool is_direction = first.witness == WitnessKind::direction;
  const double factor = is_direction ? expected.direction : expected.length;
  for (int i = 0; i < 3; ++i) {
    for (const auto& [x, y] :
         {std::pair{first.head[i], second.head[i]}, std::pair{first.tail[i], second.tail[i]}}) {
      if (!same(x, y, factor)) return differ("a coordinate of the witness", factor * x, y);
    }
  }
  return {};
}

std::string break_swap(Method& method, const Pair& pair, Agreement agreement) {
  return difference(method.ask(pair), method.ask({pair.b, pair.a}), {.direction = -1}, agreement);
}

/// Below this, answers of a pair lose bits that count.
constexpr double least_scaled_length = 0x1p-900;

/// The pair with all lengths times 2^k, or nothing where that is not exact or leaves a pair too small.
std::optional<Pair> scaled(Pair pair, int k) {
  double largest = 0;
  for (Cylinder* c : {&pair.a, &pair.b}) {
    for (double* x : {&c->center.x(), &c->center.y(), &c->center.z(), &c->radius, &c->height}) {
      const double length = std::ldexp(*x, k);
      if (!std::isfinite(length) || std::ldexp(length, -k) != *x) return {};
      largest = std::max(largest, std::fabs(length));
      *x = length;
    }
  }
  if (largest < least_scaled_length || std::ldexp(largest, -k) < least_scaled_length) return {};
  return pair;
}

std::string break_scaling(Method& method, const Pair& pair, Agreement agreement) {
  const MethodAnswer first = method.ask(pair);
  // One step each way, and farther than float or an absolute tolerance bears.
  for (int k : {-400, -1, 1, 400}) {
    const std::optional<Pair> other = scaled(pair, k);
    if (!other) continue;
    const std::string what = difference(first, method.ask(*other), {.length = std::ldexp(1, k)}, agreement);
    if (!what.empty()) return "times 2^" + std::to_string(k) + ": " + what;
  }
  return {};
}

std::string break_reversal(Method& method, const Pair& pair, Agreement agreement) {
  const MethodAnswer first = method.ask(pair);
  const Cylinder a{pair.a.center, -pair.a.axis, pair.a.radius, pair.a.height};
  const Cylinder b{pair.b.center, -pair.b.axis, pair.b.radius, pair.b.height};
  for (const Pair& other : {Pair{a, pair.b}, Pair{pair.a, b}, Pair{a, b}}) {
    std::string what = difference(first, method.ask(other), {}, agreement);
    if (!what.empty()) return what;
  }
  return {};
}

constexpr std::array<Law, 3> laws{{
    {1, "swap",
     "the cylinders in the other order: the same verdict, distance and point, the direction negated",
     break_swap},
    {2, "scaling", "all lengths times 2^k: the same verdict and direction, distance and point times 2^k",
     break_scaling},
    {3, "reversal", "an axis reversed: the same verdict, distance, direction and point", break_reversal},
}};

}  // namespace

Agreement promised(const Method& method) {
  const bool computed =
      method.name() == "intersect" || method.name() == "decide" || method.name() == "distance";
  return computed ? Agreement::every_bit : Agreement::verdict;
}

std::span<const Law> exact_laws() { return laws; }

}  // namespace cyl
