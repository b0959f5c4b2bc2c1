// SPDX-License-Identifier: MIT
// Lower bounds on f(D) = max over x in K of D.x - D.delta over unit directions D near a given one, for K =
// (solid a) - (solid b), both centred. Branch and bound over the sphere uses them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "corpus/pairs/support.hpp"
#include "oracles/referee/search.hpp"

namespace cyl {

using Vec = Vec3<double>;

/// Squares below this have lost digits, or soon will: lengths are scaled before they are squared.
inline constexpr double short_square_tol = 0x1p-900;
/// For any vector whose square does not overflow.
inline double length(const Vec& v) {
  const double square = dot(v, v);
  if (square > short_square_tol) return std::sqrt(square);
  const Vec longer = 0x1p600 * v;
  return 0x1p-600 * std::sqrt(dot(longer, longer));
}
/// The unit vector along any vector but 0. Short and long ones are scaled by a power of two, which is exact.
inline Vec normalized(const Vec& v) {
  const double square = dot(v, v);
  if (square > short_square_tol && square < 1 / short_square_tol) return (1 / std::sqrt(square)) * v;
  int exponent = 0;
  std::frexp(std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}), &exponent);
  const Vec even{std::ldexp(v.x, -exponent), std::ldexp(v.y, -exponent), std::ldexp(v.z, -exponent)};
  return (1 / std::sqrt(dot(even, even))) * even;
}
/// Some vector square to a unit vector, neither short nor longer than 1.
inline Vec square_to(const Vec& v) { return cross(v, std::fabs(v.x) < 0.5 ? Vec{1, 0, 0} : Vec{0, 1, 0}); }

/// Rounding in one bound or one value of f, as a multiple of the pair's reach r0 + h0 + r1 + h1 + |delta|. It
/// has 4 units for the axes, and fewer than 30 operations on terms up to the reach. It is doubled for the
/// sines and cosines of angles.
inline constexpr double bound_error = 64 * 0x1p-53;

/// All directions within an angle below a right one of the middle.
struct Cap {
  Vec center;
  double cosine, sine;  ///< of the angle
};

struct Bounds {
  double below;    ///< of f on the cap
  double value;    ///< of f at `direction`
  double nearest;  ///< length of some y of K - delta: the solids, if disjoint, are no farther apart
  Vec direction;
};

/// The axes of both solids must not be parallel. Every bound and value is right within bound_error * reach().
class DirectionBounds {
 public:
  explicit DirectionBounds(const SearchPair<double>& p);

  double reach() const { return reach_; }
  /// Returns both axes and their common normal, towards b. f often has its least value at one of them.
  std::array<Vec, 3> likely() const;
  /// f of a unit direction.
  double value(const Vec& d) const;
  /// A lower bound of f on the cap, off by O(angle^2) at most. Stops early at `enough`. Cost: 0.1 us, 0.6 us
  /// beside kinks.
  Bounds bounds(const Cap& cap, double enough) const;
  /// A bound that reaches the least value itself if f has a local minimum near `start`, and all of the
  /// cap is close enough to it. Stops at a bound of `enough`, or `width` below the value found. Cost: 1
  /// us.
  Bounds bounds_by_minimum(const Cap& cap, const Vec& start, double enough, double width) const;

 private:
  struct Kinks;
  struct Model;
  struct Frame;
  struct Principal;

  double term_by_term(const Cap& cap) const;
  Bounds plane(const Cap& cap, const Kinks& kinks) const;
  Model model(const Vec& d, const Kinks& kinks) const;
  static Principal principal(const Frame& at, const std::array<double, 3>& q);
  Frame frame(const Vec& d, const Kinks& kinks) const;
  std::array<double, 3> curvature(const Model& m, const Frame& frame, double q,
                                  const std::array<double, 2>& longest) const;
  Model settle(const Vec& start, const Kinks& kinks, double most) const;
  double bound_near(const Model& m, const Kinks& kinks, const Cap& cap) const;

  std::array<Terms<double>, 2> solids_;
  Vec delta_, normal_;
  double reach_, tilt_;  ///< tilt: the sine of the angle between the axes
};

}  // namespace cyl
