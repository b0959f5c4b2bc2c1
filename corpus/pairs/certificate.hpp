// SPDX-License-Identifier: MIT
// What is proved of a pair, as plain data: the verdict, its certificate, the distance. The referee makes
// them.
#pragma once

#include <array>
#include <string>
#include <tuple>

#include "base/enum_words.hpp"
#include "solver/cylinder.hpp"

namespace cyl {

/// What kind of vector proves a verdict, or is offered as a witness of it.
enum class CertificateKind : unsigned char { none, direction, point, near, points, near_points };
constexpr auto words_of(CertificateKind) noexcept {
  return std::array{"none", "direction", "point", "near", "points", "near_points"};
}

/// One vector of a certificate, exactly head + tail, or, where `exact` is not empty, the rationals written
/// there as "n/d" (or "n").
struct ExactVector {
  std::array<double, 3> head{0, 0, 0};
  std::array<double, 3> tail{0, 0, 0};
  std::array<std::string, 3> exact;
  bool in_doubles() const { return exact[0].empty() && exact[1].empty() && exact[2].empty(); }
};

/// The core of a solid is the solid without its rounding. direction: D with f(D) < 0, where f has both
/// roundings times |D|. point: in both cores. near: `vector` a point within 2^-200 size of both solids,
/// `second` a direction with |f| <= 2^-200 size |direction| (touching without a rational point). points:
/// `vector` in a's core and `second` in b's, no farther apart than both roundings together. near_points: as
/// near, of rounded solids, by `vector` and `third`, points within 2^-200 size of a's core and of b's and
/// no farther apart than both roundings and that.
struct Certificate {
  CertificateKind kind = CertificateKind::none;
  ExactVector vector;
  ExactVector second;
  /// Of a point: it is the point nearest to `vector` in these hulls of a and of b. Of points: each is the
  /// nearest in its own solid's hull. Of what is proved: space.
  std::array<Hull, 2> hulls{Hull::space, Hull::space};
  ExactVector third{};
};

/// The arithmetic that settled a question.
enum class Stage : unsigned char {
  filter,          ///< double, or long double, with outward rounding
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

/// A closed interval [lo, hi] that certainly holds the signed distance: > 0 the gap, < 0 minus the
/// penetration depth; in the scene's unit (a Finding's margin: relative to the size).
struct Enclosure {
  double lo = 0, hi = 0;

  static auto columns(auto& e) { return std::tie(e.lo, e.hi); }  ///< as it is stored
};

}  // namespace cyl
