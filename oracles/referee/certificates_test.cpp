// SPDX-License-Identifier: MIT
// Pairs are drawn so that a direction or a point is near the edge of a proof. There a wrong sign, a bound
// rounded inwards and a lost term all show. The expected results come from other formulas than the
// referee's.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>

#include "corpus/pairs/checks_test.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/random_stream.hpp"
#include "oracles/referee/certificate_check.hpp"
#include "oracles/referee/referee.hpp"

namespace cyl {
namespace {

constexpr std::uint64_t direction_count = 4000, point_count = 3000, hull_count = 6000;

/// The most that a filter may lose to rounding, in units of its last place, times the pair's reach. A filter
/// takes 60 operations, each rounded outward by two units.
constexpr double filter_loss_error = 256;
constexpr int real_bits = 512;

using Reals = std::array<mpf_class, 3>;
using Rationals = std::array<mpq_class, 3>;

template <class T>
std::array<T, 3> numbers_in(const Vector3& v) {
  return {T(v.x()), T(v.y()), T(v.z())};
}
template <class T>
T inner(const std::array<T, 3>& u, const std::array<T, 3>& v) {
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}
template <class T>
std::array<T, 3> minus(const std::array<T, 3>& u, const std::array<T, 3>& v) {
  return {T(u[0] - v[0]), T(u[1] - v[1]), T(u[2] - v[2])};
}

/// Returns 0 in `flat` of eight cases, and otherwise a length up to a few decades below the unit.
double draw_length(RandomStream& stream, std::size_t flat) {
  const bool none = stream.below(8) < flat;
  const double decade = std::ldexp(1.0, -stream.integer(0, 12)), part = stream.between(0.5, 1);
  return none ? 0 : decade * part;
}

Solid draw_solid(RandomStream& stream, std::size_t flat) {
  Solid c;
  c.axis = stream.below(4) == 0 ? stream.coordinate_axis() : stream.unit_vector();
  c.axis *= std::ldexp(stream.between(0.5, 1), stream.integer(-3, 3));
  for (int i = 0; i < 3; ++i) c.center[i] = stream.between(-1, 1);
  c.radius = draw_length(stream, flat);
  c.height = draw_length(stream, flat);
  return c;
}

/// Returns the exponent of an exact scaling. Half of the pairs stay, and some come near the range's ends.
int draw_exponent(RandomStream& stream) {
  const int far = stream.integer(-900, 900), near = stream.integer(-30, 30);
  return stream.coin() ? 0 : stream.coin() ? near : far;
}

// f(d) = radius |d x w|/|w| + height/2 |d.w|/|w| of both, less |d.delta|. |d x w|^2 = |d|^2 |w|^2 - (d.w)^2.
mpf_class reach_along(const Solid& c, const Reals& d) {
  const Reals w = numbers_in<mpf_class>(c.axis);
  const mpf_class ww = inner(w, w), dw = inner(d, w), across = inner(d, d) * ww - dw * dw;
  return (c.radius * sqrt(across > 0 ? across : mpf_class(0)) + mpf_class(c.height) / 2 * abs(dw)) / sqrt(ww);
}
mpf_class gap_of(const Pair& pair, const Reals& d) {
  const Reals delta = minus(numbers_in<mpf_class>(pair.b.center), numbers_in<mpf_class>(pair.a.center));
  return reach_along(pair.a, d) + reach_along(pair.b, d) - abs(inner(d, delta));
}
double reach_of_pair(const Pair& pair) { return size_of(pair) + (pair.b.center - pair.a.center).lpNorm<1>(); }

/// Moves b along d until f(d) is `share` of the reach, below or above 0, as exactly as doubles can.
void bring_near(Pair& pair, const Vector3& d, double share) {
  for (int round = 0; round < 3; ++round) {
    const double side = inner_product(d, pair.b.center - pair.a.center) < 0 ? -1 : 1;
    const double now = gap_of(pair, numbers_in<mpf_class>(d)).get_d();
    const double wanted = share * reach_of_pair(pair) * length_of(d);
    pair.b.center += (side * (now - wanted) / inner_product(d, d)) * d;
  }
}

/// Returns 2^-60 to 2^-1 with either sign.
double draw_share(RandomStream& stream) {
  const double sign = stream.sign(), part = stream.between(0.5, 1);
  return sign * std::ldexp(part, -stream.integer(0, stream.coin() ? 60 : 8) - 1);
}

void check_direction(std::uint64_t index) {
  RandomStream stream("directions", drawing_seed, index);
  Pair pair{draw_solid(stream, 1), draw_solid(stream, 1)};
  const Vector3 unit = stream.below(4) == 0 ? stream.coordinate_axis() : stream.unit_vector();
  bring_near(pair, unit, draw_share(stream));
  const int exponent = draw_exponent(stream), turned = stream.integer(-500, 500);
  const Vector3 d = std::ldexp(1.0, stream.coin() ? 0 : turned) * unit;
  const double reach = reach_of_pair(pair) * length_of(unit);
  const mpf_class f = gap_of(pair, numbers_in<mpf_class>(unit));
  const auto scene = scaled_exactly(pair, exponent);
  if (!scene) return;
  const auto expect = [&](bool says, double last_place, const char* who) {
    check_that(!says || f < 0, who, "separates what is not apart:", *scene);
    if (f < -filter_loss_error * last_place * reach)
      check_that(says, who, "does not separate:", *scene, f.get_d());
  };
  const double given[3] = {d.x(), d.y(), d.z()};
  expect(Filter(*scene).separates(given), 0x1p-53, "directions: the filter");
  expect(TwinFilter(*scene).separates(given), 0x1p-98, "directions: the filter in two doubles");
  const Rational3 exact_d{mpq_class(d.x()), mpq_class(d.y()), mpq_class(d.z())};
  expect(separates_in_multiprecision(*scene, exact_d, 128), 0x1p-128, "directions: 128 bits");
  const int sign = support_gap_sign(*scene, exact_d, 256);
  check_that(sign == sgn(f) || (sign == 0 && abs(f) < filter_loss_error * 0x1p-250 * reach),
             "directions: sign in 256 bits", *scene);
  MethodAnswer answer;
  answer.status = Status::answered;
  answer.set_direction(d);
  expect(check_witness(*scene, answer) == Verdict::disjoint, 0x1p-128, "directions: a witness");
  const Truth with = judge(*scene, {&answer, 1});
  check_that(!(f < -filter_loss_error * 0x1p-128 * reach) || with.verdict == Verdict::disjoint,
             "directions: judged with a witness", *scene);
}

// Compares the square of x.w/|w| with height^2/4, and the square of the part of x across w with radius^2.
struct Beyond {
  mpq_class along, across;  // times |w|^2; negative inside, 0 on it
};
Beyond beyond(const Solid& c, const Rationals& point) {
  const Rationals x = minus(point, numbers_in<mpq_class>(c.center)), w = numbers_in<mpq_class>(c.axis);
  const mpq_class ww = inner(w, w), xw = inner(x, w), half = mpq_class(c.height) / 2, radius(c.radius);
  return {xw * xw - half * half * ww, inner(x, x) * ww - xw * xw - radius * radius * ww};
}
bool is_inside(const Solid& c, const Rationals& point) {
  const Beyond by = beyond(c, point);
  return by.along <= 0 && by.across <= 0;
}
/// Returns whether the point stays inside if each length of the solid that is not 0 shrinks by `margin`.
bool has_margin(Solid c, const Rationals& point, double margin, bool level, bool thin) {
  if ((!level && c.height <= 2 * margin) || (!thin && c.radius <= margin)) return false;
  c.height -= 2 * margin;
  c.radius -= margin;
  const Beyond by = beyond(c, point);
  return (level || by.along <= 0) && (thin || by.across <= 0);
}

/// Returns a point of the solid's frame, `along` half heights along its axis and `across` radii across it.
Vector3 point_of(RandomStream& stream, const Solid& c, double along, double across) {
  const Vector3 w = normalise(c.axis), out = stream.perpendicular(w);
  return along * c.height / 2 * w + across * c.radius * out;
}

/// Half of the numbers are within a little of 1, at the surface. The others are inside or a little outside.
double draw_place(RandomStream& stream) {
  const double near = 1 + draw_share(stream), any = stream.between(0, 1.1);
  return stream.coin() ? near : any;
}

Rationals sum_of(const double (&head)[3], const double (&tail)[3]) {
  Rationals sum;
  for (std::size_t i = 0; i < 3; ++i) sum[i] = mpq_class(head[i]) + mpq_class(tail[i]);
  return sum;
}
Rational3 as_vector(const Rationals& x) { return {x[0], x[1], x[2]}; }
Rationals as_array(const Rational3& x) { return {x.x, x.y, x.z}; }

MethodAnswer offering(const double (&head)[3], const double (&tail)[3], const Hulls& hulls) {
  MethodAnswer answer;
  answer.status = Status::answered;
  answer.witness = CertificateKind::point;
  std::copy(head, head + 3, answer.head);
  std::copy(tail, tail + 3, answer.tail);
  std::copy(hulls.begin(), hulls.end(), answer.hulls);
  return answer;
}

/// Checks a point near the surface of one or both of two solids, in one unit or another.
void check_point(std::uint64_t index) {
  RandomStream stream("points", drawing_seed, index);
  Pair pair{draw_solid(stream, 0), draw_solid(stream, 0)};
  const double places[] = {draw_place(stream), draw_place(stream), draw_place(stream), draw_place(stream)};
  const Vector3 from_a = point_of(stream, pair.a, places[0] * stream.sign(), places[1]);
  pair.b.center = pair.a.center + from_a - point_of(stream, pair.b, places[2] * stream.sign(), places[3]);
  const int exponent = draw_exponent(stream);
  const auto scene = scaled_exactly(pair, exponent);
  if (!scene) return;
  double head[3], tail[3];
  bool exact = true;
  for (int i = 0; i < 3; ++i) {
    head[i] = scene->a.center[i];
    tail[i] = std::ldexp(from_a[i], exponent);
    exact = exact && std::ldexp(tail[i], -exponent) == from_a[i];
  }
  if (!exact) return;
  const Rationals point = sum_of(head, tail);
  const bool in_a = is_inside(scene->a, point), in_b = is_inside(scene->b, point);
  const double margin = filter_loss_error * std::ldexp(reach_of_pair(pair), exponent - 53);
  const bool certain =
      has_margin(scene->a, point, margin, false, false) && has_margin(scene->b, point, margin, false, false);
  const auto expect = [&](bool says, const char* who) {
    check_that(!says || (in_a && in_b), who, "proves a point that is outside:", *scene);
    check_that(says || !certain, who, "does not prove a point:", *scene);
  };
  expect(Filter(*scene).in_both(head, tail), "points: the filter");
  expect(Filter(*scene).overlap_at(head, tail, {}), "points: an overlap");
  expect(TwinFilter(*scene).in_both(head, tail), "points: the filter in two doubles");
  check_that(in_both_exact(*scene, as_vector(point)) == (in_a && in_b), "points: exactly", *scene);
  const auto is_strict = [&](const Solid& c) {
    return beyond(c, point).along < 0 && beyond(c, point).across < 0;
  };
  check_that(overlap_at(*scene, as_vector(point)) == (is_strict(scene->a) || is_strict(scene->b)),
             "points: an overlap exactly", *scene);
  const MethodAnswer answer = offering(head, tail, {});
  check_that((check_witness(*scene, answer) == Verdict::intersecting) == (in_a && in_b), "points: a witness",
             *scene);
  check_that(!certain || judge(*scene, {&answer, 1}).verdict == Verdict::intersecting,
             "points: judged with a witness", *scene);
}

/// A tail far below the unit cannot be brought to the filter's unit. Then it proves nothing.
void check_lost_tail() {
  const Pair pair{{Vector3(0, 0, 0), Vector3(0, 0, 1), 0x1p300, 0x1p300},
                  {Vector3(0, 0, 0x1p300), Vector3(0, 0, 1), 0x1p300, 0x1p300}};
  const double head[3] = {0, 0, 0x1p299}, up[3] = {0, 0, 0x1p-1074}, down[3] = {0, 0, -0x1p-1074};
  for (const auto& tail : {up, down})
    check_that(!Filter(pair).in_both(head, *reinterpret_cast<const double(*)[3]>(tail)),
               "points: a tail that is lost");
}

bool is_level(Hull hull) { return hull == Hull::plane || hull == Hull::center; }
bool is_thin(Hull hull) { return hull == Hull::line || hull == Hull::center; }
Hull both_of(Hull x, bool level, bool thin) {
  level = level || is_level(x);
  thin = thin || is_thin(x);
  return level && thin ? Hull::center : level ? Hull::plane : thin ? Hull::line : Hull::space;
}
/// A flat solid's own hull counts for any hull.
Hull hull_of(const Solid& c, Hull said) { return both_of(said, c.height == 0, c.radius == 0); }

bool is_on(const Solid& c, Hull hull, const Rationals& point) {
  const Rationals x = minus(point, numbers_in<mpq_class>(c.center)), w = numbers_in<mpq_class>(c.axis);
  const mpq_class xw = inner(x, w);
  return (!is_level(hull) || xw == 0) && (!is_thin(hull) || inner(x, x) * inner(w, w) == xw * xw);
}

/// Returns whether the way from the guess to its projection is square to all that the hulls leave free.
bool is_nearest(const Pair& pair, Hull hull_a, Hull hull_b, const Rationals& way) {
  const Rationals u = numbers_in<mpq_class>(pair.a.axis), v = numbers_in<mpq_class>(pair.b.axis);
  const mpq_class square = inner(way, way);
  const auto is_along = [&](const Rationals& w) {
    const mpq_class part = inner(way, w);
    return part * part == square * inner(w, w);
  };
  if (hull_a == Hull::plane && hull_b == Hull::plane) {
    const mpq_class normal = way[0] * (u[1] * v[2] - u[2] * v[1]) + way[1] * (u[2] * v[0] - u[0] * v[2]) +
                             way[2] * (u[0] * v[1] - u[1] * v[0]);
    return normal == 0;
  }
  if (hull_a == Hull::space && hull_b == Hull::space) return square == 0;
  if (hull_a == Hull::space || hull_b == Hull::space) {
    const Rationals& w = hull_a == Hull::space ? v : u;
    const Hull hull = hull_a == Hull::space ? hull_b : hull_a;
    return hull == Hull::center || (hull == Hull::plane ? is_along(w) : inner(way, w) == 0);
  }
  return true;
}

/// Two solids with a point near which their hulls meet, and a guess beside it.
void check_hulls(std::uint64_t index) {
  RandomStream stream("hulls", drawing_seed, index);
  Pair pair{draw_solid(stream, 2), draw_solid(stream, 2)};
  Hulls said{enum_values<Hull>[stream.below(4)], enum_values<Hull>[stream.below(4)]};
  if (stream.coin()) said = {};
  const Hull hull_a = hull_of(pair.a, said[0]), hull_b = hull_of(pair.b, said[1]);
  const auto place = [&](const Solid& c, Hull hull) {
    const double along = is_level(hull) ? 0 : draw_place(stream) * stream.sign();
    return point_of(stream, c, along, is_thin(hull) ? 0 : draw_place(stream));
  };
  const Vector3 from_a = place(pair.a, hull_a);
  pair.b.center = pair.a.center + from_a - place(pair.b, hull_b);
  const double off = stream.coin() ? 0 : stream.between(0, 0x1p-6);
  const Vector3 beside = off * stream.unit_vector();
  double head[3], tail[3];
  for (int i = 0; i < 3; ++i) {
    head[i] = pair.a.center[i];
    tail[i] = from_a[i] + beside[i];
  }
  const Rationals guess = sum_of(head, tail);
  const auto projected = project_to_hulls(pair, as_vector(guess), said);
  const bool surely_meet = (hull_a == Hull::space) || (hull_b == Hull::space) ||
                           (hull_a == Hull::plane && hull_b == Hull::plane) ||
                           (hull_a == Hull::plane && hull_b == Hull::line) ||
                           (hull_a == Hull::line && hull_b == Hull::plane);
  const double cosine = inner_product(normalise(pair.a.axis), normalise(pair.b.axis));
  const bool planes = hull_a == hull_b;
  const bool steep = hull_a == Hull::space || hull_b == Hull::space ||
                     (planes ? std::fabs(cosine) < 0.99 : std::fabs(cosine) > 0.1);
  check_that(projected.has_value() || !surely_meet || !steep, "hulls: no point", pair);
  bool in_both = false, certain = false;
  if (projected) {
    const Rationals point = as_array(*projected);
    check_that(is_on(pair.a, hull_a, point) && is_on(pair.b, hull_b, point), "hulls: a point beside", pair);
    check_that(is_nearest(pair, hull_a, hull_b, minus(guess, point)), "hulls: a point far off", pair);
    in_both = is_inside(pair.a, point) && is_inside(pair.b, point);
    const double margin = 16 * filter_loss_error * reach_of_pair(pair) * 0x1p-53 / (steep ? 0.1 : 0x1p-53);
    certain = surely_meet && has_margin(pair.a, point, margin, is_level(hull_a), is_thin(hull_a)) &&
              has_margin(pair.b, point, margin, is_level(hull_b), is_thin(hull_b));
  }
  const auto expect = [&](bool says, bool owes, const char* who) {
    check_that(!says || in_both, who, "proves a point that is outside:", pair);
    check_that(says || !owes || !certain, who, "does not prove a point:", pair);
  };
  expect(Filter(pair).overlap_at(head, tail, said), true, "hulls: the filter");
  expect(TwinFilter(pair).overlap_at(head, tail, said), true, "hulls: the filter in two doubles");
  const MethodAnswer answer = offering(head, tail, said);
  if (said != Hulls{}) {
    expect(check_witness(pair, answer) == Verdict::intersecting, true, "hulls: a witness");
    if (certain)
      check_that(judge(pair, {&answer, 1}).verdict == Verdict::intersecting, "hulls: judged with a witness",
                 pair);
  }
  if (in_both) check_that(judge_verdict(pair).verdict != Verdict::disjoint, "hulls: judged", pair);
}

TEST(RefereeCertificates, ProveWhatIsSoAndNothingElse) {
  mpf_set_default_prec(real_bits);
  for (std::uint64_t i = 0; i < direction_count; ++i) check_direction(i);
  for (std::uint64_t i = 0; i < point_count; ++i) check_point(i);
  for (std::uint64_t i = 0; i < hull_count; ++i) check_hulls(i);
  check_lost_tail();
}

}  // namespace
}  // namespace cyl
