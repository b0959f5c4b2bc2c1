// SPDX-License-Identifier: MIT
// 1. The plane. Every y = x - delta with x in K bounds f from below by the plane D.y. Let theta be the angle
//    between y and D0. On a cap of angle rho about D0 the least value of that bound is
//     min D.y = |y| cos(theta + rho).
// Take y as the support point of D0. If f is smooth, the bound is then short by the square of rho only.
//
// 2. Kinks. f has kinks on the great circles perpendicular to either axis, because the support point jumps
//    along the solid's length. It also has kinks at the axes, because the support point jumps across the cap.
//    Near a kink, the cap is widened until its middle lies on the kink. There every point of that edge or
//    disk is a support point. The one that makes y most nearly parallel to D0 is taken. That bound is short
//    by the square of rho again.
//
// 3. Local minima. Near a local minimum D0 of f a better bound holds, so the search need not use up all
//    digits. Let D = D0 cos a + x, with x perpendicular to D0, |x| = sin a and a <= rho. For the disk of
//    solid i, let n_i be the unit vector from its axis to D0, and t_i the unit vector perpendicular to both.
//
// 3.1. The part of D perpendicular to the axis is A n_i + (t_i.x) t_i with A = D.n_i. Its length L is A +
// (t_i.x)^2 / (L + A). Let L_i be the greatest L on the cap. L + A is at most 2 L_i. On the circle of solid i
// D0 is n_i, and L + A is at most 1 + cos a.
//
// 3.2. Let y be the support point of D0, and g its part perpendicular to D0. Then D.y = f(D0) cos a + g.x and
// cos a = 1 - |x|^2 / (1 + cos a). So
//     f(D) >= f(D0) + g.x + c x.Qx/2,   Q = -f(D0) I + sum r_i/M_i t_i t_i^T,   c = 2 / (1 + cos a).
// On the circle M_i = 1, else M_i = L_i k with k = 2 / (1 + cos rho). c lies between 1 and k. So parts that
// bend down count k times.
//
// 3.3. A kink at D0 adds room. On the circle of solid i the support point may slide by p w_i, |p| <= h_i. p
// is chosen so that g loses its part along w_i. The rest of h_i, b = h_i - |p|, adds b |w_i.x|. On both
// circles that is at least min(b_0, b_1) |x| times the sine between the axes. At the axis of solid i a vector
// c of its disk takes g away. Then r_i - |c| is left, times |x|.
//
// 3.4. Let m be the least eigenvalue of Q, and least(g, q) the least of g x + c q x^2 / 2 over |x| <= sin
// rho. g_a and q_a are taken along the eigenvectors of Q. Then f is at least f(D0) +
//   No kink:            least(g_0, q_0) + least(g_1, q_1).
//   One circle,         least(g_1, Q_11) + sin rho min(0, b - |g_0| - k sin rho (|Q_01| + max(0, -Q_00)/2)),
//     e_0 = w_i, e_1 along it.
//   Room b everywhere:  sin rho min(0, b - |g| - k sin rho max(0, -m)/2).
//
// 3.5. Newton's method along the smooth directions first makes g vanish. If it does, and f is convex or there
// is room, the bound is f(D0) itself. If f is nearly flat along a valley, little is lost along it and nothing
// across.
#include "oracles/referee/direction_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace cyl {
namespace {

/// Rounding of Q, relative to the largest of its terms: fewer than 30 operations, and those that find its
/// eigenvalues. A direction n_i that is itself a little off costs nothing: the bound holds for any.
constexpr double curvature_error = 64 * 0x1p-53;
constexpr int newton_cap = 8;
/// Cosine of the angle to an axis; its half height times this is what is lost.
constexpr double on_circle_tol = 0x1p-50;
constexpr double shortest_step_tol = 0x1p-6;  ///< of Newton's; shorter ones are not worth their cost

Vec across(const Vec& v, const Vec& d) { return v - dot(v, d) * d; }

// The cap about `middle` that holds `cap`. Returns false if it is too wide to help (near a right angle).
bool widen(const Cap& cap, const Vec& middle, Cap& out) {
  const double c = std::min(1.0, dot(cap.center, middle)), s = length(cross(cap.center, middle));
  out = {middle, cap.cosine * c - cap.sine * s, cap.sine * c + cap.cosine * s};
  return out.cosine > 0.1;
}

}  // namespace

