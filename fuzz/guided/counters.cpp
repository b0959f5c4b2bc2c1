// SPDX-License-Identifier: MIT
#include "fuzz/guided/counters.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "corpus/pairs/random_stream.hpp"
#include "oracles/trial/contact.hpp"

namespace cyl {
namespace {

/// Binary exponents of margins that have their own counters, from 2^0 down.
constexpr std::size_t exponent_count = 64;
constexpr std::size_t method_count = 64;
/// No direction shows containment.
constexpr std::size_t feature_count = contact_feature_count - 1, angle_count = enum_values<AngleClass>.size();

}  // namespace

struct Counters {
  std::uint8_t strata[feature_count][angle_count][margin_decade_count];
  std::uint8_t margins[2][feature_count][exponent_count];
  std::uint8_t sines[margin_decade_count + 1], cosines[margin_decade_count + 1];  // the last: exactly 0
  std::uint8_t scores[3][exponent_count];
  std::uint8_t differences[method_count * (method_count - 1) / 2];
};

// Not static, or a compiler drops them as unused.
__attribute__((section("__libfuzzer_extra_counters"))) Counters extra_counters;

namespace {

/// By the binary exponent of x, from 2^0 down; 0 and NaN count as the least.
void count_exponent(std::uint8_t (&counters)[exponent_count], double x) {
  const int exponent = x > 0 ? -std::ilogb(x) : static_cast<int>(exponent_count) - 1;
  counters[std::clamp(exponent, 0, static_cast<int>(exponent_count) - 1)] = 1;
}

double margin_of(const Pair& pair, const MeasuredDistance& measured) {
  const double size = size_of(pair);
  return size > 0 ? std::fabs(measured.value) / size : measured.value == 0 ? 0 : 1;
}

}  // namespace

Stratum stratum_of(const Pair& pair, const MeasuredDistance& measured) {
  return {feature_along(pair, measured.direction), margin_decade(margin_of(pair, measured)),
          angle_class(axes_angle(pair))};
}

bool is_moderate(const Pair& pair) {
  double largest = 0;
  const auto lengths = [](const Solid& c) {
    return std::array{c.radius, c.height, c.rounding, c.edges[0], c.edges[1], c.edges[2]};
  };
  for (const Solid* c : {&pair.a, &pair.b}) largest = std::max(largest, std::ranges::max(lengths(*c)));
  const auto fits = [&](double x) { return x == 0 || x * moderate_factor >= largest; };
  for (const Solid* c : {&pair.a, &pair.b})
    if (!std::ranges::all_of(lengths(*c), fits) ||
        !(c->center.cwiseAbs().maxCoeff() <= largest * moderate_factor))
      return false;
  return true;
}

std::string to_string(const Stratum& s) {
  return std::string(to_string(s.feature)) + ' ' + to_string(*s.angle) + " 1e-" + std::to_string(s.decade);
}

Stratum count_geometry(const Pair& pair, const MeasuredDistance& measured, bool finely) {
  const AxesAngle axes = axes_angle(pair);
  const double margin = margin_of(pair, measured);
  const Stratum s = stratum_of(pair, measured);
  const auto feature = static_cast<std::size_t>(s.feature), angle = static_cast<std::size_t>(*s.angle);
  if (is_moderate(pair)) extra_counters.strata[feature][angle][static_cast<std::size_t>(s.decade)] = 1;
  if (!finely) return s;
  count_exponent(extra_counters.margins[measured.value > 0][feature], margin);
  extra_counters.sines[axes.parallel ? margin_decade_count : margin_decade(axes.sine)] = 1;
  extra_counters.cosines[axes.right ? margin_decade_count : margin_decade(axes.cosine)] = 1;
  return s;
}

void count_badness(Badness badness, double score) {
  count_exponent(extra_counters.scores[static_cast<std::size_t>(badness)], score);
}

void count_difference(std::size_t i, std::size_t j) {
  if (j < method_count) extra_counters.differences[j * (j - 1) / 2 + i] = 1;
}

}  // namespace cyl
