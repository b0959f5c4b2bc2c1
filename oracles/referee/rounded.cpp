// SPDX-License-Identifier: MIT
#include "oracles/referee/rounded.hpp"

#include <cmath>
#include <numbers>

#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/referee/nearest.hpp"
#include "oracles/referee/proofs.hpp"
#include "oracles/referee/referee.hpp"
#include "oracles/referee/tangency.hpp"

namespace cyl {
namespace {

Truth met_at(ExactVector on_a, ExactVector on_b, Stage stage, int bits) {
  Truth t = proved(Verdict::intersecting, std::move(on_a), stage, bits);
  t.certificate.kind = CertificateKind::points;
  t.certificate.second = std::move(on_b);
  return t;
}

/// Compares the distance between a point of each core with the contact distance.
int compare_with_contact(const Pair& pair, const Rational3& on_a, const Rational3& on_b) {
  const Rational3 between = on_b - on_a;
  const mpq_class contact_distance = contact_distance_of(pair);
  return cmp(mpq_class(dot(between, between)), mpq_class(contact_distance * contact_distance));
}

/// Returns a rational above the square root of a positive one, by less than 2^-digits of the root.
mpq_class root_above(const mpq_class& square, int digits) {
  const auto size = [](const mpz_class& n) { return static_cast<int>(mpz_sizeinbase(n.get_mpz_t(), 2)); };
  const int half = digits + 1 + (size(square.get_den()) - size(square.get_num())) / 2;
  const mpq_class scaled = times_power(square, 2 * half);
  const mpz_class root = sqrt(mpz_class(scaled.get_num() / scaled.get_den())) + 1;
  return times_power(mpq_class(root), -half);
}

/// Moves the found point into the core. It moves into the hull exactly. Then it moves inward, if needed,
/// until its distances from the caps and the wall are 2^-digits of the half height and of the radius.
Rational3 pulled_in(const Solid& c, const Rational3& found, int digits) {
  const Rational3 center = exact(c.center), w = exact(c.axis), x = project_to_hull(c, found) - center;
  const mpq_class share = 1 - times_power(1, -digits), ww = dot(w, w);
  if (is_box(c)) {
    const auto edges = edge_directions<mpq_class>(c.quaternion);
    Rational3 in = center;
    for (std::size_t i = 0; i < 3; ++i) {
      const mpq_class most = share * mpq_class(c.edges[i]) / 2, along = dot(x, edges[i]);
      in = in + mpq_class(along > most ? most : along < -most ? mpq_class(-most) : along) * edges[i];
    }
    return in;
  }
  mpq_class along = dot(x, w) / ww;
  Rational3 across = x - along * w;
  const auto part = [&](const mpq_class& square, const mpq_class& most) {
    const mpq_class kept = share * most;
    return square > kept * kept ? mpq_class(kept / root_above(square, digits)) : mpq_class(1);
  };
  along *= part(along * along * ww, mpq_class(c.height) / 2);
  across = part(dot(across, across), mpq_class(c.radius)) * across;
  return center + along * w + across;
}

/// Writes the point as the centre plus a double. The caller checks that the result is still in the core.
std::optional<ExactVector> written_short(const Solid& c, const Rational3& point) {
  const double head[3] = {c.center.x(), c.center.y(), c.center.z()};
  const Rational3 from_center = point - exact(c.center);
  const double tail[3] = {from_center.x.get_d(), from_center.y.get_d(), from_center.z.get_d()};
  if (!finite(tail)) return {};
  return exact_vector(head, tail);
}

/// The nearest points that double finds, in a unit of 2^exponent.
struct DoublePoints {
  Nearest<double> found;
  int exponent = 0;