/// Which kinks of f a direction lies on, by solid: the circle square to its axis, or the axis.
struct DirectionBounds::Kinks {
  std::array<bool, 2> on_circle{}, at_axis{};
  /// Whether there is no other such direction nearby.
  bool are_a_point() const { return (on_circle[0] && on_circle[1]) || at_axis[0] || at_axis[1]; }
  bool one_circle() const { return on_circle[0] != on_circle[1] && !are_a_point(); }
};

/// A model of f near one direction D0, built on a support point y of D0: the one nearest to the line along
/// D0 if there are several.
struct DirectionBounds::Model {
  Vec direction, y, g;
  double f;                               ///< f(D0)
  double value;                           ///< D0.y: f(D0) except for a loss at an axis
  double room = 0;                        ///< b
  double unsure = 0;                      ///< that the room is worth less, since D0 lies beside the circle
  std::array<double, 2> t{}, s{};         ///< cosine and sine of the angles to the axes
  std::array<std::optional<Vec>, 2> out;  ///< n_i; none at the axis
};

DirectionBounds::DirectionBounds(const SearchPair<double>& p)
    : solids_{Terms<double>{normalized(p.axis0), p.radius0, p.half0},
              Terms<double>{normalized(p.axis1), p.radius1, p.half1}},
      delta_(p.delta) {
  const Vec n = cross(solids_[0].axis, solids_[1].axis);
  tilt_ = length(n);
  normal_ = normalized(n);
  reach_ = p.radius0 + p.half0 + p.radius1 + p.half1 + length(p.delta);
}

std::array<Vec, 3> DirectionBounds::likely() const {
  std::array<Vec, 3> all{solids_[0].axis, solids_[1].axis, normal_};
  for (Vec& d : all)
    if (dot(d, delta_) < 0) d = -1.0 * d;
  return all;
}

double DirectionBounds::value(const Vec& d) const {
  return core_support(solids_[0], d) + core_support(solids_[1], d) - dot(d, delta_);
}

// The sum of the least values of f's terms, each by the range of the angle to its axis or to delta.
double DirectionBounds::term_by_term(const Cap& cap) const {
  const double along = dot(cap.center, delta_), beside = length(cross(cap.center, delta_));
  const bool holds_delta = beside * cap.cosine < along * cap.sine;
  double below = -(holds_delta ? length(delta_) : along * cap.cosine + beside * cap.sine);
  for (const Terms<double>& s : solids_) {
    const double t = std::fabs(dot(cap.center, s.axis)), u = length(cross(cap.center, s.axis));
    const double up = u * cap.cosine - t * cap.sine, down = t * cap.cosine - u * cap.sine;  // sine, cosine
    // h cos + r sin of an angle up to a right one is least at the ends of its range.
    const double nearer = up <= 0 ? s.half : s.half * (t * cap.cosine + u * cap.sine) + s.radius * up;
    const double farther = down <= 0 ? s.radius : s.half * down + s.radius * (u * cap.cosine + t * cap.sine);
    below += std::min(nearer, farther);
  }
  return below;
}

