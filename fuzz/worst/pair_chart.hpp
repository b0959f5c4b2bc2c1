// SPDX-License-Identifier: MIT
// Maps the pairs around one pair to points of a box, for optimisers that do not know solids. Lengths have
// logarithmic coordinates. The angle of the axes has the decades of its difference to parallel or
// perpendicular. The axis of a box is the edge, or the normal of the facet, that meets the other solid.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>

#include "corpus/pairs/stratum.hpp"
#include "solver/solid.hpp"

namespace cyl {

/// The domain of the search. At sizes of 1e-300 or 1e150, or far from the origin, every method is wrong by
/// any margin. Without the domain a search would find only that.
struct Domain {
  double least_size = 1e-3, most_size = 1e3;  ///< size_of a pair, in the scene's unit
  double least_part = 1e-6;  ///< of its size that a radius or a height may be, if it is not 0
  double most_offset = 100;  ///< of a centre from the origin, in sizes
  bool fine = false;         ///< lengths may become 0, and the distance changes by decades as well
};

/// The pair scaled and moved into the domain, with too small lengths enlarged. It is unchanged, bit for bit,
/// if it is in the domain. Nothing for a pair that is not valid, has only points, or is too far out to be
/// scaled.
std::optional<Pair> bring_into(const Domain& domain, const Pair& pair);

/// Returns whether a pair is in the domain, rounding allowed for.
bool is_in(const Domain& domain, const Pair& pair);

/// A shape: two solids that touch, and the direction in which b moves away from a. Apart, the margin along it
/// is the distance; into each other it is no less than the depth.
struct Ray {
  Pair touching;
  Vector3 direction;
  double size;

  Pair at(double margin) const {
    Pair p = touching;
    p.b.center += margin * size * direction;
    return p;
  }
};

/// Returns the shape of a pair. Nothing if the direction of its distance is not known.
std::optional<Ray> ray_of(const Pair& pair);

class PairChart {
 public:
  static constexpr std::size_t dimensions = 17;
  using Point = std::array<double, dimensions>;

  /// Around a pair that is in the domain. Axes stay square to each other for `cap_side` and parallel for
  /// `cap_cap`: anything else would not be such a pair.
  PairChart(const Pair& start, std::optional<ContactFeature> feature, const Domain& domain);

  /// 0 is the start itself, bit for bit. Every point of the box is a legal pair of a size in the
  /// domain.
  Pair pair(std::span<const double, dimensions> x) const;
  const Point& low() const { return low_; }
  const Point& high() const { return high_; }
  /// Lengths of coordinates over which pairs change as much as a step of a search should change them.
  const Point& step() const { return step_; }

  /// Walks by NLopt from the start towards pairs of greater value. `first_step`: in each coordinate. `value`
  /// gives nothing to end the walk. Throws what it throws.
  void walk(const Point& first_step, const std::function<std::optional<double>(const Pair&)>& value) const;

 private:
  Vector3 turned_axis(double decades, double azimuth) const;

  Pair start_;
  std::optional<ContactFeature> feature_;
  Domain domain_;
  double size_;
  Vector3 a_, b_, aside_;      ///< the axes, unit; the direction square to a's towards which b's leans
  Vector3 on_a_, on_b_, gap_;  ///< the points that face each other, from their centres; from a's to b's
  double sign_, decades_;      ///< of b's axis along a's; see turned_axis
  Point low_, high_, step_;
};

}  // namespace cyl
