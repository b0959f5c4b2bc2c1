// SPDX-License-Identifier: MIT
#include "oracles/referee/witness_miss.hpp"

#include <algorithm>
#include <cmath>

#include "oracles/referee/multiprecision.hpp"
#include "oracles/referee/vec3.hpp"

namespace cyl {
namespace {

using Vec = Vec3<MpFloat>;

constexpr int miss_bits = 512;

template <class V>
Vec lifted(const V& v) {
  return {MpFloat(v[0]), MpFloat(v[1]), MpFloat(v[2])};
}

MpFloat length(const Vec& v) { return sqrt(dot(v, v)); }

Vec unit_axis_of(const Cylinder& c) {
  const Vec w = lifted(c.axis);
  return w / length(w);
}

/// Half the width of a solid along a direction of length 1.
MpFloat half_width(const Cylinder& c, const Vec& d) {
  const Vec w = unit_axis_of(c);
  return MpFloat(c.radius) * length(cross(d, w)) + MpFloat(c.height) / MpFloat(2) * abs(dot(d, w));
}

/// Returns how far a point lies beyond the caps or beyond the wall, the greater of the two.
MpFloat beyond(const Cylinder& c, const Vec& point) {
  const Vec x = point - lifted(c.center), w = unit_axis_of(c);
  return std::max(abs(dot(x, w)) - MpFloat(c.height) / MpFloat(2), length(cross(x, w)) - MpFloat(c.radius));
}

}  // namespace

std::optional<double> witness_miss(const Pair& pair, const MethodAnswer& answer) {
  const bool plain = answer.hulls[0] == Hull::space && answer.hulls[1] == Hull::space;
  const auto finite = [](const double(&v)[3]) {
    return std::all_of(v, v + 3, [](double x) { return std::isfinite(x); });
  };
  if (!plain || !finite(answer.head) || !finite(answer.tail)) return {};
  const PrecisionScope precision(miss_bits);
  const MpFloat contact_distance = MpFloat(pair.a.rounding) + MpFloat(pair.b.rounding);
  const Vec given = lifted(answer.head) + lifted(answer.tail);
  if (answer.witness == CertificateKind::point)
    return std::max(beyond(pair.a, given), beyond(pair.b, given)).to_double();
  if (answer.witness == CertificateKind::points && finite(answer.other_head) && finite(answer.other_tail)) {
    const Vec other = lifted(answer.other_head) + lifted(answer.other_tail);
    return std::max({beyond(pair.a, given), beyond(pair.b, other), length(given - other) - contact_distance})
        .to_double();
  }
  if (answer.witness != CertificateKind::direction || !(length(given) > MpFloat(0))) return {};
  const Vec d = given / length(given), between = lifted(pair.b.center) - lifted(pair.a.center);
  return (half_width(pair.a, d) + half_width(pair.b, d) + contact_distance - abs(dot(d, between)))
      .to_double();
}

}  // namespace cyl
