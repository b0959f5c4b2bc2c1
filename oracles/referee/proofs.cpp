// SPDX-License-Identifier: MIT
#include "oracles/referee/proofs.hpp"

#include <cstdlib>
#include <string>

#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/referee/tangency.hpp"

namespace cyl {

ExactVector exact_vector(const Rational3& v) {
  ExactVector r;
  const mpq_class* c[3] = {&v.x, &v.y, &v.z};
  for (std::size_t i = 0; i < 3; ++i) {
    const double head = c[i]->get_d();
    if (std::isfinite(head) && mpq_class(head) == *c[i])
      r.head[i] = head;
    else
      r.exact[i] = c[i]->get_str();
  }
  return r;
}

ExactVector exact_vector(const double head[3], const double tail[3]) {
  ExactVector r;
  for (std::size_t i = 0; i < 3; ++i) {
    r.head[i] = head[i] == 0 ? tail[i] : head[i];
    r.tail[i] = head[i] == 0 ? 0 : tail[i];
  }
  return r;
}

Truth proved(Verdict verdict, ExactVector certificate, Stage stage, int bits) {
  Truth t;
  t.verdict = verdict;
  t.certificate.kind = verdict == Verdict::disjoint ? CertificateKind::direction : CertificateKind::point;
  t.certificate.vector = std::move(certificate);
  t.stage = stage;
  t.bits = bits;
  return t;
}

bool finite(const double v[3]) {
  return std::all_of(v, v + 3, [](double x) { return std::isfinite(x); });
}

Rational3 sum(const double head[3], const double tail[3]) {
  auto c = [&](int i) { return mpq_class(mpq_class(head[i]) + mpq_class(tail[i])); };
  return {c(0), c(1), c(2)};
}

SearchPair<MpFloat> multiprecision_pair(const Pair& pair) {
  auto lift = [](const Vector3& v) { return Vec3<MpFloat>{MpFloat(v.x()), MpFloat(v.y()), MpFloat(v.z())}; };
  const MpFloat half(0.5);
  return {lift(pair.a.axis),
          lift(pair.b.axis),
          lift(pair.b.center) - lift(pair.a.center),
          MpFloat(pair.a.radius),
          MpFloat(pair.a.height) * half,
          MpFloat(pair.b.radius),
          MpFloat(pair.b.height) * half};
}

Rational3 rational(const Vec3<MpFloat>& v) {
  return {v.x.to_rational(), v.y.to_rational(), v.z.to_rational()};
}

namespace {

// Divides the direction by its greatest coordinate, then rounds it to double.
std::optional<std::array<double, 3>> rounded_direction(const Rational3& d) {
  const mpq_class most = std::max({mpq_class(abs(d.x)), mpq_class(abs(d.y)), mpq_class(abs(d.z))});
  if (most == 0) return std::nullopt;
  const mpq_class x = d.x / most, y = d.y / most, z = d.z / most;
  return std::array<double, 3>{x.get_d(), y.get_d(), z.get_d()};
}

}  // namespace

std::optional<Truth> prove_disjoint(const Pair& pair, const Rational3& direction, int bits) {
  const auto rounded = rounded_direction(direction);
  if (!rounded) return std::nullopt;
  const Rational3 simple = sum(rounded->data(), no_tail);
  if (separates_in_multiprecision(pair, simple, bits))
    return proved(Verdict::disjoint, exact_vector(simple), Stage::multiprecision, bits);
  if (separates_in_multiprecision(pair, direction, 2 * bits))
    return proved(Verdict::disjoint, exact_vector(direction), Stage::multiprecision, 2 * bits);
  return std::nullopt;
}

std::optional<CommonPoint> common_point(const Pair& pair, const Rational3& guess) {
  const Rational3 a = exact(pair.a.center);
  const double head[3] = {pair.a.center.x(), pair.a.center.y(), pair.a.center.z()};
  const double tail[3] = {mpq_class(guess.x - a.x).get_d(), mpq_class(guess.y - a.y).get_d(),
                          mpq_class(guess.z - a.z).get_d()};
  if (finite(tail)) {
    const Rational3 rounded = sum(head, tail);
    if (in_both_exact(pair, rounded)) return CommonPoint{rounded, exact_vector(head, tail)};
  }
  const auto moved = project_to_hulls(pair, guess);
  if (moved && in_both_exact(pair, *moved)) return CommonPoint{*moved, exact_vector(*moved)};
  return std::nullopt;
}

mpq_class exact_size(const Pair& pair) {
  mpq_class size = contact_distance_of(pair);
  for (const Solid* c : {&pair.a, &pair.b})
    for (const double x : {c->radius, c->height, c->edges[0], c->edges[1], c->edges[2]}) size += x;
  return size;
}

mpq_class times_power(mpq_class x, int exponent) {
  if (exponent < 0)
    mpq_div_2exp(x.get_mpq_t(), x.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
  else
    mpq_mul_2exp(x.get_mpq_t(), x.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
  return x;
}

// Uses a unit near the size, so that a scaled scene has the same guess.
Rational3 simplest_near(const Pair& pair, const Rational3& point, int bits) {
  const mpq_class size = exact_size(pair);
  const int unit = size > 0 ? std::ilogb(size_of(pair)) : 0;
  const mpq_class tolerance = times_power(size, -unit - bits / 4);
  const auto simple = [&](const mpq_class& x) {
    return times_power(simplest_within(times_power(x, -unit), tolerance), unit);
  };
  return {simple(point.x), simple(point.y), simple(point.z)};
}

Rational3 short_near(const Pair& pair, const Rational3& point, int digits) {
  const double size = size_of(pair);
  const int places = digits - (size > 0 ? static_cast<int>(std::floor(std::log10(size))) + 1 : 0);
  mpz_class ten;
  mpz_ui_pow_ui(ten.get_mpz_t(), 10, static_cast<unsigned long>(std::abs(places)));
  const auto rounded = [&](const mpq_class& x) {
    const mpq_class scaled = (places < 0 ? mpq_class(x / ten) : mpq_class(x * ten)) + mpq_class(1, 2);
    mpz_class whole;
    mpz_fdiv_q(whole.get_mpz_t(), scaled.get_num_mpz_t(), scaled.get_den_mpz_t());
    const double near = std::strtod((whole.get_str() + "e" + std::to_string(-places)).c_str(), nullptr);
    return std::isfinite(near) ? mpq_class(near) : x;
  };
  return {rounded(point.x), rounded(point.y), rounded(point.z)};
}

}  // namespace cyl
