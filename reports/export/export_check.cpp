// SPDX-License-Identifier: MIT
#include "reports/export/export_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "corpus/pairs/pair_io.hpp"
#include "oracles/referee/certificate_check.hpp"
#include "reports/export/export_program.hpp"
#include "solver/distance.hpp"

namespace cyl {
namespace {

/// The relative width of the distance at whose direction the solids are shown to be apart.
constexpr double direction_width = 1e-9;
/// A relative length that pulls a rounded nearest point into its solid.
constexpr double pull_margin = 0x1p-40;

constexpr std::string_view head = R"(#!/usr/bin/env python3
"""Proves, in rational arithmetic, what is true of the two solids of issue.md. Standard library only.

A cylinder is solid and closed: centre, axis (of any length), radius, full height, rounding: all points within the
rounding of the cylinder proper, its core. Floats are taken exactly.
"""
import sys
from fractions import Fraction as F
from math import isqrt


def dot(u, v): return sum(F(x) * F(y) for x, y in zip(u, v))
def cross(u, v): return [F(u[i - 2]) * F(v[i - 1]) - F(u[i - 1]) * F(v[i - 2]) for i in range(3)]
def minus(u, v): return [F(x) - F(y) for x, y in zip(u, v)]
)";

constexpr std::string_view roots = R"(

def root(q, above):
    """A rational next to the square root of q, relatively within 2^-200: not below it if above, else not above."""
    bits = 2 * max(0, 201 + (q.denominator.bit_length() - q.numerator.bit_length()) // 2)
    return F(isqrt((q.numerator << bits) // q.denominator) + above, 1 << bits // 2) if q else F(0)


def reach(cylinder, d):
    """At least how far the cylinder reaches from its centre along d, times |d|."""
    _, axis, radius, height, rounding = cylinder
    across, along, ww = cross(d, axis), dot(d, axis), dot(axis, axis)
    core = F(radius) * root(dot(across, across) / ww, True) + F(height) / 2 * root(along * along / ww, True)
    return core + F(rounding) * root(dot(d, d), True)


def daylight(a, b, d):
    """At most how wide the gap is that planes square to d show, times |d|; if positive they separate."""
    return abs(dot(d, minus(b[0], a[0]))) - reach(a, d) - reach(b, d)


def shown(x): return f'{float(min(x, F(sys.float_info.max))):.9g}'
)";

constexpr std::string_view inside = R"(

def holds(cylinder, point):
    """Whether the point is in the core, decided exactly: squares instead of square roots."""
    centre, axis, radius, height, _ = cylinder
    x = minus(point, centre)
    across, along, ww = cross(x, axis), dot(x, axis), dot(axis, axis)
    return along ** 2 <= (F(height) / 2) ** 2 * ww and dot(across, across) <= F(radius) ** 2 * ww
)";

constexpr std::string_view near_touching = R"(

def grown(cylinder, by):
    rounding = F(cylinder[4]) + min(by, 0) if cylinder[4] else F(0)
    return cylinder[:2] + (max(F(0), F(cylinder[2]) + by), max(F(0), F(cylinder[3]) + 2 * by), rounding)
)";

constexpr std::string_view claims = R"(

ok = True


def claim(what, proved):
    global ok
    ok = ok and proved
    print(what + ':', 'proved' if proved else 'NOT PROVED')


)";

constexpr std::string_view disjoint_loop = R"(
for name, a, b, d in CASES:  # d: square to a plane that has one solid on each side
    width = daylight(a, b, d) / root(dot(d, d), True)
    claim(f'{name}: disjoint, at least {shown(width)} apart', width > 0)
)";

constexpr std::string_view meeting_loop = R"(
for name, a, b, point in CASES:  # a point of both
    claim(f'{name}: they meet', holds(a, point) and holds(b, point))
)";

constexpr std::string_view points_loop = R"(
for name, a, b, (p, q) in CASES:  # a point of each core
    between = minus(q, p)
    claim(f'{name}: they meet',
          holds(a, p) and holds(b, q) and dot(between, between) <= (F(a[4]) + F(b[4])) ** 2)
)";

constexpr std::string_view near_points_loop = R"(
for name, a, b, (p, q, d) in CASES:
    slack = sum(F(x) for x in a[2:] + b[2:]) / 2 ** 200
    between = minus(q, p)
    claim(f'{name}: they touch, to within 2^-200 of their size',
          holds(grown(a, slack), p) and holds(grown(b, slack), q)
          and dot(between, between) <= (F(a[4]) + F(b[4]) + slack) ** 2
          and daylight(grown(a, -slack), grown(b, -slack), d) > 0)
)";

