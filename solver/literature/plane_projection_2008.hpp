// SPDX-License-Identifier: MIT
// Sections 2.2 and 5 of the text of 2008: solids whose projections to one plane have no point in common are
// separated.
#pragma once

#include <array>

#include "solver/literature/document.hpp"

namespace cyl::literature {

/// The projection of a solid to the plane N.X = 0, P X = X - (N.X) N: between P(C +- (h/2) W) a rectangle,
/// about these points two ellipses. W along N leaves a disk, W square to N the rectangle.
struct Region {
  enum class Kind : unsigned char { disk, rectangle, rectangle_with_caps };

  /// N of length 1.
  Region(const Prepared& solid, const Vector3& n) noexcept;

  /// The corners of the rectangle, in order round it.
  std::array<Vector3, 4> corners() const noexcept;
  /// The quadratic form that is 1 on either ellipse, y being the vector from its centre; for no rectangle.
  double ellipse(const Vector3& y) const noexcept;
  /// The vector from the middle to the point of the region that is farthest along D, a vector of the plane.
  Vector3 farthest(const Vector3& d) const noexcept;

  Kind kind;
  Vector3 middle;  ///< P C
  Vector3 u, v;    ///< Unit axes of the ellipses: u square to W, v along P W (of a disk any two).
  double side;     ///< half a side of the rectangle, along v: (h/2) |P W|
  double r;        ///< half its other side, and half an axis of the ellipses, along u
  double cap;      ///< half their other axis: r |N.W|
};

/// A vector of the plane along which the regions are apart, by bisection of the half circle on which the sum
/// of their reaches, less Delta's, has one valley. 0 if none was found.
Vector3 separation_in_plane(const Region& a, const Region& b, const Vector3& n,
                            const Options& options) noexcept;

}  // namespace cyl::literature