Bounds DirectionBounds::bounds(const Cap& cap, double enough) const {
  constexpr double unknown = std::numeric_limits<double>::infinity();
  if (const double below = term_by_term(cap); below >= enough) return {below, unknown, unknown, cap.center};
  Bounds best = plane(cap, {});
  auto consider = [&](const Vec& middle, const Kinks& kinks) {
    Cap moved;
    // not covered: a cap of the first cells has 36 degrees and holds its middle, and twice 36 is less than 84
    if (best.below >= enough || !widen(cap, middle, moved)) return;
    const Bounds b = plane(moved, kinks);
    best.below = std::max(best.below, b.below);
    if (b.value < best.value) {
      best.value = b.value;
      best.direction = b.direction;
    }
    best.nearest = std::min(best.nearest, b.nearest);
  };
  for (std::size_t i = 0; i < 2; ++i) {
    const Vec& w = solids_[i].axis;
    const double t = dot(cap.center, w);
    if (std::fabs(t) <= cap.sine) consider(normalized(across(cap.center, w)), {{i == 0, i == 1}, {}});
    const Vec pole = t < 0 ? -1.0 * w : w;
    if (length(cross(cap.center, pole)) <= cap.sine) {
      consider(pole, {{}, {i == 0, i == 1}});
      // Axes nearly parallel: both poles lie in the cap.
      if (length(cross(pole, solids_[1 - i].axis)) <= cap.sine) consider(pole, {{}, {true, true}});
    }
  }
  return best;
}

/// Two directions square to D0 and each other; on one circle the second is along it.
struct DirectionBounds::Frame {
  Vec e0, e1;
};

/// Q's eigenvalues, and the directions that belong to them.
struct DirectionBounds::Principal {
  double least, greatest;
  Vec at_least, at_greatest;
};

DirectionBounds::Model DirectionBounds::model(const Vec& d, const Kinks& kinks) const {
  Model m;
  m.direction = d;
  m.y = -1.0 * delta_;
  m.f = -dot(d, delta_);
  for (std::size_t i = 0; i < 2; ++i) {
    const Terms<double>& solid = solids_[i];
    m.t[i] = dot(d, solid.axis);
    const Vec radial = d - m.t[i] * solid.axis;
    m.s[i] = length(radial);
    m.f += solid.half * std::fabs(m.t[i]) + solid.radius * m.s[i];
    if (!kinks.on_circle[i]) m.y = m.y + (m.t[i] < 0 ? -solid.half : solid.half) * solid.axis;
    if (kinks.at_axis[i] || m.s[i] == 0) continue;
    // Near the axis the difference has lost digits. It is made perpendicular to the axis again, or the point
    // would leave the rim. If nearly all digits were lost, the middle of the cap serves.
    const Vec flat = across(normalized(radial), solid.axis);
    const double kept = length(flat);
    if (!(kept > 0.5)) continue;
    m.out[i] = (1 / kept) * flat;
    m.y = m.y + solid.radius * *m.out[i];
  }
  m.g = across(m.y, d);
  const auto& [on_circle, at_axis] = kinks;
  std::array<double, 2> along{dot(m.g, solids_[0].axis), dot(m.g, solids_[1].axis)}, left{};
  if (on_circle[0] && on_circle[1]) {
    // Divided by the tilt twice, because its square may underflow.
    const double c = dot(solids_[0].axis, solids_[1].axis);
    along = {(along[0] - c * along[1]) / tilt_ / tilt_, (along[1] - c * along[0]) / tilt_ / tilt_};
  }
  for (std::size_t i = 0; i < 2; ++i) {
    const Terms<double>& solid = solids_[i];
    if (!on_circle[i]) continue;
    const double slid = std::clamp(along[i], -solid.half, solid.half);
    left[i] = solid.half - std::fabs(slid);
    m.y = m.y - slid * solid.axis;
    m.g = m.g - slid * across(solid.axis, d);
    m.unsure += left[i] * std::fabs(m.t[i]);
  }
  double at_axes = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    const Terms<double>& solid = solids_[i];
    if (!at_axis[i]) continue;
    const Vec off = across(m.g, solid.axis);
    const double size = length(off), part = size > solid.radius ? solid.radius / size : 1;
    m.y = m.y - part * off;
    m.g = m.g - part * off;
    at_axes += solid.radius - part * size;
  }
  m.room = at_axis[0] || at_axis[1]       ? at_axes
           : on_circle[0] && on_circle[1] ? std::min(left[0], left[1]) * tilt_
                                          : left[0] + left[1];
  m.value = dot(m.y, d);
  m.g = m.y - m.value * d;
  return m;
}

