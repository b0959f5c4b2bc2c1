// SPDX-License-Identifier: MIT
// The moves that turn solids or the scene.
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>
#include <vector>

#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/touch_plane.hpp"
#include "oracles/referee/referee.hpp"
#include "props/shrink/complexity.hpp"
#include "props/shrink/moves.hpp"

namespace cyl::moves {
namespace {

/// Sine of the angle below which axes are also tried as an axis and a little beside it.
constexpr double near_sine_margin = 1e-2;
/// An element of a rotation nearer to 0, 1 or -1 becomes that.
constexpr double element_tol = 0x1p-50;

/// Turns the scene so that `up` is the z axis and `side` lies in the plane y = 0.
struct Frame {
  Eigen::Matrix3d turn;
  Frame(const Vector3& up, const Vector3& side) {
    const Vector3 z = up.stableNormalized();
    const Vector3 y = z.cross(side.stableNormalized()).stableNormalized();
    turn << y.cross(z).transpose(), y.transpose(), z.transpose();
  }
};

/// Returns v divided by its length, its largest and its smallest element.
template <class Vector>
std::vector<Vector> multiples(const Vector& v) {
  std::vector<Vector> out{v.stableNormalized()};
  double least = v.cwiseAbs().maxCoeff();
  out.push_back(v / least);
  for (const double x : v)
    if (x != 0) least = std::min(least, std::fabs(x));
  out.push_back(v / least);
  return out;
}

template <class Vector>
Vector smallest_multiple(const Vector& integers) {
  long long common = 0;
  for (const double x : integers) common = std::gcd(common, static_cast<long long>(x));
  return common == 0 ? integers : Vector(integers / static_cast<double>(common));
}

/// Returns small integers nearly in the proportions of v, the simplest first, and v itself at other lengths.
template <class Vector>
std::vector<Vector> near_proportions(const Vector& v) {
  std::vector<Vector> out;
  const Vector unit = v / v.cwiseAbs().maxCoeff();
  for (const double most : {1, 2, 3, 4, 8, 16})
    out.push_back(smallest_multiple(Vector((most * unit).array().round())));
  std::ranges::copy(multiples(v), std::back_inserter(out));
  out.push_back(v / std::ldexp(1, std::ilogb(v.cwiseAbs().maxCoeff())));
  return out;
}

using Quaternion = Eigen::Vector4d;  // w x y z
Quaternion quaternion(const Solid& box) { return Quaternion(box.quaternion.data()); }

Solid with_axis(Solid c, const Vector3& axis) {
  c.axis = axis;
  return c;
}
Solid with_quaternion(Solid c, const Quaternion& q) {
  std::ranges::copy(q, c.quaternion.begin());
  return c;
}

std::vector<Solid> with_axes(const Solid& c, const std::vector<Vector3>& axes) {
  std::vector<Solid> out;
  for (const Vector3& w : axes) out.push_back(with_axis(c, w));
  return out;
}
std::vector<Solid> with_quaternions(const Solid& c, const std::vector<Quaternion>& all) {
  std::vector<Solid> out;
  for (const Quaternion& q : all) out.push_back(with_quaternion(c, q));
  return out;
}

/// The axis, or two directions of edges.
std::vector<Vector3> directions(const Solid& c) {
  if (!is_box(c)) return {c.axis};
  return {edge_direction(c, 2), edge_direction(c, 0)};
}

/// Returns q p, the rotation that turns by p first.
Quaternion product(const Quaternion& q, const Quaternion& p) {
  const auto& [w, x, y, z] = std::array{q[0], q[1], q[2], q[3]};
  return {w * p[0] - x * p[1] - y * p[2] - z * p[3], w * p[1] + x * p[0] + y * p[3] - z * p[2],
          w * p[2] - x * p[3] + y * p[0] + z * p[1], w * p[3] + x * p[2] - y * p[1] + z * p[0]};
}

/// Returns the same box, up to rounding, with its edges in another order.
std::vector<Solid> reordered(const Solid& box) {
  std::vector<Solid> out;
  for (const std::array<std::size_t, 3>& order :
       {std::array<std::size_t, 3>{1, 2, 0}, {2, 0, 1}, {1, 0, 2}, {0, 2, 1}, {2, 1, 0}}) {
    // The new first edge is the old one of order[0], and so on. An odd order turns by a quarter about the
    // edge that stays.
    Quaternion p(1, 1, 1, 1);
    for (std::size_t i = 0; i < 3; ++i)
      if (order[i] == i) p = {1, i == 0 ? 1.0 : 0.0, i == 1 ? 1.0 : 0.0, i == 2 ? 1.0 : 0.0};
    if (order[0] == 2 && order[1] == 0) p = {1, -1, -1, -1};
    Solid c = box;
    for (std::size_t i = 0; i < 3; ++i) c.edges[i] = box.edges[order[i]];
    std::ranges::move(with_quaternions(c, multiples(product(quaternion(box), p))), std::back_inserter(out));
  }
  return out;
}

/// Returns the solid in other directions: near ones of few digits, then the simplest.
std::vector<Solid> turned(const Solid& c) {
  std::vector<Solid> all{c};
  const auto add = [&](const std::vector<Solid>& some) { std::ranges::copy(some, std::back_inserter(all)); };
  if (is_box(c)) {
    add(with_quaternions(c, near_proportions(quaternion(c))));
    add(with_quaternions(
        c, {{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 0, 1, 0}, {1, 0, 0, 1}, {1, 1, 1, 1}, {1, -1, -1, -1}}));
    add(reordered(c));
  } else {
    add(with_axes(c, near_proportions(c.axis)));
    add(with_axes(c, {Vector3::UnitX(), Vector3::UnitY(), Vector3::UnitZ()}));
  }
  return all;
}

/// For nearly parallel axes: adds a simpler axis, and a copy with a power of ten in one coordinate.
void add_nearly_parallel(const Pair& p, Pairs& out) {
  const Vector3 wa = p.a.axis.stableNormalized(), wb = p.b.axis.stableNormalized();
  const double sine = wa.cross(wb).norm();
  if (has_box(p) || !(sine > 0 && sine < near_sine_margin)) return;
  const int e = decimal_of(sine).exponent;
  std::vector<Vector3> bases = near_proportions(p.a.axis);
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

/// For a box at a small angle from the coordinate axes: adds the simplest quaternion, with a power of ten in
/// one element.
void add_nearly_level(const Pair& p, Pairs& out) {
  for (Solid Pair::*which : {&Pair::a, &Pair::b}) {
    if (!is_box(p.*which)) continue;
    const Quaternion q = quaternion(p.*which) / quaternion(p.*which).cwiseAbs().maxCoeff();
    const Quaternion whole = q.array().round();
    Eigen::Index most = 0;
    const double rest = (q - whole).cwiseAbs().maxCoeff(&most);
    if (!(rest > 0 && rest < near_sine_margin)) continue;
    const int e = decimal_of(rest).exponent;
    for (const int exponent : {e, e + 1})
      for (Eigen::Index i = 0; i < 4; ++i)
        out.push_back(with(p, [&](Pair& r) {
          r.*which = with_quaternion(p.*which, whole + decimal(1, exponent) * Quaternion::Unit(i));
        }));
  }
}

/// Reverses the direction: an axis, or the sign of a quaternion, which turns the same.
void reverse(Solid& c) {
  if (is_box(c))
    for (double& x : c.quaternion) x = -x;
  else
    c.axis = -c.axis;
}

}  // namespace

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
    const auto turned_solids = [&](const Solid& c) {
      if (!is_box(c)) return with_axes(c, multiples(turned(c.axis)));
      std::array<Vector3, 3> columns;
      for (std::size_t i = 0; i < 3; ++i)
        columns[i] = turned(edge_direction(c, i)).unaryExpr([](double x) {
          return std::fabs(x - std::round(x)) < element_tol ? std::round(x) : x;
        });
      const auto q = quaternion_of(columns);
      return with_quaternions(c, multiples(Quaternion(q.data())));
    };
    const std::vector<Solid> all_b = turned_solids(p.b);
    for (const Solid& a : turned_solids(p.a))
      for (const Solid& b : all_b)
        out.push_back(with(p, [&](Pair& q) {
          q = {a, b};
          q.a.center = turned(p.a.center);
          q.b.center = p.a.center.isZero(0) ? turned(delta) : turned(p.b.center);
        }));
  };
  const std::vector<Vector3> of_a = directions(p.a), of_b = directions(p.b);
  for (const auto& [own, others] : {std::pair(of_a, of_b), std::pair(of_b, of_a)})
    for (const Vector3& up : own) {
      for (const Vector3& side : others) add(up, side);
      add(up, delta);
      for (const Vector3& side : own)
        if (side != up) add(up, side);
    }
  for (const auto& sides : {of_a, of_b})
    for (const Vector3& side : sides) add(n, side);
  return out;
}

