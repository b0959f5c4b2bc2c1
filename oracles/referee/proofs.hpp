// SPDX-License-Identifier: MIT
// Code that the referee's proofs share: exact numbers, and truths with their certificates.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "corpus/pairs/certificate.hpp"
#include "oracles/referee/certificate_check.hpp"
#include "oracles/referee/multiprecision.hpp"
#include "oracles/referee/search.hpp"

namespace cyl {

inline constexpr double no_tail[3] = {0, 0, 0};
inline constexpr int first_multiprecision_bits = 128;
inline constexpr int tangency_bits = 256;  ///< up to which contacts at simple rationals show themselves
/// Decimal digits of the size to try for a short point. 3 are enough to stay in the middle of a contact, 21
/// show every coordinate above a 10,000th of the size.
inline constexpr int short_digits[] = {3, 6, 9, 12, 15, 18, 21};
inline constexpr int near_bits = 512;  ///< enough for a point within 2^-200 size of both solids

bool finite(const double v[3]);
Rational3 sum(const double head[3], const double tail[3]);

/// As doubles if they hold it exactly, else as "n/d".
ExactVector exact_vector(const Rational3& v);
ExactVector exact_vector(const double head[3], const double tail[3]);

/// `certificate` is a direction for disjoint, else a point.
Truth proved(Verdict verdict, ExactVector certificate, Stage stage, int bits);

/// The result of the searches in double, in a unit of 2^exponent, relative to a's centre: that of the cores,
/// and their nearest points.
struct Guess {
  Found<double> found;
  Vec3<double> on_a{}, on_b{};
  int exponent = 0;
};

SearchPair<MpFloat> multiprecision_pair(const Pair& pair);
Rational3 rational(const Vec3<MpFloat>& v);

/// Returns nothing if the direction does not separate, at this precision or at twice as many bits.
std::optional<Truth> prove_disjoint(const Pair& pair, const Rational3& direction, int bits);

/// A common point found from a guess. It is the guess rounded to a's centre plus a double, which is short,
/// and good enough for all but the closest calls. Or it is the guess moved exactly into the lines and planes
/// of the flat solids.
struct CommonPoint {
  Rational3 point;
  ExactVector written;
};
std::optional<CommonPoint> common_point(const Pair& pair, const Rational3& guess);

/// The sum of all lengths but the distance of the centres, as size_of(), exactly.
mpq_class exact_size(const Pair& pair);
mpq_class times_power(mpq_class x, int exponent);
/// Returns the simplest rationals whose distance from each coordinate is at most 2^-(bits/4) times the size.
Rational3 simplest_near(const Pair& pair, const Rational3& point, int bits);
/// Rounds each coordinate to so many decimal digits of the size, then to the nearest double. A coordinate
/// stays as it is if there is none.
Rational3 short_near(const Pair& pair, const Rational3& point, int digits);

}  // namespace cyl
