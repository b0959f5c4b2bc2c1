// SPDX-License-Identifier: MIT
// The proved facts of a pair, as plain data: the verdict, its certificate, the distance. The referee makes
// them.
#pragma once

#include <array>
#include <string>
#include <tuple>

#include "base/enum_words.hpp"
#include "solver/solid.hpp"

namespace cyl {

/// The kind of vector that proves a verdict, or that a method returns as its witness.
enum class CertificateKind : unsigned char { none, direction, point, near, points, near_points };
constexpr auto words_of(CertificateKind) noexcept {
  return std::array{"none", "direction", "point", "near", "points", "near_points"};
}

/// One vector of a certificate: exactly head + tail or, if `exact` is not empty, the rationals in it as "n/d"
/// (or "n").
struct ExactVector {
  std::array<double, 3> head{0, 0, 0};
  std::array<double, 3> tail{0, 0, 0};
  std::array<std::string, 3> exact;
  bool in_doubles() const { return exact[0].empty() && exact[1].empty() && exact[2].empty(); }
};

/// The fields of each kind. The core of a solid is the solid without its rounding.
/// * direction: D with f(D) < 0. Here f has both roundings times |D|.
/// * point: a point in both cores.
/// * near: `vector` is a point within 2^-200 size of both solids, and `second` a direction with |f| <= 2^-200
///   size |direction|. They touch without a rational point.
/// * points: `vector` is in a's core and `second` in b's. Their distance is at most the sum of both
///   roundings.
/// * near_points: as near, for rounded solids. `vector` and `third` are points within 2^-200 size of the
///   cores of a and b. Their distance is at most the sum of both roundings and 2^-200 size.
struct Certificate {
  CertificateKind kind = CertificateKind::none;
  ExactVector vector;
  ExactVector second;
  /// For a point: it is the nearest point to `vector` in these hulls of a and of b. For points: each is the
  /// nearest in the hull of its own solid. For a proved certificate: space.
  std::array<Hull, 2> hulls{Hull::space, Hull::space};
  ExactVector third{};
};

/// The arithmetic that settled a question.
enum class Stage : unsigned char {
  filter,          ///< double, or sums of two doubles, with bounds of rounding
  multiprecision,  ///< MPFI; in files and on screens "wide"
  exact            ///< rationals
};
constexpr auto words_of(Stage) noexcept { return std::array{"filter", "wide", "exact"}; }

struct Truth {
  Verdict verdict = Verdict::undecided;  ///< disjoint, intersecting, touching, undecided or invalid
  Certificate certificate;
  Stage stage = Stage::filter;
  int bits = 53;           ///< the widest precision that was used
  bool witnessed = false;  ///< settled by a witness that an answer offered
};

/// A closed interval [lo, hi] that certainly contains the signed distance: > 0 the gap, < 0 minus the
/// penetration depth. The unit is that of the scene. A Finding's margin is relative to the size.
struct Enclosure {
  double lo = 0, hi = 0;

  static auto columns(auto& e) { return std::tie(e.lo, e.hi); }  ///< as it is stored
};

}  // namespace cyl
