// SPDX-License-Identifier: MIT
#include "props/shrink/moves.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <utility>

#include "corpus/pairs/touch_plane.hpp"
#include "oracles/referee/referee.hpp"
#include "props/shrink/complexity.hpp"

namespace cyl::moves {
namespace {

/// Places of a solid's numbers.
constexpr std::size_t radius_place = 6, rounding_place = 8, first_edge_place = 9, quaternion_place = 12;
/// Newton steps towards a distance. The distance is smooth in a number except at kinks, which end the steps.
constexpr int newton_cap = 8;
/// Relative to a distance that is to be kept. A pair farther from it is not asked about.
constexpr double kept_part_tol = 0.25;
constexpr int digit_cap = 17;  ///< all that a double has

double rounded(double x, int digits) {
  char text[40];
  const char* end = std::to_chars(text, text + sizeof text, x, std::chars_format::scientific, digits - 1).ptr;
  double y = 0;
  return std::from_chars(text, end, y).ec == std::errc() ? y : x;
}

Vector3 rounded(const Vector3& v, int digits) {
  return v.unaryExpr([&](double x) { return rounded(x, digits); });
}

/// Returns the places in the row of numbers() of the lengths of both solids. Roundings come last, so that
/// they can be left out if both are 0.
std::vector<std::size_t> length_places(const Pair& p) {
  std::vector<std::size_t> all;
  for (const Solid* c : {&p.a, &p.b}) {
    const std::size_t first = c == &p.a ? 0 : solid_number_count;
    for (const std::size_t i : places_of(c->shape))
      if (i != rounding_place && i >= radius_place && i < quaternion_place) all.push_back(first + i);
  }
  if (is_rounded(p))
    for (const Solid* c : {&p.a, &p.b})
      if (!is_half_space(*c)) all.push_back(rounding_place + (c == &p.a ? 0 : solid_number_count));
  return all;
}

std::vector<double*> lengths(Pair& p) {
  const auto all = numbers(p);
  std::vector<double*> some;
  for (const std::size_t i : length_places(p)) some.push_back(all[i]);
  return some;
}

// distance = max over unit D of D.(b - a) - (support of both). Its derivative by a number x is that of D.(b
// - a) or of the support at the D that attains the maximum. It is D_i for b's centre and -1 for a
// rounding. It is minus the sine of the angle between D and the axis for a radius, and minus half the cosine
// for a height or an edge.
double slope(const MeasuredDistance& d, const Pair& p, std::size_t place) {
  const Solid& c = place < solid_number_count ? p.a : p.b;
  const std::size_t i = place % solid_number_count;
  if (i < 3) return d.direction[static_cast<Eigen::Index>(i)];
  if (i == rounding_place) return c.rounding == 0 ? 0 : -1;  // a solid stays without rounding
  if (is_box(c)) return -std::fabs(d.direction.dot(edge_direction(c, i - first_edge_place))) / 2;
  const Vector3 w = c.axis.stableNormalized();
  return i == radius_place ? -d.direction.cross(w).norm() : -std::fabs(d.direction.dot(w)) / 2;
}

/// Returns numbers that might replace x. The search asks only about the simpler ones.
std::vector<double> simpler_numbers(double x) {
  if (x == 0) return {0};
  std::vector<double> out{0,           1, std::copysign(1, x), std::fabs(x), std::round(x), std::floor(x),
                          std::ceil(x)};
  const int e = decimal_of(x).exponent, sign = x < 0 ? -1 : 1;
  for (int k = 1; k <= 10; ++k) out.push_back(decimal(sign * k, e));
  // Exponents closer to 0.
  for (const int other : {e / 2, e > 0 ? e - 1 : e + 1}) {
    out.push_back(decimal(sign, other));
    out.push_back(decimal(static_cast<long long>(rounded(x / decimal(1, e), 1)), other));
  }
  int exponent = 0;
  const double significand = std::frexp(x, &exponent);
  for (int bits = 1; bits <= 6; ++bits)
    out.push_back(std::ldexp(std::round(std::ldexp(significand, bits)), exponent - bits));
  for (int digits = 1; digits < digit_cap; ++digits) {
    const double y = rounded(x, digits);
    out.push_back(y);
    if (digits > 3) continue;
    const double unit = decimal(1, e - digits + 1);
    out.push_back(rounded(y + unit, digits));
    out.push_back(rounded(y - unit, digits));
  }
  // For a simple number plus a tiny rest, the rest becomes a power of ten.
  for (const double whole : {rounded(x, 1), rounded(x, 2), std::round(x)}) {
    const double rest = x - whole;
    if (whole == 0 || rest == 0 || std::fabs(rest) > near_margin * std::fabs(x)) continue;
    for (int power = decimal_of(rest).exponent; power < e - 1; ++power)
      out.push_back(rounded(whole + decimal(rest < 0 ? -1 : 1, power), e - power + 1));
  }
  return out;
}

}  // namespace

void add_at_distance(const Pair& p, double kept, Pairs& out) {
  if (!is_legal(p)) return;
  const MeasuredDistance now = approximate_distance(p);
  constexpr std::size_t b = solid_number_count;
  for (const std::vector<std::size_t>& places :
       {std::vector<std::size_t>{b, b + 1, b + 2}, length_places(p)}) {
    const std::size_t best =
        *std::ranges::max_element(places, {}, [&](std::size_t i) { return std::fabs(slope(now, p, i)); });
    Pair q = p;
    double& x = *numbers(q)[best];
    double off = now.value - kept;
    MeasuredDistance at = now;
    for (int step = 0; step < newton_cap && off != 0; ++step) {
      const double before = x, by = slope(at, q, best);
      if (by == 0) break;
      x -= off / by;
      if (x == before || !is_legal(q)) break;
      at = approximate_distance(q);
      off = at.value - kept;
    }
    if (is_legal(q) && std::fabs(off) <= kept_part_tol * std::fabs(kept)) out.push_back(q);
  }
}

Pairs translations(const Pair& p) {
  Pairs out;
  const auto add = [&](bool of_a, const Vector3& to) {
    out.push_back(with(p, [&](Pair& q) {
      Solid &fixed = of_a ? q.a : q.b, &other = of_a ? q.b : q.a;
      other.center = to + (other.center - fixed.center);
      fixed.center = to;
    }));
  };
  for (const bool of_a : {true, false}) {
    const Vector3& c = (of_a ? p.a : p.b).center;
    add(of_a, Vector3::Zero());
    for (int digits = 1; digits <= 4; ++digits)
      out.push_back(with(out.back(), [&](Pair& q) {
        (of_a ? q.b : q.a).center = rounded((p.b.center - p.a.center) * (of_a ? 1 : -1), digits);
      }));
    Eigen::Index most = 0;
    c.cwiseAbs().maxCoeff(&most);
    if (c[most] == 0) continue;
    const int e = decimal_of(c[most]).exponent;
    for (const int exponent : {e + 1, e, e - 1}) add(of_a, decimal(1, exponent) * Vector3::UnitZ());
    for (int digits = 1; digits <= 4; ++digits) {
      const Vector3 to = rounded(c, digits);
      add(of_a, to);
      add(of_a, to[most] * Vector3::Unit(most));
    }
  }
  return out;
}

Pairs scales(const Pair& p) {
  Pairs out;
  const auto add = [&](double by) {
    if (by == 0 || !std::isfinite(by)) return;
    out.push_back(with(p, [&](Pair& q) { for_each_length(q, [&](double& x) { x /= by; }); }));
  };
  Pair copy = p;
  double most = 0;
  for (const double* x : lengths(copy)) {
    add(*x);
    most = std::max(most, *x);
  }
  for (const double x : p.b.center) add(std::fabs(x));
  if (most == 0) most = p.b.center.cwiseAbs().maxCoeff();
  if (most == 0) return out;
  add(std::ldexp(1, std::ilogb(most)));
  const int e = decimal_of(most).exponent;
  for (const int exponent : {e, e / 2, e > 0 ? 1 : -1}) add(decimal(1, exponent));
  return out;
}

/// Two edges of a box become r.
static void set_lengths(Solid& c, double r, double h) {
  if (is_box(c)) {
    c.edges = {r, r, h};
  } else if (!is_half_space(c)) {
    c.radius = r;
    c.height = h;
  }
}

Pairs shapes(const Pair& p) {
  Pairs out;
  for (const double r : {0.0, 1.0, 2.0})
    for (const double h : {0.0, 1.0, 2.0})
      for (const unsigned which : {3u, 1u, 2u})
        out.push_back(with(p, [&](Pair& q) {
          if (which & 1) set_lengths(q.a, r, h);
          if (which & 2) set_lengths(q.b, r, h);
        }));
  out.push_back(with(p, [&](Pair& q) {
    for (double* x : lengths(q))
      if (*x != 0) *x = std::ldexp(1, std::ilogb(*x));
  }));
  return out;
}

Pairs centres(const Pair& p) {
  Pairs out;
  const Vector3 delta = p.b.center - p.a.center;
  for (unsigned kept = 0; kept < 7; ++kept)
    out.push_back(with(p, [&](Pair& q) {
      for (unsigned i = 0; i < 3; ++i)
        if (!(kept >> i & 1)) q.b.center[i] = q.a.center[i];
    }));
  for (Eigen::Index i = 0; i < 3; ++i)
    out.push_back(with(p, [&](Pair& q) { q.b.center = q.a.center + delta.stableNorm() * Vector3::Unit(i); }));
  return out;
}

Pairs roundings(const Pair& p) {
  Pairs out;
  constexpr unsigned centre = 0b111, axis = 0xF038, lengths = 0xFC0;
  constexpr unsigned b = solid_number_count;
  for (const unsigned which : {~0u, centre << b, axis << b, axis, axis | axis << b, lengths | lengths << b,
                               lengths, lengths << b, lengths | lengths << b | centre << b}) {
    const auto add = [&](auto simpler) {
      out.push_back(with(p, [&](Pair& q) {
        const auto all = numbers(q);
        for (unsigned i = 0; i < all.size(); ++i)
          if (which >> i & 1) *all[i] = simpler(*all[i]);
      }));
    };
    add([](double x) { return std::round(x); });
    for (int digits = 1; digits < digit_cap; ++digits) add([&](double x) { return rounded(x, digits); });
  }
  return out;
}

Pairs one_number(const Pair& p, std::size_t which) {
  Pairs out;
  Pair copy = p;
  for (const double simpler : simpler_numbers(*numbers(copy)[which]))
    out.push_back(with(p, [&](Pair& q) { *numbers(q)[which] = simpler; }));
  return out;
}

Pairs equalities(const Pair& p) {
  Pairs out;
  Pair copy = p;
  const std::size_t count = lengths(copy).size();
  for (std::size_t i = 0; i < count; ++i) {
    out.push_back(with(p, [&](Pair& q) {
      for (double* x : lengths(q)) *x = *lengths(copy)[i];
    }));
    for (std::size_t j = 0; j < count; ++j)
      if (i != j) out.push_back(with(p, [&](Pair& q) { *lengths(q)[j] = *lengths(copy)[i]; }));
  }
  for (const auto& [from, to] : {std::pair{&Pair::a, &Pair::b}, std::pair{&Pair::b, &Pair::a}})
    out.push_back(with(p, [&, from = from, to = to](Pair& q) {
      const Solid& of = p.*from;
      (q.*to).radius = of.radius, (q.*to).height = of.height, (q.*to).rounding = of.rounding;
      (q.*to).edges = of.edges;
    }));
  return out;
}

}  // namespace cyl::moves