constexpr std::string_view near_loop = R"(
for name, a, b, (point, d) in CASES:
    slack = sum(F(x) for x in a[2:] + b[2:]) / 2 ** 200
    claim(f'{name}: they touch, to within 2^-200 of their size',
          holds(grown(a, slack), point) and holds(grown(b, slack), point)
          and daylight(grown(a, -slack), grown(b, -slack), d) > 0)
)";

std::string tuple(const Vector3& v) {
  return fmt::format("({}, {}, {})", format_double(v[0]), format_double(v[1]), format_double(v[2]));
}

std::string solid(const Cylinder& c) {
  return fmt::format("({}, {}, {}, {}, {})", tuple(c.center), tuple(c.axis), format_double(c.radius),
                     format_double(c.height), format_double(c.rounding));
}

std::string tuple(const ExactVector& v) {
  std::string coordinates[3];
  for (std::size_t i = 0; i < 3; ++i) {
    coordinates[i] = !v.exact[i].empty() ? fmt::format("F('{}')", v.exact[i])
                     : v.tail[i] == 0
                         ? format_double(v.head[i])
                         : fmt::format("F({}) + F({})", format_double(v.head[i]), format_double(v.tail[i]));
  }
  return fmt::format("({}, {}, {})", coordinates[0], coordinates[1], coordinates[2]);
}

Vector3 plain(const double (&v)[3]) { return {v[0], v[1], v[2]}; }

/// The direction of the distance, if it separates; it shows the widest gap.
std::optional<Vector3> widest_direction(const Pair& pair, const Truth& truth) {
  const AttainedDistance attained = attain_distance(pair, truth, direction_width);
  MethodAnswer witness;
  witness.status = Status::answered;
  witness.set_direction({attained.direction[0], attained.direction[1], attained.direction[2]});
  if (check_witness(pair, witness) != Verdict::disjoint) return {};
  return plain(witness.head);
}

bool meet(const Truth& truth) {
  return truth.verdict == Verdict::intersecting || truth.verdict == Verdict::touching;
}

std::string certificate(const Pair& pair, const Truth& truth) {
  if (truth.verdict == Verdict::disjoint)
    if (const auto direction = widest_direction(pair, truth)) return tuple(*direction);
  const Certificate& proof = truth.certificate;
  if (proof.kind == CertificateKind::near || proof.kind == CertificateKind::points)
    return fmt::format("({}, {})", tuple(proof.vector), tuple(proof.second));
  if (proof.kind == CertificateKind::near_points)
    return fmt::format("({}, {}, {})", tuple(proof.vector), tuple(proof.third), tuple(proof.second));
  return tuple(truth.certificate.vector);
}

std::string cases(const Trial& asked, CertificateKind kind, AxesGiven axes) {
  const auto line = [](const char* name, const Pair& pair, const Truth& truth) {
    return fmt::format("    ('{}', {},\n     {},\n     {}),\n", name, solid(pair.a), solid(pair.b),
                       certificate(pair, truth));
  };
  std::string text = "CASES = [\n" + line("as asked", asked.pair, asked.truth);
  const Pair given = axes == AxesGiven::of_unit_length ? as_given(asked.pair) : asked.pair;
  if (given.a.axis != asked.pair.a.axis || given.b.axis != asked.pair.b.axis) {
    const Truth truth = judge(given);
    if (meet(truth) != meet(asked.truth))
      throw std::runtime_error(
          fmt::format("the library gets axes rounded to unit length, and of these the truth is {}: it is not "
                      "to blame",
                      to_string(truth.verdict)));
    if (truth.certificate.kind != kind)
      throw std::runtime_error("no one check proves the truth for these axes and for axes of unit length");
    text += line("with the axes that the library gets", given, truth);
  }
  return text + "]\n";
}

/// A point of the solid next to the one given, proved to be there.
std::optional<Rational3> point_in(const Cylinder& c, const Vector3& point) {
  const Pair twice{c, c};
  for (const double share : {1.0, 1 - pull_margin}) {
    const auto x = project_to_hulls(twice, exact(c.center + share * (point - c.center)));
    if (x && in_both_exact(twice, *x)) return x;
  }
  return {};
}

std::string tuple(const Rational3& v) {
  const auto coordinate = [](const mpq_class& x) {
    return mpq_class(x.get_d()) == x ? format_double(x.get_d()) : fmt::format("F('{}')", x.get_str());
  };
  return fmt::format("({}, {}, {})", coordinate(v.x), coordinate(v.y), coordinate(v.z));
}

