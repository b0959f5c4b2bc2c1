// SPDX-License-Identifier: MIT
#include "oracles/referee/referee.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/referee/box.hpp"
#include "oracles/referee/certificate_check.hpp"
#include "oracles/referee/half_space.hpp"
#include "oracles/referee/multiprecision.hpp"
#include "oracles/referee/nearest.hpp"
#include "oracles/referee/proofs.hpp"
#include "oracles/referee/rounded.hpp"
#include "oracles/referee/search.hpp"
#include "oracles/referee/tangency.hpp"

namespace cyl {
namespace {

Hulls hulls_of(const MethodAnswer& answer) { return {answer.hulls[0], answer.hulls[1]}; }

bool in_space(const MethodAnswer& answer) { return hulls_of(answer) == Hulls{}; }

// Returns the offered point, which is finite. Returns nothing if its hulls have no common point.
std::optional<Rational3> offered_point(const Pair& pair, const MethodAnswer& answer) {
  const Rational3 given = sum(answer.head, answer.tail);
  if (in_space(answer)) return given;
  return project_to_hulls(pair, given, hulls_of(answer));
}

Truth verdict_alone(Verdict verdict) {
  Truth t;
  t.verdict = verdict;
  return t;
}

enum class Certificates : bool { left_out, written };

// not covered within: our answers are finite, but those of other methods may not be
bool is_usable(const MethodAnswer& answer) {
  return answer.status == Status::answered && finite(answer.head) && finite(answer.tail) &&
         finite(answer.other_head) && finite(answer.other_tail);
}

template <class I>
std::optional<Truth> check_by_filter(const Pair& pair, const BasicFilter<I>& filter,
                                     const MethodAnswer& answer, Certificates certificates) {
  if (!is_usable(answer)) return std::nullopt;
  if (answer.witness == CertificateKind::direction && filter.separates(answer.head))
    return proved(Verdict::disjoint, exact_vector(answer.head, no_tail), Stage::filter, 53);
  if constexpr (std::is_same_v<I, Interval>)
    if (answer.witness == CertificateKind::points && certificates == Certificates::written)
      return check_points_by_filter(filter, answer);
  if (answer.witness == CertificateKind::points) {
    const Certificate said = answer.certificate();
    if (!filter.come_near(said.vector, said.second, said.hulls)) return std::nullopt;
    return verdict_alone(Verdict::intersecting);
  }
  if (answer.witness != CertificateKind::point) return std::nullopt;
  if (in_space(answer)) {
    if (!filter.in_both(answer.head, answer.tail)) return std::nullopt;
    return proved(Verdict::intersecting, exact_vector(answer.head, answer.tail), Stage::filter, 53);
  }
  if (!filter.overlap_at(answer.head, answer.tail, hulls_of(answer))) return std::nullopt;
  if (certificates == Certificates::left_out) return verdict_alone(Verdict::intersecting);
  const auto point = offered_point(pair, answer);
  if (!point) return std::nullopt;  // not covered: the filter saw the hulls meet
  return proved(Verdict::intersecting, exact_vector(*point), Stage::filter, 53);
}

// A point on both surfaces proves that the solids meet, not that they overlap: it is left to the search.
std::optional<Truth> check_exactly(const Pair& pair, const MethodAnswer& answer) {
  if (!is_usable(answer)) return std::nullopt;
  if (answer.witness == CertificateKind::direction &&
      separates_in_multiprecision(pair, sum(answer.head, no_tail), first_multiprecision_bits))
    return proved(Verdict::disjoint, exact_vector(answer.head, no_tail), Stage::multiprecision,
                  first_multiprecision_bits);
  if (answer.witness == CertificateKind::points) return check_points_exactly(pair, answer);
  if (answer.witness != CertificateKind::point) return std::nullopt;
  const auto point = offered_point(pair, answer);
  // not covered: our answers are finite points of both solids, but those of other methods may not be
  if (!point || !in_both_exact(pair, *point) || !overlap_at(pair, *point)) return std::nullopt;
  return proved(Verdict::intersecting,
                in_space(answer) ? exact_vector(answer.head, answer.tail) : exact_vector(*point),
                Stage::exact, first_multiprecision_bits);
}

std::optional<Truth> check_offers(const Pair& pair, std::span<const MethodAnswer> offered) {
  for (const MethodAnswer& answer : offered)
    if (auto t = check_exactly(pair, answer)) {
      t->witnessed = true;
      return t;
    }
  return std::nullopt;
}

Found<MpFloat> search_in_multiprecision(const Pair& pair, int bits, Rational3& point, Rational3& direction) {
  const PrecisionScope precision(bits);
  const Found<MpFloat> found = search(multiprecision_pair(pair), bits);
  if (found.has_point) point = rational(found.point) + exact(pair.a.center);
  if (found.has_direction) direction = rational(found.direction);
  return found;
}

// Proves touching. The contact is guessed as the simplest rationals near the result of the search, then
// proved by algebra. This finds contacts at rational points in rational directions.
// The certificate is the shortest common point found.
std::optional<Truth> prove_touching(const Pair& pair, const Rational3& point, const Rational3& direction,
                                    int bits) {
  const Rational3 guess = simplest_near(pair, point, bits);
  const auto tangency = prove_tangency(pair, guess, guess, direction);
  if (!tangency || !tangency->meet) return std::nullopt;
  Truth t = proved(Verdict::touching, {}, Stage::exact, bits);
  for (const int digits : short_digits)
    if (const Rational3 simple = short_near(pair, point, digits); in_both_exact(pair, simple)) {
      t.certificate.vector = exact_vector(simple);
      return t;
    }
  for (const Rational3& x : {guess, point})
    if (auto common = common_point(pair, x)) {
      t.certificate.vector = common->written;
      return t;
    }
  if (const auto contact = contact_points(pair, tangency->direction);
      contact && in_both_exact(pair, contact->first)) {
    t.certificate.vector = exact_vector(contact->first);
    return t;
  }
  // No rational point was found. A search at this precision returns one within 2^-200 size of both solids.
  Rational3 near_point, near_direction;
  // not covered: touching solids show their point at any precision
  if (!search_in_multiprecision(pair, near_bits, near_point, near_direction).has_point) return std::nullopt;
  t.certificate.kind = CertificateKind::near;
  t.certificate.vector = exact_vector(near_point);
  t.certificate.second = exact_vector(tangency->direction);
  return t;
}

Vec3<double> shifted(const Vec3<double>& v, int exponent) {
  return {std::ldexp(v.x, exponent), std::ldexp(v.y, exponent), std::ldexp(v.z, exponent)};
}

std::optional<Truth> prove_by_filter(const Pair& pair, const Filter& filter,
                                     std::span<const MethodAnswer> offered, Certificates certificates,
                                     Guess& guess) {
  for (const MethodAnswer& answer : offered)
    if (auto t = check_by_filter(pair, filter, answer, certificates)) {
      t->witnessed = true;
      return t;
    }
  if (has_box(pair)) return prove_box_in_double(pair, filter, certificates == Certificates::written);
  if (is_rounded(pair)) return prove_rounded_in_double(pair, filter, guess);
  guess.found = search(double_pair(pair, guess.exponent), 53);
  guess.on_a = guess.on_b = guess.found.point;
  if (guess.found.has_direction) {
    const double d[3] = {guess.found.direction.x, guess.found.direction.y, guess.found.direction.z};
    if (filter.separates(d)) return proved(Verdict::disjoint, exact_vector(d, no_tail), Stage::filter, 53);
  }
  if (guess.found.has_point) {
    const double head[3] = {pair.a.center.x(), pair.a.center.y(), pair.a.center.z()};
    const Vec3<double> x = shifted(guess.found.point, guess.exponent);
    const double tail[3] = {x.x, x.y, x.z};
    if (filter.in_both(head, tail))
      return proved(Verdict::intersecting, exact_vector(head, tail), Stage::filter, 53);
  }
  return std::nullopt;
}

// Twice the digits of double decide most pairs that it leaves open.
std::optional<Verdict> verdict_in_twins(const Pair& pair, const TwinFilter& filter,
                                        std::span<const MethodAnswer> offered, const Guess& guess) {
  for (const MethodAnswer& answer : offered)
    if (auto t = check_by_filter(pair, filter, answer, Certificates::left_out)) return t->verdict;
  if (has_box(pair)) return box_verdict_in_twins(pair, filter);
  const auto &a = filter.a(), &b = filter.b();
  const SearchPair<Twin> p{middle(a.axis), middle(b.axis),  middle(filter.delta()), a.radius.middle,
                           a.half.middle,  b.radius.middle, b.half.middle};
  const Found<Twin> found = search(p, twin_bits);
  if (found.has_direction && filter.separates(intervals(found.direction))) return Verdict::disjoint;
  if (found.has_point && filter.overlap_at(intervals(found.point))) return Verdict::intersecting;
  if (!is_rounded(pair)) return {};
  const auto guessed = [&](const Vec3<double>& v) {
    const Vec3<double> x = shifted(v, guess.exponent - filter.exponent());
    return Vec3<Twin>{x.x, x.y, x.z};
  };
  const Nearest<Twin> nearest = refine_nearest(p, twin_bits, guessed(guess.on_a), guessed(guess.on_b));
  if (filter.separates(intervals(nearest.on_b - nearest.on_a))) return Verdict::disjoint;
  const Twin inward = Twin(1.0) - Twin(0x1p-80);  // farther than rounding carries a point out
  const bool meet =
      filter.come_near(intervals(inward * nearest.on_a), intervals(inward * (nearest.on_b - p.delta)));
  return meet ? std::optional(Verdict::intersecting) : std::nullopt;
}

// The first convergent of the continued fraction of x that differs from x by at most the tolerance, in
// double. x must be near 1 or less.
mpq_class simple_near(double x) {
  constexpr double tolerance = 0x1p-32;  // so that numerator and denominator are small
  double p0 = 0, q0 = 1, p1 = 1, q1 = 0, rest = x;
  do {
    const double whole = std::floor(rest);
    p0 = std::exchange(p1, whole * p1 + p0);
    q0 = std::exchange(q1, whole * q1 + q0);
    rest = 1 / (rest - whole);
  } while (std::fabs(x - p1 / q1) > tolerance);
  return mpq_class(mpz_class(p1), mpz_class(q1));
}

// Proves by algebra at simple points near the points that double found. Solids with a plane between them
// touch or are disjoint, and no point is needed to decide that.
std::optional<Truth> prove_near(const Pair& pair, const Guess& guess) {
  // If lengths are extreme, double may have found nothing.
  const auto known = [](const Vec3<double>& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
  };
  if (!known(guess.on_a) || !known(guess.on_b) || !known(guess.found.direction)) return std::nullopt;
  const Rational3 center = exact(pair.a.center);
  const auto simple = [&](const Vec3<double>& v) {
    return center +
           times_power(1, guess.exponent) * Rational3{simple_near(v.x), simple_near(v.y), simple_near(v.z)};
  };
  const auto settled = [](Verdict verdict) {
    Truth t = verdict_alone(verdict);
    t.stage = Stage::exact;
    t.bits = first_multiprecision_bits;
    return t;
  };
  const Rational3 on_a = simple(guess.on_a), on_b = simple(guess.on_b);
  const Vec3<double>& d = guess.found.direction;
  const auto plane =
      prove_tangency(pair, on_a, on_b, is_rounded(pair) ? on_b - on_a : Rational3{d.x, d.y, d.z});
  if (plane && plane->meet) return settled(Verdict::touching);
  // A gap that the cap of the wide search does not show stays undecided here too.
  const auto numbers = numbers_of(pair);
  const auto tiny = [](double x) { return x != 0 && std::fabs(x) < 0x1p-1000; };
  if (plane && (std::none_of(numbers.begin(), numbers.end(), tiny) ||
                support_gap_sign(pair, plane->direction, precision_cap) < 0))
    return settled(Verdict::disjoint);
  if (plane) return std::nullopt;
  if (!is_rounded(pair) && in_both_exact(pair, on_a) && overlap_at(pair, on_a))
    return settled(Verdict::intersecting);
  return std::nullopt;
}

// Cores that meet come first, because any common point is a proof. Then comes algebra, which settles ties,
// then the nearest points. The search for those points is slow if the cores almost touch. Then it proves
// nothing that algebra with more bits would not.
Truth search_rounded(const Pair& pair, int bits_cap) {
  Truth undecided;
  undecided.stage = Stage::exact;
  Rational3 point, direction;
  for (int bits = first_multiprecision_bits; bits <= bits_cap; bits *= 2) {
    undecided.bits = bits;
    const Found<MpFloat> found = search_in_multiprecision(pair, bits, point, direction);
    if (found.has_direction)
      if (auto t = prove_disjoint(pair, direction, bits)) return *t;
    if (found.has_point) {
      if (const auto common = common_point(pair, point))
        return proved(Verdict::intersecting, common->written, Stage::exact, bits);
      if (auto t = prove_cores_meet(pair, point, bits)) return *t;
    }
    if (bits == first_multiprecision_bits)
      if (auto t = prove_rounded_at_once(pair)) return *t;
    if (found.has_point && contact_distance_of(pair) < times_power(exact_size(pair), -bits / 4)) continue;
    if (auto t = prove_rounded(pair, bits)) return *t;
  }
  return undecided;
}

Truth search_exactly(const Pair& pair, int bits_cap) {
  Truth undecided;
  undecided.stage = Stage::exact;
  Rational3 point, direction;
  for (int bits = first_multiprecision_bits; bits <= bits_cap; bits *= 2) {
    undecided.bits = bits;
    const Found<MpFloat> found = search_in_multiprecision(pair, bits, point, direction);
    if (found.has_direction)
      if (auto t = prove_disjoint(pair, direction, bits)) return *t;
    if (!found.has_point) continue;
    const auto common = common_point(pair, point);
    // If the point does not exclude touching, algebra decides.
    if (common && overlap_at(pair, common->point))
      return proved(Verdict::intersecting, common->written, Stage::exact, bits);
    if (common || bits <= tangency_bits)
      if (auto t = prove_touching(pair, common ? common->point : point, direction, bits)) return *t;
    if (common) return proved(Verdict::intersecting, common->written, Stage::exact, bits);
  }
  return undecided;
}

}  // namespace

Truth prove_in_double(const Pair& pair, std::span<const MethodAnswer> offered) {
  if (!is_legal(pair)) return verdict_alone(Verdict::invalid);
  if (has_half_space(pair)) return judge_half_space(pair);
  Guess guess;
  return prove_by_filter(pair, Filter(pair), offered, Certificates::written, guess).value_or(Truth{});
}

Truth prove_exactly(const Pair& pair, std::span<const MethodAnswer> offered, int bits_cap) {
  if (!is_legal(pair)) return verdict_alone(Verdict::invalid);
  if (has_half_space(pair)) return judge_half_space(pair);
  if (auto t = check_offers(pair, offered)) return std::move(*t);
  if (has_box(pair)) return judge_box_exactly(pair, bits_cap);
  return is_rounded(pair) ? search_rounded(pair, bits_cap) : search_exactly(pair, bits_cap);
}

Truth judge(const Pair& pair, std::span<const MethodAnswer> offered) {
  Truth truth = prove_in_double(pair, offered);
  return truth.verdict == Verdict::undecided ? prove_exactly(pair, offered) : truth;
}

Truth judge_verdict(const Pair& pair, std::span<const MethodAnswer> offered) {
  if (!is_legal(pair)) return verdict_alone(Verdict::invalid);  // not covered: a family's pairs are valid
  if (has_half_space(pair)) {
    const int sign = half_space_sign(pair);
    return verdict_alone(sign < 0 ? Verdict::disjoint : sign > 0 ? Verdict::intersecting : Verdict::touching);
  }
  const Filter filter(pair);
  Guess guess;
  if (auto t = prove_by_filter(pair, filter, offered, Certificates::left_out, guess)) return std::move(*t);
  if (guess.found.has_point) {
    const Vec3<double> x = shifted(guess.found.point, guess.exponent - filter.exponent());
    if (filter.overlap_at(Vec3<Interval>{x.x, x.y, x.z})) return verdict_alone(Verdict::intersecting);
  }
  const TwinFilter twins(pair);
  if (const auto verdict = verdict_in_twins(pair, twins, offered, guess)) {
    Truth t = verdict_alone(*verdict);
    t.bits = twin_bits;
    return t;
  }
  if (has_box(pair)) return box_verdict_exactly(pair);
  if (!twins.usable())
    if (auto t = check_offers(pair, offered)) return std::move(*t);
  if (auto t = prove_near(pair, guess)) return std::move(*t);
  return prove_exactly(pair, offered);
}

Verdict check_witness(const Pair& pair, const MethodAnswer& answer) {
  if (!is_legal(pair)) return Verdict::undecided;  // not covered: a family's pairs are valid
  if (auto t = check_by_filter(pair, Filter(pair), answer, Certificates::left_out)) return t->verdict;
  if (!is_usable(answer)) return Verdict::undecided;
  if (answer.witness == CertificateKind::direction) {
    const Rational3 d = sum(answer.head, no_tail);
    return dot(d, d) != 0 && support_gap_sign(pair, d) < 0 ? Verdict::disjoint : Verdict::undecided;
  }
  if (answer.witness == CertificateKind::points)
    return points_show_contact(pair, answer) ? Verdict::intersecting : Verdict::undecided;
  // not covered: our answers are points of both solids, but those of other methods may not be
  if (answer.witness == CertificateKind::point) {
    const auto point = offered_point(pair, answer);
    // not covered: the same
    if (point && in_both_exact(pair, *point)) return Verdict::intersecting;
  }
  return Verdict::undecided;
}

}  // namespace cyl
