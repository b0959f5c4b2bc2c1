// SPDX-License-Identifier: MIT
// What the referee's ways of proving share: numbers exactly, and truths with their certificates.
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
inline constexpr int near_bits = 512;      ///< enough for a point within 2^-200 size of both solids

bool finite(const double v[3]);
Rational3 sum(const double head[3], const double tail[3]);

/// As doubles where they hold it exactly, else as "n/d".
ExactVector exact_vector(const Rational3& v);
ExactVector exact_vector(const double head[3], const double tail[3]);

/// By a direction where disjoint, else by a point.
Truth proved(Verdict verdict, ExactVector certificate, Stage stage, int bits);

/// What the searches in double found, in a unit of 2^exponent, relative to a's centre: of the cores, and the
/// points of either by which they are nearest.
struct Guess {
  Found<double> found;
  Vec3<double> on_a{}, on_b{};
  int exponent = 0;
};

SearchPair<MpFloat> multiprecision_pair(const Pair& pair);
Rational3 rational(const Vec3<MpFloat>& v);

/// Nothing where the direction does not separate, at this precision or at twice as many bits.
std::optional<Truth> prove_disjoint(const Pair& pair, const Rational3& direction, int bits);

mpq_class exact_size(const Pair& pair);
mpq_class times_power(mpq_class x, int exponent);
/// The simplest rationals within 2^-(bits/4) of the size of each coordinate.
Rational3 simplest_near(const Pair& pair, const Rational3& point, int bits);

}  // namespace cyl
