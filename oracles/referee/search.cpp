// SPDX-License-Identifier: MIT
#include "oracles/referee/search.hpp"

#include <algorithm>
#include <cmath>

#include "oracles/referee/direction_bounds.hpp"

namespace cyl {

SearchPair<double> double_pair(const Pair& pair, int& exponent) {
  const Solid &a = pair.a, &b = pair.b;
  auto max_abs = [](const Vector3& v) { return v.lpNorm<Eigen::Infinity>(); };
  // Subnormal pairs are scaled up before any rounding. Centres are halved if their difference overflows.
  double most = std::max({a.radius, a.height, b.radius, b.height, max_abs(a.center), max_abs(b.center)});
  const int lift = most < 0x1p-900 ? 200 : 0;
  auto lifted = [&](const Vector3& v) {
    return Vector3(std::ldexp(v.x(), lift), std::ldexp(v.y(), lift), std::ldexp(v.z(), lift));
  };
  Vector3 difference = lifted(b.center) - lifted(a.center);
  int halvings = 0;
  if (!difference.allFinite()) {
    halvings = 1;
    difference = b.center * 0.5 - a.center * 0.5;
  }
  most = std::max(
      {std::ldexp(std::max({a.radius, a.height, b.radius, b.height}), lift - halvings), max_abs(difference)});
  const int above = most > 0 ? std::ilogb(most) : 0;
  exponent = above - lift + halvings;
  auto axis = [&](const Vector3& w) {
    const int e = -std::ilogb(max_abs(w));
    return Vec3<double>{std::ldexp(w.x(), e), std::ldexp(w.y(), e), std::ldexp(w.z(), e)};
  };
  auto length = [&](double x) { return std::ldexp(x, -exponent); };
  auto apart = [&](int i) { return std::ldexp(difference[i], -above); };
  return {axis(a.axis),        axis(b.axis),         {apart(0), apart(1), apart(2)},
          length(a.radius),    length(a.height) / 2, length(b.radius),
          length(b.height) / 2};
}

std::array<Vec, 4> crossings_of_rims(const SearchPair<double>& p) {
  const Vec w = normalized(p.axis0), flat = p.delta - dot(p.delta, w) * w;
  const double far = length(flat);
  const Vec out = far > 0 ? normalized(flat) : square_to(w);
  const double most = p.radius0,
               x = far > 0 ? std::clamp((far * far + most * most - p.radius1 * p.radius1) / (2 * far), -most,
                                        most)
                           : most;
  const Vec along = p.half0 * w, beside = std::sqrt((most - x) * (most + x)) * cross(w, out),
            middle = x * out;
  return {middle + along + beside, middle + along - beside, middle - along + beside, middle - along - beside};
}

}  // namespace cyl