Bounds DirectionBounds::plane(const Cap& cap, const Kinks& kinks) const {
  const Model m = model(cap.center, kinks);
  const double beside = length(m.g), size = length(m.y);
  // theta + rho beyond a half turn: the plane's least value is -|y|.
  const bool past = beside * cap.cosine + m.value * cap.sine < 0;
  return {past ? -size : m.value * cap.cosine - beside * cap.sine, m.f, size, cap.center};
}

// Q as above with q in place of -f(D0). `longest` is M_i. The result is Q_00, Q_01, Q_11.
std::array<double, 3> DirectionBounds::curvature(const Model& m, const Frame& frame, double q,
                                                 const std::array<double, 2>& longest) const {
  std::array<double, 3> sum{q, 0, q};
  for (std::size_t i = 0; i < 2; ++i) {
    if (!m.out[i]) continue;
    const Vec turn = cross(*m.out[i], solids_[i].axis);
    const double x = dot(turn, frame.e0), y = dot(turn, frame.e1);
    const double weight = solids_[i].radius / longest[i];
    sum[0] += weight * x * x;
    sum[1] += weight * x * y;
    sum[2] += weight * y * y;
  }
  return sum;
}

DirectionBounds::Principal DirectionBounds::principal(const Frame& at, const std::array<double, 3>& q) {
  const double half = (q[0] - q[2]) / 2, away = std::sqrt(half * half + q[1] * q[1]),
               middle = (q[0] + q[2]) / 2;
  // There are two forms of the eigenvector. This is the one that loses no digits.
  double x = half > 0 ? half + away : q[1], y = half > 0 ? q[1] : away - half;
  // If eigenvalues differ by less than this, far below rounding, any two directions serve.
  constexpr double alike_tol = 0x1p-450;
  const double size = std::sqrt(x * x + y * y);
  x = size > alike_tol ? x / size : 1;
  y = size > alike_tol ? y / size : 0;
  return {middle - away, middle + away, x * at.e1 - y * at.e0, x * at.e0 + y * at.e1};
}

DirectionBounds::Frame DirectionBounds::frame(const Vec& d, const Kinks& kinks) const {
  Vec e0 = across(solids_[kinks.on_circle[1] ? 1 : 0].axis, d);
  // Any two directions serve off the circles.
  if (!(length(e0) > 0.1)) e0 = square_to(d);
  e0 = normalized(e0);
  return {e0, cross(d, e0)};
}

// Newton's method on the sphere, or along one circle. Each step is shortened until f becomes less, and ends
// no farther than `most` from its start. If f is flat or bends down, it stays.
DirectionBounds::Model DirectionBounds::settle(const Vec& start, const Kinks& kinks, double most) const {
  const bool one_circle = kinks.one_circle();
  Model m = model(start, kinks);
  for (int step = 0; step < newton_cap && !kinks.are_a_point(); ++step) {
    const Frame at = frame(m.direction, kinks);
    const auto step_along = [&](const Vec& e, double q) {
      return q > 0 ? std::clamp(-dot(m.g, e) / q, -most, most) : 0;
    };
    const auto [q00, q01, q11] = curvature(m, at, -m.value, m.s);
    const auto [least, greatest, at_least, at_greatest] = principal(at, {q00, q01, q11});
    const Vec x =
        one_circle ? step_along(at.e1, q11) * at.e1
                   : step_along(at_least, least) * at_least + step_along(at_greatest, greatest) * at_greatest;
    const double far = length(x);
    if (!(far > 0x1p-52)) return m;
    bool less = false;
    for (double part = 1; !less && part >= shortest_step_tol; part /= 4) {
      Vec d = normalized(m.direction + part * x);
      for (std::size_t i = 0; i < 2; ++i)
        if (kinks.on_circle[i]) d = normalized(across(d, solids_[i].axis));
      const Model next = model(d, kinks);
      if (!(next.value < m.value)) continue;
      less = true;
      m = next;
      most -= part * far;
    }
    if (!less || most <= 0 || far < 0x1p-27) return m;  // the next step would be its square
  }
  return m;
}

