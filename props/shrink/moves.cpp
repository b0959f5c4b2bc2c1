// SPDX-License-Identifier: MIT
#include "props/shrink/moves.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <numeric>
#include <string>
#include <utility>

#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/referee/referee.hpp"
#include "props/shrink/complexity.hpp"

namespace cyl::moves {
namespace {

/// Sine of the angle below which axes are also tried as an axis and a little beside it.
constexpr double near_sine_margin = 1e-2;
/// Newton steps towards a distance. The distance is smooth in a number except at kinks, which end the steps.
constexpr int newton_cap = 8;
/// Relative to a distance that is to be kept. A pair farther from it is not asked about.
constexpr double kept_part_tol = 0.25;
constexpr int digit_cap = 17;  ///< all that a double has

/// Returns the nearest double of units * 10^exponent, or 0 if that is out of range.
double decimal(long long units, int exponent) {
  const std::string text = std::to_string(units) + 'e' + std::to_string(exponent);
  double x = 0;
  return std::from_chars(text.data(), text.data() + text.size(), x).ec == std::errc() ? x : 0;
}

double rounded(double x, int digits) {
  char text[40];
  const char* end = std::to_chars(text, text + sizeof text, x, std::chars_format::scientific, digits - 1).ptr;
  double y = 0;
  return std::from_chars(text, end, y).ec == std::errc() ? y : x;
}

Vector3 rounded(const Vector3& v, int digits) {
  return v.unaryExpr([&](double x) { return rounded(x, digits); });
}

std::array<double*, 2 * solid_number_count> numbers(Pair& p) {
  std::array<double*, 2 * solid_number_count> all;
  std::ranges::copy(numbers_of(p.b), std::ranges::copy(numbers_of(p.a), all.begin()).out);
  return all;
}

/// Returns the lengths of both solids. Roundings come last, so that they can be left out if both are 0.
std::vector<double*> lengths(Pair& p) {
  std::vector<double*> all{&p.a.radius, &p.a.height, &p.b.radius, &p.b.height};
  if (is_rounded(p)) all.insert(all.end(), {&p.a.rounding, &p.b.rounding});
  return all;
}

/// Returns a changed copy.
template <class Change>
Pair with(Pair p, Change change) {
  change(p);
  return p;
}

// distance = max over unit D of D.(b - a) - (support of both). Its derivative by a number x is that of D.(b
// - a) or of the support at the D that attains the maximum. It is D_i for b's centre and -1 for a
// rounding. It is minus the sine of the angle between D and the axis for a radius, and minus half the cosine
// for a height.
double slope(const MeasuredDistance& d, const Pair& p, std::size_t which) {
  if (which < 3) return d.direction[static_cast<Eigen::Index>(which)];
  if (which > 6) return (which == 7 ? p.a : p.b).rounding == 0 ? 0 : -1;  // a solid stays without rounding
  const Solid& c = which < 5 ? p.a : p.b;
  const Vector3 w = c.axis.stableNormalized();
  return which % 2 == 1 ? -d.direction.cross(w).norm() : -std::fabs(d.direction.dot(w)) / 2;
}

/// Turns the scene so that `up` is the z axis and `side` lies in the plane y = 0.
struct Frame {
  Eigen::Matrix3d turn;
  Frame(const Vector3& up, const Vector3& side) {
    const Vector3 z = up.stableNormalized();
    const Vector3 y = z.cross(side.stableNormalized()).stableNormalized();
    turn << y.cross(z).transpose(), y.transpose(), z.transpose();
  }
};

/// Returns w divided by its length, its largest and its smallest coordinate.
std::vector<Vector3> multiples(const Vector3& w) {
  std::vector<Vector3> out{w.stableNormalized()};
  double least = w.cwiseAbs().maxCoeff();
  out.push_back(w / least);
  for (const double x : w)
    if (x != 0) least = std::min(least, std::fabs(x));
  out.push_back(w / least);
  return out;
}

Vector3 smallest_multiple(const Vector3& integers) {
  long long common = 0;
  for (const double x : integers) common = std::gcd(common, static_cast<long long>(x));
  return common == 0 ? integers : Vector3(integers / static_cast<double>(common));
}

/// Returns directions of small integers near w, the simplest first, and w itself at other lengths.
std::vector<Vector3> near_axes(const Vector3& w) {
  std::vector<Vector3> out;
  const Vector3 unit = w / w.cwiseAbs().maxCoeff();
  for (const double most : {1, 2, 3, 4, 8, 16})
    out.push_back(smallest_multiple((most * unit).array().round()));
  std::ranges::copy(multiples(w), std::back_inserter(out));
  out.push_back(w / std::ldexp(1, std::ilogb(w.cwiseAbs().maxCoeff())));
  return out;
}

/// For nearly parallel axes: adds a simpler axis, and a copy with a power of ten in one coordinate.
void add_nearly_parallel(const Pair& p, Pairs& out) {
  const Vector3 wa = p.a.axis.stableNormalized(), wb = p.b.axis.stableNormalized();
  const double sine = wa.cross(wb).norm();
  if (!(sine > 0 && sine < near_sine_margin)) return;
  const int e = decimal_of(sine).exponent;
  std::vector<Vector3> bases = near_axes(p.a.axis);
  bases.insert(bases.end(), {Vector3::UnitX(), Vector3::UnitY(), Vector3::UnitZ()});
  for (const Vector3& a : bases) {
    Eigen::Index most = 0;
    a.cwiseAbs().maxCoeff(&most);
    for (const int exponent : {e, e + 1})
      for (const Eigen::Index i : {(most + 1) % 3, (most + 2) % 3})
        out.push_back(with(p, [&](Pair& q) {
          q.a.axis = a;
          q.b.axis = a + decimal(1, exponent) * Vector3::Unit(i);
        }));
  }
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
  Pair copy = p;
  const std::size_t end = 3 + lengths(copy).size();
  for (const auto& [first, last] : {std::pair<std::size_t, std::size_t>{0, 3}, {3, end}}) {
    std::size_t best = first;
    for (std::size_t i = first; i < last; ++i)
      if (std::fabs(slope(now, p, i)) > std::fabs(slope(now, p, best))) best = i;
    Pair q = p;
    double& x = best < 3 ? q.b.center[static_cast<Eigen::Index>(best)] : *lengths(q)[best - 3];
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

Pairs frames(const Pair& p) {
  Pairs out;
  const Vector3 n = approximate_distance(p).direction, delta = p.b.center - p.a.center;
  const auto add = [&](const Vector3& up, const Vector3& side) {
    const Frame frame(up, side);
    if (!frame.turn.allFinite()) return;
    // Coordinates meant to be 0 become 0. Otherwise rounding would leave them with 17 digits.
    const auto turned = [&](const Vector3& v) {
      Vector3 t = frame.turn * v;
      if (v == up || v == -up) t.head<2>().setZero();
      if (v == side || v == -side) t.y() = 0;
      return t;
    };
    for (const Vector3& axis_a : multiples(turned(p.a.axis)))
      for (const Vector3& axis_b : multiples(turned(p.b.axis)))
        out.push_back(with(p, [&](Pair& q) {
          q.a.axis = axis_a;
          q.b.axis = axis_b;
          q.a.center = turned(p.a.center);
          q.b.center = p.a.center.isZero(0) ? turned(delta) : turned(p.b.center);
        }));
  };
  for (const Vector3& side : {p.b.axis, delta}) add(p.a.axis, side);
  for (const Vector3& side : {p.a.axis, delta}) add(p.b.axis, side);
  for (const Vector3& side : {p.a.axis, p.b.axis}) add(n, side);
  return out;
}

Pairs symmetries(const Pair& p) {
  Pairs out;
  std::array<Eigen::Index, 3> order{0, 1, 2};
  do
    for (unsigned mirror = 0; mirror < 8; ++mirror)
      out.push_back(with(p, [&](Pair& q) {
        for (Solid* c : {&q.a, &q.b})
          for (Vector3* v : {&c->center, &c->axis}) {
            const Vector3 from = *v;
            for (unsigned i = 0; i < 3; ++i) (*v)[i] = (mirror >> i & 1 ? -1 : 1) * from[order[i]];
          }
      }));
  while (std::ranges::next_permutation(order).found);
  for (unsigned which = 1; which < 16; ++which)
    out.push_back(with(p, [&](Pair& q) {
      if (which & 1) q.a.axis = -q.a.axis;
      if (which & 2) q.b.axis = -q.b.axis;
      if (which & 4) std::swap(q.a, q.b);
      if (which & 8) std::swap(q.a.center, q.b.center);
    }));
  // Zeros get no minus sign.
  for (Pair& q : out)
    for (double* x : numbers(q)) *x += 0.0;
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

Pairs shapes(const Pair& p) {
  Pairs out;
  for (const double r : {0.0, 1.0, 2.0})
    for (const double h : {0.0, 1.0, 2.0})
      for (const unsigned which : {3u, 1u, 2u})
        out.push_back(with(p, [&](Pair& q) {
          if (which & 1) q.a.radius = r, q.a.height = h;
          if (which & 2) q.b.radius = r, q.b.height = h;
        }));
  out.push_back(with(p, [&](Pair& q) {
    for (double* x : lengths(q))
      if (*x != 0) *x = std::ldexp(1, std::ilogb(*x));
  }));
  return out;
}

Pairs axes(const Pair& p) {
  Pairs out;
  const auto tried_for = [](const Vector3& axis) {
    std::vector<Vector3> all{axis};
    std::ranges::copy(near_axes(axis), std::back_inserter(all));
    for (Eigen::Index i = 0; i < 3; ++i) all.push_back(Vector3::Unit(i));
    return all;
  };
  const std::vector<Vector3> for_a = tried_for(p.a.axis), for_b = tried_for(p.b.axis);
  const auto add = [&](const Vector3& a, const Vector3& b) {
    out.push_back(with(p, [&](Pair& q) { q.a.axis = a, q.b.axis = b; }));
  };
  for (const Vector3& a : for_a) add(a, p.b.axis);
  for (const Vector3& b : for_b) add(p.a.axis, b);
  for (std::size_t i = 1; i < std::min(for_a.size(), for_b.size()); ++i) add(for_a[i], for_b[i]);
  for (Eigen::Index i = 0; i < 3; ++i)
    for (Eigen::Index j = 0; j < 3; ++j) add(Vector3::Unit(i), Vector3::Unit(j));
  add(p.a.axis, p.a.axis);
  add(p.b.axis, p.b.axis);
  add_nearly_parallel(p, out);
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
    }));
  return out;
}

}  // namespace cyl::moves