/// The lines that show the distance said to be impossible, of the pair as asked.
std::string distance_lines(const Trial& asked, const Claim& claim) {
  if (!asked.finding() || asked.finding()->kind != FindingKind::distance_outside) return {};
  const double said = asked.answer().distance, tolerance = reach(claim, size_of(asked.pair));
  const bool short_of = said < asked.distance.lo;
  const std::string numbers = fmt::format("\nSAID, TOLERANCE = {}, {}\nname, a, b, _ = CASES[0]\n",
                                          format_double(said), format_double(tolerance));
  if (asked.truth.verdict == Verdict::disjoint && short_of) {
    return numbers +
           "width = daylight(a, b, CASES[0][3]) / root(dot(CASES[0][3], CASES[0][3]), True)\n"
           "claim(f'the distance said, {SAID}, is too small by more than {TOLERANCE}', width > F(SAID) + "
           "F(TOLERANCE))\n";
  }
  if (asked.truth.verdict == Verdict::disjoint) {
    Cylinder a = asked.pair.a, b = asked.pair.b;
    a.rounding = b.rounding = 0;
    const Distance nearest = distance(a, b);
    const auto p = point_in(a, a.center + nearest.on_a), q = point_in(b, b.center + nearest.on_b);
    if (!p || !q || !(said > tolerance)) return {};
    const Rational3 between = *p - *q;
    const mpq_class allowed = mpq_class(said) - mpq_class(tolerance) + mpq_class(asked.pair.a.rounding) +
                              mpq_class(asked.pair.b.rounding);
    if (dot(between, between) >= allowed * allowed) return {};
    return numbers + fmt::format("of_a, of_b = {}, {}\nbetween = minus(of_a, of_b)\n", tuple(*p), tuple(*q)) +
           "claim(f'the distance said, {SAID}, is too large by more than {TOLERANCE}', holds(a, of_a) and "
           "holds(b, of_b)\n      and dot(between, between) < (F(SAID) - F(TOLERANCE) + F(a[4]) + F(b[4])) "
           "** 2 "
           "and SAID > TOLERANCE)\n";
  }
  if (!short_of) return {};
  const AttainedDistance attained = attain_distance(asked.pair, asked.truth, direction_width);
  return numbers +
         fmt::format("d = {}\ndepth = -daylight(a, b, d) / root(dot(d, d), False)\n",
                     tuple(Vector3(attained.direction[0], attained.direction[1], attained.direction[2]))) +
         "claim(f'the distance said, {SAID}, is too deep by more than {TOLERANCE}: one along {d} ends at "
         "depth "
         "{shown(depth)}',\n      depth < -F(SAID) - F(TOLERANCE))\n";
}

std::string witness_lines(const Trial& asked) {
  if (!asked.finding() || asked.finding()->kind != FindingKind::bad_witness) return {};
  if (asked.answer().witness == CertificateKind::point) {
    ExactVector said;
    std::copy_n(asked.answer().head, 3, said.head.begin());
    std::copy_n(asked.answer().tail, 3, said.tail.begin());
    return fmt::format(
        "\nsaid = {}\nname, a, b, _ = CASES[0]\n"
        "claim('the point said is not in both', not (holds(a, said) and holds(b, said)))\n",
        tuple(said));
  }
  // reach() is too large by 2^-200 of it at most: what is below -2^-190 of it is below 0 for certain.
  return fmt::format(
      "\nsaid = {}  # to be square to a plane between them\n"
      "name, a, b, _ = CASES[0]\n"
      "claim('the direction said does not separate them',\n"
      "      daylight(a, b, said) < -(reach(a, said) + reach(b, said)) / 2 ** 190)\n",
      tuple(plain(asked.answer().head)));
}

}  // namespace

bool shows_distance(const Trial& asked, const Claim& claim) { return !distance_lines(asked, claim).empty(); }

std::string exact_check(const Trial& asked, const Claim& claim, AxesGiven axes) {
  const CertificateKind kind = asked.truth.certificate.kind;
  const std::string data = cases(asked, kind, axes);
  const std::string more = distance_lines(asked, claim) + witness_lines(asked);
  const bool uses_points = kind != CertificateKind::direction || more.find("holds(") != std::string::npos;
  const bool uses_roots = (kind != CertificateKind::point && kind != CertificateKind::points) ||
                          more.find("daylight(") != std::string::npos;
  std::string text(head);
  if (uses_roots) text += roots;
  if (uses_points) text += inside;
  if (kind == CertificateKind::near || kind == CertificateKind::near_points) text += near_touching;
  text += claims;
  text += data;
  text += kind == CertificateKind::direction     ? disjoint_loop
          : kind == CertificateKind::near        ? near_loop
          : kind == CertificateKind::points      ? points_loop
          : kind == CertificateKind::near_points ? near_points_loop
                                                 : meeting_loop;
  return text + more + "sys.exit(0 if ok else 1)\n";
}

}  // namespace cyl