  Vec3<MpFloat> lifted(const Vec3<double>& v) const {
    const int half = exponent / 2;  // 2^exponent itself may not be a double
    const MpFloat unit = MpFloat(std::ldexp(1.0, half)) * MpFloat(std::ldexp(1.0, exponent - half));
    return unit * Vec3<MpFloat>{MpFloat(v.x), MpFloat(v.y), MpFloat(v.z)};
  }
  Rational3 exactly(const Vec3<double>& v) const {
    const auto c = [&](double x) { return times_power(mpq_class(x), exponent); };
    return {c(v.x), c(v.y), c(v.z)};
  }
};

DoublePoints nearest_in_double(const Pair& pair) {
  DoublePoints r;
  const SearchPair<double> p = double_pair(pair, r.exponent);
  r.found = find_nearest(p, 53, 0.5 * p.delta);
  return r;
}

/// Returns the best result of starts all round the rims. Two faces at a tiny angle are nearest at a corner
/// of the part that one hides of the other. That corner is on a rim, and other starts need not lead there.
DoublePoints nearest_from_rims(const Pair& pair) {
  DoublePoints r = nearest_in_double(pair);
  const SearchPair<double> p = double_pair(pair, r.exponent);
  const auto look_round = [&](const Vec3<double>& center, const Vec3<double>& axis, double radius,
                              double half) {
    constexpr int starts = 16;
    const Vec3<double> w = axis / std::sqrt(dot(axis, axis));
    const Vec3<double> other{std::abs(w.x) < 0.6 ? 1.0 : 0.0, std::abs(w.x) < 0.6 ? 0.0 : 1.0, 0.0};
    Vec3<double> u = cross(w, other);
    u = u / std::sqrt(dot(u, u));
    const Vec3<double> v = cross(w, u);
    for (int i = 0; i < 2 * starts; ++i) {
      const double turn = i * std::numbers::pi / (starts / 2), end = i < starts ? half : -half;
      const Nearest<double> found = find_nearest(
          p, 53, center + end * w + (radius * std::cos(turn)) * u + (radius * std::sin(turn)) * v);
      if (found.apart < r.found.apart) r.found = found;
    }
  };
  look_round({0, 0, 0}, p.axis0, p.radius0, p.half0);
  look_round(p.delta, p.axis1, p.radius1, p.half1);
  return r;
}

/// The starts of the search for the nearest points, in the order in which they are tried. A start may lead
/// astray if the axes are nearly parallel.
enum class Start : unsigned char { double_points, corners, rims, middle };

Nearest<MpFloat> nearest_in_multiprecision(const Pair& pair, int bits, Start start) {
  const PrecisionScope precision(bits);
  const SearchPair<MpFloat> p = multiprecision_pair(pair);
  switch (start) {
    case Start::double_points: {
      const DoublePoints guess = nearest_in_double(pair);
      return refine_nearest(p, bits, guess.lifted(guess.found.on_a), guess.lifted(guess.found.on_b));
    }
    // At tiny angles the faces overlap in a sliver that only this start reaches.
    case Start::corners: {
      DoublePoints unit;
      const std::array<Vec3<double>, 4> corners = crossings_of_rims(double_pair(pair, unit.exponent));
      std::optional<Nearest<MpFloat>> best;
      for (const Vec3<double>& corner : corners) {
        const Vec3<MpFloat> start = unit.lifted(corner);
        Nearest<MpFloat> found = refine_nearest(p, bits, start, start);
        for (int round = 1; round < 4; ++round) found = refine_nearest(p, bits, found.on_a, found.on_b);
        if (!best || found.apart < best->apart) best = std::move(found);
      }
      return *best;
    }
    case Start::rims: {
      const DoublePoints guess = nearest_from_rims(pair);
      return find_nearest(p, bits, guess.lifted(guess.found.on_b));
    }
    case Start::middle:
      break;
  }
  return find_nearest(p, bits, MpFloat(0.5) * p.delta);
}

/// Returns whether the point is in the core grown by the slack on all sides.
bool is_nearly_in(const Solid& c, const Rational3& point, const mpq_class& slack) {
  const Rational3 x = point - exact(c.center), w = exact(c.axis), across = cross(x, w);
  const mpq_class ww = dot(w, w), along = dot(x, w), half = mpq_class(c.height) / 2 + slack,
                  radius = mpq_class(c.radius) + slack;
  return along * along <= half * half * ww && dot(across, across) <= radius * radius * ww;
}

/// Returns the points of a search with enough bits for 2^-200 of the size, if it came that near.
std::optional<Certificate> near_points(const Pair& pair, const Rational3& direction) {
  const mpq_class slack = times_power(exact_size(pair), -200),
                  contact_distance = contact_distance_of(pair) + slack;
  for (const Start start : {Start::double_points, Start::middle}) {
    const Nearest<MpFloat> found = nearest_in_multiprecision(pair, near_bits, start);
    const Rational3 center = exact(pair.a.center), on_a = center + rational(found.on_a),
                    on_b = center + rational(found.on_b), between = on_b - on_a;
    if (!is_nearly_in(pair.a, on_a, slack) || !is_nearly_in(pair.b, on_b, slack) ||
        dot(between, between) > contact_distance * contact_distance)
      continue;
    Certificate near{CertificateKind::near_points, exact_vector(on_a), exact_vector(direction)};
    near.third = exact_vector(on_b);
    return near;
  }
  return {};
}

// Near a contact of faces the search approaches only slowly, so simpler rationals are tried too.
std::optional<Truth> prove_rounded_touching(const Pair& pair, const Rational3& on_a, const Rational3& on_b,
                                            int bits) {
  // If the solids are far from touching, it is not worth trying.
  const Rational3 between = on_b - on_a;
  const mpq_class size = exact_size(pair), contact_distance = contact_distance_of(pair);
  if (abs(mpq_class(dot(between, between) - contact_distance * contact_distance)) >
      times_power(size * size, -12))
    return {};
  const auto touching_at = [&](const Rational3& x, const Rational3& y) {
    Truth t = proved(Verdict::touching, exact_vector(x), Stage::exact, bits);
    t.certificate.kind = CertificateKind::points;
    t.certificate.second = exact_vector(y);
    return t;
  };
  std::optional<Tangency> tangency;
  for (const int guessed : {bits, bits / 4, bits / 8}) {
    const Rational3 simple_a = simplest_near(pair, on_a, guessed),
                    simple_b = simplest_near(pair, on_b, guessed);
    if (!tangency) tangency = prove_tangency(pair, simple_a, simple_b, simple_b - simple_a);
    if (!tangency) continue;
    if (!tangency->meet) return prove_disjoint(pair, tangency->direction, bits);
    if (!in_each_exact(pair, simple_a, simple_b) || compare_with_contact(pair, simple_a, simple_b) != 0)
      continue;
    return touching_at(simple_a, simple_b);
  }
  if (!tangency) return {};
  if (const auto contact = contact_points(pair, tangency->direction))
    return touching_at(contact->first, contact->second);
  auto near = near_points(pair, tangency->direction);
  if (!near) return {};
  Truth t = proved(Verdict::touching, {}, Stage::exact, bits);
  t.certificate = std::move(*near);
  return t;
}

/// Returns the points of a and of b, each in its hull.
std::pair<Rational3, Rational3> points_of(const Pair& pair, const MethodAnswer& answer) {
  return {project_to_hull(pair.a, sum(answer.head, answer.tail), answer.hulls[0]),
          project_to_hull(pair.b, sum(answer.other_head, answer.other_tail), answer.hulls[1])};
}

}  // namespace

std::optional<Truth> meet_at(const Pair& pair, const Rational3& on_a, const Rational3& on_b, int bits) {
  const auto shown = [&](const Rational3& x, const Rational3& y) {
    return in_each_exact(pair, x, y) && compare_with_contact(pair, x, y) < 0;
  };
  constexpr int double_digits = 50;  // moves a point farther than rounding to double does
  const auto short_a = written_short(pair.a, pulled_in(pair.a, on_a, double_digits));
  const auto short_b = written_short(pair.b, pulled_in(pair.b, on_b, double_digits));
  if (short_a && short_b && shown(exact(*short_a), exact(*short_b)))
    return met_at(*short_a, *short_b, Stage::exact, bits);
  const int digits = bits - bits / 8;
  const Rational3 x = pulled_in(pair.a, on_a, digits), y = pulled_in(pair.b, on_b, digits);
  if (shown(x, y)) return met_at(exact_vector(x), exact_vector(y), Stage::exact, bits);
  return {};
}

std::optional<Truth> check_points_by_filter(const Filter& filter, const MethodAnswer& answer) {
  const Certificate said = answer.certificate();
  if (said.hulls != Certificate{}.hulls || !filter.come_near(said.vector, said.second, said.hulls)) return {};
  return met_at(exact_vector(answer.head, answer.tail), exact_vector(answer.other_head, answer.other_tail),
                Stage::filter, 53);
}

bool points_show_contact(const Pair& pair, const MethodAnswer& answer) {
  const auto [on_a, on_b] = points_of(pair, answer);
  return in_each_exact(pair, on_a, on_b) && compare_with_contact(pair, on_a, on_b) <= 0;
}

std::optional<Truth> check_points_exactly(const Pair& pair, const MethodAnswer& answer) {
  const auto [on_a, on_b] = points_of(pair, answer);
  if (!in_each_exact(pair, on_a, on_b) || compare_with_contact(pair, on_a, on_b) >= 0) return {};
  return met_at(exact_vector(on_a), exact_vector(on_b), Stage::exact, first_multiprecision_bits);
}

std::optional<Truth> meet_by_filter(const Pair& pair, const Filter& filter, const Vec3<double>& from_a,
                                    const Vec3<double>& from_b, int exponent) {
  constexpr double inward = 1 - 0x1p-45;  // moves a point farther in than rounding carries it out
  const auto point = [&](const Solid& c, const Vec3<double>& from_center) {
    const auto in_scene = [&](double x) { return std::ldexp(inward * x, exponent); };
    return ExactVector{{c.center.x(), c.center.y(), c.center.z()},
                       {in_scene(from_center.x), in_scene(from_center.y), in_scene(from_center.z)},
                       {}};
  };
  const ExactVector on_a = point(pair.a, from_a), on_b = point(pair.b, from_b);
  if (!filter.come_near(on_a, on_b, {})) return {};
  // For flat solids, the points meant are the nearest ones of their planes and lines.
  const auto written = [](const Solid& c, const ExactVector& v) {
    if (own_hull(c) == Hull::space) return exact_vector(v.head.data(), v.tail.data());
    return exact_vector(project_to_hull(c, exact(v)));
  };
  return met_at(written(pair.a, on_a), written(pair.b, on_b), Stage::filter, 53);
}

std::optional<Truth> prove_rounded_in_double(const Pair& pair, const Filter& filter, Guess& guess) {
  int& exponent = guess.exponent;
  const SearchPair<double> p = double_pair(pair, exponent);
  // For most pairs, a direction that separates the cores or a common point of the cores decides.
  const Found<double>& of_cores = guess.found = search(p, 53);
  const double apart[3] = {of_cores.direction.x, of_cores.direction.y, of_cores.direction.z};
  if (of_cores.has_direction && filter.separates(apart))
    return proved(Verdict::disjoint, exact_vector(apart, no_tail), Stage::filter, 53);
  if (of_cores.has_point) {
    const double head[3] = {pair.a.center.x(), pair.a.center.y(), pair.a.center.z()};
    const auto in_scene = [&](double x) { return std::ldexp(x, exponent); };
    const double tail[3] = {in_scene(of_cores.point.x), in_scene(of_cores.point.y),
                            in_scene(of_cores.point.z)};
    if (filter.in_both(head, tail))
      return proved(Verdict::intersecting, exact_vector(head, tail), Stage::filter, 53);
  }
  const Nearest<double> found = find_nearest(p, 53, 0.5 * p.delta);
  guess.on_a = found.on_a;
  guess.on_b = found.on_b;
  const Vec3<double> between = found.on_b - found.on_a;
  const double direction[3] = {between.x, between.y, between.z};
  if (filter.separates(direction))
    return proved(Verdict::disjoint, exact_vector(direction, no_tail), Stage::filter, 53);
  return meet_by_filter(pair, filter, found.on_a, found.on_b - p.delta, exponent);
}

std::optional<Truth> prove_rounded_at_once(const Pair& pair) {
  const DoublePoints guess = nearest_in_double(pair);
  const Rational3 center = exact(pair.a.center);
  if (!std::isfinite(guess.found.apart)) return {};
  return prove_rounded_touching(pair, center + guess.exactly(guess.found.on_a),
                                center + guess.exactly(guess.found.on_b), first_multiprecision_bits);
}

std::optional<Truth> prove_cores_meet(const Pair& pair, const Rational3& point, int bits) {
  for (const int guessed : {bits, bits / 4, bits / 8})
    if (const Rational3 simple = simplest_near(pair, point, guessed); in_both_exact(pair, simple))
      return proved(Verdict::intersecting, exact_vector(simple), Stage::exact, bits);
  return meet_at(pair, point, point, bits);
}

std::optional<Truth> prove_rounded(const Pair& pair, int bits) {
  const Rational3 center = exact(pair.a.center);
  for (const Start start : {Start::double_points, Start::corners, Start::rims, Start::middle}) {
    const Nearest<MpFloat> found = nearest_in_multiprecision(pair, bits, start);
    const Rational3 from_a = rational(found.on_a), from_b = rational(found.on_b);
    const Rational3 on_a = center + from_a, on_b = center + from_b, between = from_b - from_a;
    if (between.x != 0 || between.y != 0 || between.z != 0)
      if (auto t = prove_disjoint(pair, between, bits)) return t;
    if (auto t = meet_at(pair, on_a, on_b, bits)) return t;
    // Algebra has already tried the points that double found.
    const bool seen = start == Start::double_points && bits == first_multiprecision_bits;
    if (seen || bits > tangency_bits) continue;
    if (auto t = prove_rounded_touching(pair, on_a, on_b, bits)) return t;
  }
  return {};
}

}  // namespace cyl