Pairs symmetries(const Pair& p) {
  Pairs out;
  Eigen::Vector3i order(0, 1, 2);
  do
    for (unsigned mirrored = 0; mirrored < 8; ++mirrored) {
      const Vector3 signs(mirrored & 1 ? -1.0 : 1.0, mirrored & 2 ? -1.0 : 1.0, mirrored & 4 ? -1.0 : 1.0);
      out.push_back({image(p.a, order, signs), image(p.b, order, signs)});
    }
  while (std::next_permutation(order.begin(), order.end()));
  for (unsigned which = 1; which < 16; ++which)
    out.push_back(with(p, [&](Pair& q) {
      if (which & 1) reverse(q.a);
      if (which & 2) reverse(q.b);
      if (which & 4) std::swap(q.a, q.b);
      if (which & 8) std::swap(q.a.center, q.b.center);
    }));
  // A half turn about an edge leaves a box as it is.
  for (Solid Pair::*which : {&Pair::a, &Pair::b})
    for (Eigen::Index i = 1; is_box(p.*which) && i < 4; ++i)
      for (const double sign : {1, -1})
        out.push_back(with(p, [&](Pair& q) {
          q.*which = with_quaternion(p.*which, product(quaternion(p.*which), sign * Quaternion::Unit(i)));
        }));
  // Zeros get no minus sign.
  for (Pair& q : out)
    for (double* x : numbers(q)) *x += 0.0;
  return out;
}

