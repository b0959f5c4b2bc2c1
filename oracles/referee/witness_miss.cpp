// SPDX-License-Identifier: MIT
#include "oracles/referee/witness_miss.hpp"

#include <algorithm>
#include <cmath>

#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/support.hpp"
#include "oracles/referee/multiprecision.hpp"

namespace cyl {
namespace {

using Vec = Vec3<MpFloat>;

constexpr int miss_bits = 512;

/// Returns how far a point lies beyond the caps or beyond the wall, the greater of the two, or beyond a
/// plane.
MpFloat most_beyond(const Solid& c, const Vec& point) {
  if (is_half_space(c)) {
    const Vec n = lifted<MpFloat>(c.axis);
    return dot(n, point - lifted<MpFloat>(c.center)) / norm(n);
  }
  const auto [caps, wall] = beyond(terms_of<MpFloat>(c), point - lifted<MpFloat>(c.center));
  return std::max(caps, wall);
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
  const Vec given = lifted<MpFloat>(answer.head) + lifted<MpFloat>(answer.tail);
  if (answer.witness == CertificateKind::point)
    return std::max(most_beyond(pair.a, given), most_beyond(pair.b, given)).to_double();
  if (answer.witness == CertificateKind::points && finite(answer.other_head) && finite(answer.other_tail)) {
    const Vec other = lifted<MpFloat>(answer.other_head) + lifted<MpFloat>(answer.other_tail);
    return std::max({most_beyond(pair.a, given), most_beyond(pair.b, other),
                     norm(given - other) - contact_distance})
        .to_double();
  }
  if (answer.witness != CertificateKind::direction || !(norm(given) > MpFloat(0))) return {};
  const Vec d = given / norm(given),
            between = lifted<MpFloat>(pair.b.center) - lifted<MpFloat>(pair.a.center);
  if (has_half_space(pair)) {  // the solid's own part of f; the direction should be the normal
    const Solid& solid = is_half_space(pair.a) ? pair.b : pair.a;
    return (support(terms_of<MpFloat>(solid), d) - abs(dot(d, between))).to_double();
  }
  return support_gap(terms_of<MpFloat>(pair.a), terms_of<MpFloat>(pair.b), between, d).to_double();
}

}  // namespace cyl
