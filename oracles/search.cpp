// SPDX-License-Identifier: MIT
#include "oracles/search.hpp"

#include <algorithm>

namespace cyl {

SearchPair<double> double_pair(const Pair& pair, int& exponent) {
  const Cylinder &a = pair.a, &b = pair.b;
  const Vector3 difference = b.center * 0.5 - a.center * 0.5;
  const double most =
      std::max({a.radius / 2, a.height / 2, b.radius / 2, b.height / 2, std::fabs(difference.x()),
                std::fabs(difference.y()), std::fabs(difference.z())});
  exponent = most > 0 ? std::ilogb(most) + 1 : 0;
  auto axis = [](const Vector3& w) {
    const int e = -std::ilogb(w.lpNorm<Eigen::Infinity>());
    return Vec3<double>{std::ldexp(w.x(), e), std::ldexp(w.y(), e), std::ldexp(w.z(), e)};
  };
  auto length = [&](double x) { return std::ldexp(x, -exponent); };
  auto half = [&](double x) { return std::ldexp(x, -exponent - 1); };
  auto apart = [&](int i) { return std::ldexp(difference[i], 1 - exponent); };
  return {axis(a.axis),     axis(b.axis),  {apart(0), apart(1), apart(2)}, length(a.radius), half(a.height),
          length(b.radius), half(b.height)};
}

}  // namespace cyl