double DirectionBounds::bound_near(const Model& m, const Kinks& kinks, const Cap& cap) const {
  std::array<double, 2> longest{1, 1};
  for (std::size_t i = 0; i < 2; ++i)
    if (const double t = std::fabs(m.t[i]); t > cap.sine) longest[i] = m.s[i] * cap.cosine + t * cap.sine;
  const double most = 2 / (1 + cap.cosine);
  for (std::size_t i = 0; i < 2; ++i)
    if (!kinks.on_circle[i]) longest[i] *= most;
  const Frame at = frame(m.direction, kinks);
  const std::array<double, 3> q = curvature(m, at, -m.value, longest);
  const double rounding = bound_error * reach_,
               error = curvature_error * (reach_ + std::fabs(q[0]) + std::fabs(q[2]));
  // The least of g.x + c q x^2 / 2 along e, |x| no more than the cap's sine.
  const auto least_along = [&](const Vec& e, double bend) {
    const double slope = std::fabs(dot(m.g, e)) + rounding, sure = bend - error;
    return sure > 0 && slope < sure * cap.sine
               ? -slope * slope / (2 * sure)
               : (std::min(sure, most * sure) * cap.sine / 2 - slope) * cap.sine;
  };
  const double value = m.value - m.unsure;
  const auto lost = [&](double room) { return std::min(0.0, room - rounding) * cap.sine; };
  if (kinks.one_circle())
    return value + least_along(at.e1, q[2]) +
           lost(m.room - std::fabs(dot(m.g, at.e0)) -
                most * cap.sine * (std::fabs(q[1]) + error + std::max(0.0, error - q[0]) / 2));
  const auto [least, greatest, at_least, at_greatest] = principal(at, q);
  if (kinks.are_a_point())
    return value + lost(m.room - length(m.g) - most * cap.sine / 2 * std::max(0.0, error - least));
  return value + least_along(at_least, least) + least_along(at_greatest, greatest);
}

// Tries the kinks near `start` in turn, then none, until the bound is good enough.
Bounds DirectionBounds::bounds_by_minimum(const Cap& cap, const Vec& start, double enough,
                                          double width) const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Bounds best{-infinity, infinity, infinity, start};
  const auto consider = [&](const Vec& from, const Kinks& kinks) {
    const Model m = settle(from, kinks, 2 * cap.sine);
    if (m.f < best.value) {
      best.value = m.f;
      best.direction = m.direction;
    }
    best.nearest = std::min(best.nearest, length(m.y));
    Cap moved;
    if (widen(cap, m.direction, moved)) best.below = std::max(best.below, bound_near(m, kinks, moved));
    return best.below >= std::min(enough, best.value - width);
  };
  const auto is_near = [&](const Vec& d) { return length(cross(start, d)) <= cap.sine; };
  const auto towards = [&](const Vec& d) { return dot(start, d) < 0 ? -1.0 * d : d; };
  for (std::size_t i = 0; i < 2; ++i)
    if (const Vec pole = towards(solids_[i].axis); is_near(pole)) {
      // Square axes: the pole of one lies on the circle of the other.
      const bool crossed = std::fabs(dot(pole, solids_[1 - i].axis)) <= on_circle_tol;
      if (consider(pole, {{crossed && i == 1, crossed && i == 0}, {i == 0, i == 1}})) return best;
    }
  if (const Vec normal = towards(normal_); is_near(normal) && consider(normal, {{true, true}, {}}))
    return best;
  for (std::size_t i = 0; i < 2; ++i)
    if (std::fabs(dot(start, solids_[i].axis)) <= cap.sine &&
        consider(normalized(across(start, solids_[i].axis)), {{i == 0, i == 1}, {}}))
      return best;
  consider(start, {});
  return best;
}

}  // namespace cyl
