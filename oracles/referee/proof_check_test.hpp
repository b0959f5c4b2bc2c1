// SPDX-License-Identifier: MIT
// Checks a truth's certificate by exact membership and exact supports alone.
#pragma once

#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/referee/multiprecision.hpp"
#include "oracles/referee/proofs.hpp"
#include "oracles/referee/tangency.hpp"

namespace cyl {

/// Whether the point is in the core grown by the slack on all sides.
inline bool is_nearly_in(const Solid& c, const Rational3& point, const mpq_class& slack) {
  const Rational3 x = point - exact(c.center);
  if (is_half_space(c)) {
    const mpq_class beyond = dot(x, exact(c.axis));
    return beyond <= 0 || beyond * beyond <= slack * slack * dot(exact(c.axis), exact(c.axis));
  }
  if (is_box(c)) {
    const auto edges = edge_directions<mpq_class>(c.quaternion);
    for (std::size_t i = 0; i < 3; ++i)
      if (abs(dot(x, edges[i])) > mpq_class(c.edges[i]) / 2 + slack) return false;
    return true;
  }
  const Rational3 w = exact(c.axis), across = cross(x, w);
  const mpq_class ww = dot(w, w), along = dot(x, w), half = mpq_class(c.height) / 2 + slack,
                  radius = mpq_class(c.radius) + slack;
  return along * along <= half * half * ww && dot(across, across) <= radius * radius * ww;
}

/// Whether |f| <= 2^-200 size |direction|: it changes its sign if a rounding changes by as much. Not asked of
/// a half-space, whose normal is the only direction.
inline bool is_nearly_tangent(const Pair& pair, const Rational3& direction) {
  if (has_half_space(pair)) return true;
  const PrecisionScope precision(600);
  const auto wide = [](const Rational3& v) {
    return Vec3<MpInterval>{MpInterval(v.x), MpInterval(v.y), MpInterval(v.z)};
  };
  const MpInterval f = support_gap(terms_of<MpInterval>(pair.a), terms_of<MpInterval>(pair.b),
                                   wide(exact(pair.b.center) - exact(pair.a.center)), wide(direction));
  const MpInterval most = MpInterval(times_power(exact_size(pair), -200)) * norm(wide(direction));
  return !(abs(f) - most).positive();
}

/// Whether the certificate proves contact or a gap, by exact arithmetic.
inline bool is_proof(const Pair& pair, const Truth& truth) {
  const Certificate& c = truth.certificate;
  if (truth.verdict == Verdict::disjoint)
    return c.kind == CertificateKind::direction && support_gap_sign(pair, exact(c.vector)) < 0;
  if (c.kind == CertificateKind::point) return in_both_exact(pair, exact(c.vector));
  const bool near = truth.verdict == Verdict::touching && c.kind == CertificateKind::near;
  const bool near_points = truth.verdict == Verdict::touching && c.kind == CertificateKind::near_points;
  if (c.kind != CertificateKind::points && !near && !near_points) return false;
  const mpq_class slack =
      c.kind == CertificateKind::points ? mpq_class(0) : times_power(exact_size(pair), -200);
  const Rational3 x = exact(c.vector), y = near ? x : exact(near_points ? c.third : c.second),
                  between = y - x;
  const mpq_class reach = contact_distance_of(pair) + slack;
  return is_nearly_in(pair.a, x, slack) && is_nearly_in(pair.b, y, slack) &&
         dot(between, between) <= reach * reach &&
         (c.kind == CertificateKind::points || is_nearly_tangent(pair, exact(c.second)));
}

}  // namespace cyl