Pairs axes(const Pair& p) {
  Pairs out;
  const std::vector<Solid> for_a = turned(p.a), for_b = turned(p.b);
  const auto add = [&](const Solid& a, const Solid& b) { out.push_back({a, b}); };
  for (const Solid& a : for_a) add(a, p.b);
  for (const Solid& b : for_b) add(p.a, b);
  for (std::size_t i = 1; i < std::min(for_a.size(), for_b.size()); ++i) add(for_a[i], for_b[i]);
  const auto simplest = [](const Solid& c) {
    if (is_box(c)) return with_quaternions(c, {{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 1, 1, 1}});
    return with_axes(c, {Vector3::UnitX(), Vector3::UnitY(), Vector3::UnitZ()});
  };
  for (const Solid& a : simplest(p.a))
    for (const Solid& b : simplest(p.b)) add(a, b);
  if (is_box(p.a) && is_box(p.b)) {
    add(p.a, with_quaternion(p.b, quaternion(p.a)));
    add(with_quaternion(p.a, quaternion(p.b)), p.b);
  } else if (!has_box(p)) {
    add(p.a, with_axis(p.b, p.a.axis));
    add(with_axis(p.a, p.b.axis), p.b);
  }
  add_nearly_parallel(p, out);
  add_nearly_level(p, out);
  return out;
}

}  // namespace cyl::moves
