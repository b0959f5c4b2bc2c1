// SPDX-License-Identifier: MIT
#include "oracles/referee/half_space.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

#include "corpus/pairs/support.hpp"
#include "oracles/referee/certificate_check.hpp"
#include "oracles/referee/interval.hpp"
#include "oracles/referee/multiprecision.hpp"
#include "oracles/referee/proofs.hpp"
#include "oracles/referee/tangency.hpp"

namespace cyl {
namespace {

/// The two solids by what they are.
struct Sided {
  explicit Sided(const Pair& pair)
      : first(is_half_space(pair.a)), plane(first ? pair.a : pair.b), solid(first ? pair.b : pair.a) {}
  bool first;  ///< a is the half-space
  const Solid &plane, &solid;

  /// Puts what belongs to the half-space and to the solid in the order of the pair.
  template <class T>
  std::pair<T, T> in_order(T of_plane, T of_solid) const {
    if (first) return {std::move(of_plane), std::move(of_solid)};
    return {std::move(of_solid), std::move(of_plane)};
  }
};

/// Returns f in intervals or floating-point numbers.
template <class R>
R gap(const Sided& s) {
  const Vec3<R> n = lifted<R>(s.plane.axis);
  const Terms<R> terms = terms_of<R>(s.solid);
  R f = core_support(terms, n) - dot(n, lifted<R>(s.solid.center) - lifted<R>(s.plane.center));
  if (terms.rounded) f = f + terms.rounding * norm(n);
  return f;
}

RootSum exact_gap(const Sided& s) {
  const Rational3 n = exact(s.plane.axis);
  return exact_core_support(s.solid, n) + RootSum::root(mpq_class(s.solid.rounding), dot(n, n)) -
         RootSum(dot(n, exact(s.solid.center) - exact(s.plane.center)));
}

/// Returns the point of the half-space that is nearest to x.
Rational3 pulled_to(const Solid& plane, const Rational3& x) {
  const Rational3 n = exact(plane.axis);
  const mpq_class beyond = dot(n, x - exact(plane.center));
  return beyond > 0 ? x - mpq_class(beyond / dot(n, n)) * n : x;
}

/// Writes two points, in the half-space and in the core, as a certificate. One point suffices if they are the
/// same.
Certificate points_certificate(const Sided& s, const Rational3& in_plane, const Rational3& in_core) {
  Certificate c;
  const Rational3 apart = in_plane - in_core;
  if (dot(apart, apart) == 0) {
    c.kind = CertificateKind::point;
    c.vector = exact_vector(in_core);
    return c;
  }
  c.kind = CertificateKind::points;
  std::tie(c.vector, c.second) = s.in_order(exact_vector(in_plane), exact_vector(in_core));
  return c;
}

/// Returns the certificate if the core's point shows contact with the half-space.
std::optional<Certificate> contact_at(const Sided& s, const Rational3& in_core) {
  if (!in_each_exact({s.solid, s.solid}, in_core, in_core)) return {};
  const Rational3 in_plane = pulled_to(s.plane, in_core), apart = in_plane - in_core;
  const mpq_class rounding(s.solid.rounding);
  if (dot(apart, apart) > rounding * rounding) return {};
  return points_certificate(s, in_plane, in_core);
}

/// The deepest point of the core, from its centre, in so many bits.
Rational3 deepest(const Sided& s, int bits) {
  const PrecisionScope precision(bits);
  return rational(farthest(terms_of<MpFloat>(s.solid), MpFloat(-1.0) * lifted<MpFloat>(s.plane.axis)));
}

std::optional<Certificate> overlap_certificate(const Sided& s) {
  const Rational3 center = exact(s.solid.center);
  for (int bits = first_multiprecision_bits; bits <= precision_cap; bits *= 2) {
    const Rational3 offset = deepest(s, bits);
    // Rounding to double moves the point out by less than it is pulled in.
    if (bits == first_multiprecision_bits) {
      constexpr double pulled_in = 1 - 0x1p-45;
      const double tail[3] = {pulled_in * offset.x.get_d(), pulled_in * offset.y.get_d(),
                              pulled_in * offset.z.get_d()};
      const double head[3] = {s.solid.center.x(), s.solid.center.y(), s.solid.center.z()};
      if (const auto c = finite(tail) ? contact_at(s, sum(head, tail)) : std::nullopt) {
        Certificate written = *c;
        const bool core_is_first = c->kind == CertificateKind::point || !s.first;
        (core_is_first ? written.vector : written.second) = exact_vector(head, tail);
        return written;
      }
    }
    const mpq_class share = 1 - times_power(1, -bits / 2);  // a thin core needs more than the last bits
    if (auto c = contact_at(s, project_to_hull(s.solid, center + share * offset))) return c;
  }
  return {};
}

Certificate touching_certificate(const Sided& s, const Vector3& direction) {
  const Rational3 n = exact(s.plane.axis);
  if (const auto x = farthest_point(s.solid, mpq_class(-1) * n))
    if (const auto c = contact_at(s, *x)) return *c;
  const Rational3 near = exact(s.solid.center) + deepest(s, near_bits);
  Certificate c;
  c.kind = s.solid.rounding > 0 ? CertificateKind::near_points : CertificateKind::near;
  c.second = exact_vector(exact(direction));
  c.vector = exact_vector(near);
  if (s.solid.rounding > 0)
    std::tie(c.vector, c.third) = s.in_order(exact_vector(pulled_to(s.plane, near)), exact_vector(near));
  return c;
}

}  // namespace

int half_space_sign(const Pair& pair) {
  const Sided s(pair);
  if (const Interval f = gap<Interval>(s); f.lo > 0 || f.hi < 0) return f.lo > 0 ? 1 : -1;
  return exact_gap(s).sign();
}

Vector3 direction_of_half_space(const Pair& pair) {
  const Sided s(pair);
  return s.first ? s.plane.axis : Vector3(-s.plane.axis);
}

Truth judge_half_space(const Pair& pair) {
  const Sided s(pair);
  const Vector3 d = direction_of_half_space(pair);
  const int sign = half_space_sign(pair);
  const double head[3] = {d.x(), d.y(), d.z()};
  if (sign < 0) return proved(Verdict::disjoint, exact_vector(head, no_tail), Stage::exact, 53);
  Truth t = proved(sign > 0 ? Verdict::intersecting : Verdict::touching, {}, Stage::exact, 53);
  t.certificate = sign > 0 ? overlap_certificate(s).value_or(Certificate{}) : touching_certificate(s, d);
  return t;
}

// Bits are added until at most one double lies between both ends. The sign of f there decides on which side
// of it the distance is.
AttainedDistance attain_half_space(const Pair& pair) {
  const Sided s(pair);
  const Vector3 n = direction_of_half_space(pair), unit = n.stableNormalized();
  AttainedDistance found{{0, 0}, {unit.x(), unit.y(), unit.z()}, 0};
  if (half_space_sign(pair) == 0) return found;
  for (int bits = first_multiprecision_bits; bits <= precision_cap; bits *= 2) {
    const PrecisionScope precision(bits);
    const MpInterval distance =
        MpInterval(-1.0) * gap<MpInterval>(s) / norm(lifted<MpInterval>(s.plane.axis));
    found.distance = {distance.lower(), distance.upper()};
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double between = std::nextafter(found.distance.lo, infinity);
    if (found.distance.hi > std::nextafter(between, infinity)) continue;
    if (found.distance.hi <= between) break;
    const Rational3 normal = exact(s.plane.axis);
    const int sign = (exact_gap(s) + RootSum::root(mpq_class(between), dot(normal, normal))).sign();
    if (sign >= 0) found.distance.hi = between;
    if (sign <= 0) found.distance.lo = between;
    break;
  }
  return found;
}

MeasuredDistance measure_half_space(const Pair& pair) {
  const Sided s(pair);
  const PrecisionScope precision(first_multiprecision_bits);
  const auto in_doubles = [](const Vec3<MpFloat>& v) {
    return Vector3(v.x.to_double(), v.y.to_double(), v.z.to_double());
  };
  const Vec3<MpFloat> n = lifted<MpFloat>(s.plane.axis), u = n / norm(n);
  const MpFloat distance = MpFloat(-1) * gap<MpFloat>(s) / norm(n), rounding = s.solid.rounding;
  const Vec3<MpFloat> on_solid = farthest(terms_of<MpFloat>(s.solid), MpFloat(-1) * u) - rounding * u,
                      on_plane = lifted<MpFloat>(s.solid.center) - lifted<MpFloat>(s.plane.center) +
                                 on_solid - distance * u;
  const auto [on_a, on_b] = s.in_order(in_doubles(on_plane), in_doubles(on_solid));
  constexpr double largest = std::numeric_limits<double>::max();
  return {std::clamp(distance.to_double(), -largest, largest), in_doubles(MpFloat(s.first ? 1 : -1) * u),
          on_a, on_b};
}

}  // namespace cyl
