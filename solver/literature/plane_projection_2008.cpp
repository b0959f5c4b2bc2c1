// SPDX-License-Identifier: MIT
#include "solver/literature/plane_projection_2008.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "solver/detail/frame.hpp"

namespace cyl::literature {

// V = W x U is in the plane of N and W, so P V is along P W, and |P V| = |N.W|.
Region::Region(const Prepared& s, const Vector3& n) noexcept : r(s.radius) {
  const double along = dot(n, s.unit_axis);
  const Vector3 across = s.unit_axis.cross(n), pw = n.cross(across);  // |P W| = |W x N|
  const double size = length(across);
  kind = !(size > 0) ? Kind::disk : along == 0 ? Kind::rectangle : Kind::rectangle_with_caps;
  middle = s.center - dot(n, s.center) * n;
  u = size > 0 ? Vector3(across / size) : n.unitOrthogonal();
  v = size > 0 ? Vector3(pw / size) : n.cross(u);
  side = s.height / 2 * size;
  cap = r * std::fabs(along);
}

std::array<Vector3, 4> Region::corners() const noexcept {
  const Vector3 x = r * u, y = side * v;
  return {middle + x + y, middle - x + y, middle - x - y, middle + x - y};
}

double Region::ellipse(const Vector3& y) const noexcept {
  const double x = dot(y, u) / r, z = dot(y, v) / cap;
  return x * x + z * z;
}

Vector3 Region::farthest(const Vector3& d) const noexcept {
  const double x = r * dot(d, u), along = dot(d, v), z = cap * along, size = std::hypot(x, z);
  const Vector3 end = along > 0 ? Vector3(side * v) : along < 0 ? Vector3(-side * v) : Vector3(0, 0, 0);
  if (!(size > 0)) return end;
  return end + r * x / size * u + cap * z / size * v;
}

// With q = the farthest points of both, less Delta, F(D) = D.q, and q is F's gradient: the valley is where q
// turns from one side of D to the other.
Vector3 separation_in_plane(const Region& a, const Region& b, const Vector3& n,
                            const Options& options) noexcept {
  const Vector3 delta = b.middle - a.middle;
  const double reach = length(delta);
  if (!(reach > 0)) return {0, 0, 0};
  const Vector3 e = delta / reach, f = n.cross(e);
  Vector3 low = -f, high = f, d = e;
  for (int i = 0; i < options.step_cap && max_abs(high - low) > options.tolerance; ++i) {
    const Vector3 q = a.farthest(d) + b.farthest(d) - delta;
    if (dot(d, q) < 0) return d;
    // d x q along n: F rises as D turns from e to f.
    (dot(n, d.cross(q)) > 0 ? high : low) = d;
    d = (low + high).normalized();
  }
  return {0, 0, 0};
}

}  // namespace cyl::literature
