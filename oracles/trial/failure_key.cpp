// SPDX-License-Identifier: MIT
#include "oracles/trial/failure_key.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "base/fnv.hpp"
#include "oracles/referee/referee.hpp"
#include "oracles/trial/contact.hpp"
#include "oracles/trial/trial.hpp"

namespace cyl {
namespace {

/// A size below or above these, in the scene's unit, counts as extreme.
constexpr std::pair<double, double> plain_sizes_margin{1e-3, 1e3};
/// The ratio of the longer length to the shorter.
constexpr double plain_ratio_margin = 100;
constexpr double small_margin = 1e-3;

bool uneven(double x, double y) {
  return x > 0 && y > 0 && std::max(x, y) / plain_ratio_margin > std::min(x, y);
}

}  // namespace

Coordinate coordinate_of(const Pair& p, double margin) {
  const double size = size_of(p), far_away = offset_size_margin * size;
  const double a = p.a.center.stableNorm(), b = p.b.center.stableNorm();
  const double apart = (p.b.center / 2 - p.a.center / 2).stableNorm() * 2;
  if (size > 0 && std::min(a, b) > far_away && apart <= std::min(a, b)) return Coordinate::offset;
  if (size > 0 && (size < plain_sizes_margin.first || size > plain_sizes_margin.second))
    return Coordinate::scale;
  const Extents of_a = extents_of(is_half_space(p.a) ? p.b : p.a),
                of_b = extents_of(is_half_space(p.b) ? p.a : p.b);
  if (uneven(of_a.across, of_a.along) || uneven(of_b.across, of_b.along) ||
      uneven(of_a.across / 2 + of_a.along, of_b.across / 2 + of_b.along))
    return Coordinate::aspect;
  const AngleClass angle = angle_class(p);
  if (angle != AngleClass::parallel && angle != AngleClass::generic && angle != AngleClass::right)
    return Coordinate::angle;
  return margin < small_margin ? Coordinate::margin : Coordinate::plain;
}

std::string failure_key(std::string_view method, std::string_view failure, std::string_view feature,
                        Coordinate coordinate) {
  std::string key(method);
  key.append("/").append(failure).append("/").append(feature);
  return key.append("/").append(to_string(coordinate));
}

std::string failure_key_of(std::string_view method, std::string_view failure, const Pair& pair) {
  Trial trial(pair);
  const double size = size_of(pair);
  const double margin = trial.decided() && size > 0 ? magnitude_against(0, trial).hi / size : 0;
  return failure_key(method, failure, contact_in_words(pair, trial.truth), coordinate_of(pair, margin));
}

std::string letter_hash(std::string_view key) {
  constexpr unsigned letters = 12;
  const std::uint64_t hash = fnv1a(key);
  std::string text;
  for (unsigned i = letters; i-- > 0;) text.push_back(static_cast<char>('a' + (hash >> (4 * i) & 15)));
  return text;
}

}  // namespace cyl
