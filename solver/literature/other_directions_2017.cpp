// SPDX-License-Identifier: MIT
// Section 7 and the end of section 8 of the text of 2017: any direction, found by minimising G. G is f on the
// triangle that spans an octant of directions, and it is smooth in convex cells of that triangle. The text
// leaves two points open, and this file settles them.
//
// A cell is searched along its sides first, each a convex function of one variable. From the lowest point
// found there no line search ends on the boundary again, because G is higher there. So the minimiser may be
// one without constraints, and inside the cell G is smooth.
//
// A search ends if convexity proves that it is in vain. As G(y) >= G(x) + g.(y - x), G > 0 in the whole cell
// as soon as this bound is > 0 at its corners.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/detail/frame.hpp"
#include "solver/literature/bisection.hpp"
#include "solver/literature/separation_2017.hpp"

namespace cyl::literature {
namespace {

using Point = Eigen::Vector2d;  ///< (s, t)

/// Sign(L_0), Sign(L_1) in a cell; 0 is the sign at the point itself.
struct Signs {
  double l0 = 0, l1 = 0;
};

double own_sign(double given, double x) noexcept { return given != 0 ? given : x > 0 ? 1 : x < 0 ? -1 : 0; }

/// f on D(s, t) = s U + t V + (1-s-t) W, all coordinates with respect to (U, V, W), W along Delta. With the
/// signs of the octant in U and V.
struct Octant {
  Vector3 w0, w1;         ///< (a_i, b_i, c_i)
  double r0, h0, r1, h1;  ///< half heights
  double length;          ///< |Delta|
  bool printed_roots;     ///< Q_i = |D|^2 - L_i^2 as in the text
  bool printed_gradient;  ///< its 0/0 at an axis too

  static Vector3 at(const Point& x) noexcept { return {x.x(), x.y(), 1 - x.x() - x.y()}; }
  /// L_i, linear: D along axis i.
  double along(int i, const Point& x) const noexcept { return dot(at(x), i == 0 ? w0 : w1); }
  /// |P_i D(x)|.
  double across(int i, const Point& x) const noexcept { return cyl::length(at(x).cross(i == 0 ? w0 : w1)); }

  /// G with the given signs of the L_i, or their own signs if those are 0.
  double value(const Point& x, Signs signs) const noexcept {
    const Vector3 d = at(x);
    const double l0 = dot(d, w0), l1 = dot(d, w1);
    return r0 * eta(w0, d) + r1 * eta(w1, d) + h0 * own_sign(signs.l0, l0) * l0 +
           h1 * own_sign(signs.l1, l1) * l1 - d.z() * length;
  }

  /// A subgradient of value().
  Point gradient(const Point& x, Signs signs) const noexcept {
    const Vector3 d = at(x);
    const Vector3 g = rise(w0, r0, h0, signs.l0, d) + rise(w1, r1, h1, signs.l1, d);
    return {g.x() - g.z() + length, g.y() - g.z() + length};
  }

  /// The direction in which G falls most from the tip of the cone r_i |P_i D|, x = W_i or next to it.
  /// Without that term the gradient is g. 2 H is the second derivatives of Q_i. g.d/|P_i d| is least for H d
  /// = -g.
  Point off_axis(int i, const Point& x, Signs signs) const noexcept {
    Octant rest = *this;
    (i == 0 ? rest.r0 : rest.r1) = 0;
    const Point g = rest.gradient(x, signs);
    const Vector3& w = i == 0 ? w0 : w1;
    const double ac = w.x() - w.z(), bc = w.y() - w.z();
    const double ss = 2 - ac * ac, st = 1 - ac * bc,
                 tt = 2 - bc * bc;  // determinant (a+b+c)^2, >= 1 in the octant
    return {st * g.y() - tt * g.x(), st * g.x() - ss * g.y()};
  }

 private:
  double eta(const Vector3& w, const Vector3& d) const noexcept {
    if (!printed_roots) return cyl::length(d.cross(w));
    const double along = dot(d, w);
    return std::sqrt(dot(d, d) - along * along);
  }
  /// Returns the gradient of r |P D| + h Sign(L) D.W with respect to D.
  Vector3 rise(const Vector3& w, double r, double h, double sign, const Vector3& d) const noexcept {
    const double root = eta(w, d);
    const double side = own_sign(sign, dot(d, w));
    if (!(root > 0) && !printed_gradient) return h * side * w;  // the tip of a cone: 0 is a subgradient
    const Vector3 across = printed_roots ? Vector3(d - dot(d, w) * w) : w.cross(d.cross(w));
    return r / root * across + h * side * w;
  }
};

/// A convex polygon, anticlockwise: the triangle s, t >= 0, s + t <= 1, or the rest that lines cut off.
struct Cell {
  static constexpr int corner_cap = 5;  ///< a triangle and two cuts
  Point corners[corner_cap] = {{0, 0}, {1, 0}, {0, 1}};
  int count = 3;
  Signs signs;

  Point middle() const noexcept {
    Point sum(0, 0);
    for (int k = 0; k < count; ++k) sum += corners[k];
    return sum / count;
  }

  /// The part with `sign` L_i >= 0; false if its interior is empty.
  bool keep(const Octant& octant, int i, double sign) noexcept {
    Point kept[2 * corner_cap];
    int more = 0;
    bool inside = false;
    for (int k = 0; k < count; ++k) {
      const Point& from = corners[k];
      const Point& to = corners[(k + 1) % count];
      const double here = sign * octant.along(i, from), there = sign * octant.along(i, to);
      inside |= here > 0;
      if (here >= 0) kept[more++] = from;
      if (here * there < 0) kept[more++] = from + here / (here - there) * (to - from);
    }
    if (!inside) return false;
    count = std::min(more, corner_cap);
    std::copy_n(kept, count, corners);
    (i == 0 ? signs.l0 : signs.l1) = sign;
    return true;
  }

  /// The r for which x + r d is in the cell, x being in it.
  struct Interval {
    double low, high;
  };
  Interval chord(const Point& x, const Point& d) const noexcept {
    double low = -std::numeric_limits<double>::infinity(), high = -low;
    for (int k = 0; k < count; ++k) {
      const Point side = corners[(k + 1) % count] - corners[k], out = x - corners[k];
      const double room = std::max(0.0, side.x() * out.y() - side.y() * out.x());
      const double drift = side.x() * d.y() - side.y() * d.x();  // of the room, a unit of r
      if (drift > 0) low = std::max(low, -room / drift);
      if (drift < 0) high = std::min(high, room / -drift);
    }
    return {low, high};
  }
};

/// |P D| for |D| >= 3^-1/2 below which an axis counts as near: a line more, none less.
constexpr double near_axis_tol = 0x1p-3;

/// (U, V, W), W along Delta. U points to the axis that is farther from Delta, so the sides of octants run
/// through that axis. An axis along Delta then has the best direction on a side. By the text, any U will do.
struct Base {
  Base(const Couple<double>& p, bool any) noexcept : delta(p.dx, p.dy, p.dz) {
    const Vector3 w0(p.w0x, p.w0y, p.w0z), w1(p.w1x, p.w1y, p.w1z);
    length = cyl::length(delta);
    w = delta / length;
    const Vector3 v0 = w.cross(w0), v1 = w.cross(w1);
    v = dot(v0, v0) >= dot(v1, v1) ? v0 : v1;
    if (any) v = std::fabs(w.x()) > std::fabs(w.y()) ? Vector3(-w.z(), 0, w.x()) : Vector3(0, w.z(), -w.y());
    v /= cyl::length(v);
    u = v.cross(w);
  }
  Vector3 coordinates(const Vector3& x, double sign_u, double sign_v) const noexcept {
    return {sign_u * dot(x, u), sign_v * dot(x, v), dot(x, w)};
  }

  Vector3 delta, u, v, w;
  double length;
};

class CellSearch {
 public:
  CellSearch(const Couple<double>& p, const Base& base, double sign_u, double sign_v, const Octant& octant,
             const Cell& cell, const Options& options) noexcept
      : p_(p),
        base_(base),
        sign_u_(sign_u),
        sign_v_(sign_v),
        octant_(octant),
        cell_(cell),
        options_(options) {}

  Direction run() noexcept {
    const Point middle = cell_.middle();
    best_ = middle;
    step_to(middle);
    if (!found_ && !cannot_improve(middle)) {
      stay_ = options_.faults.has(Fault::stays_on_the_boundary);
      if (!stay_) search_sides();
      if (!stay_) leave_axes();
      if (!found_ && !ended_) conjugate_gradients();
    }
    return found_;
  }

 private:
  /// Steps to x. Returns whether D(x) separates. The lowest x is kept.
  bool step_to(const Point& x) noexcept {
    const double value = octant_.value(x, cell_.signs);
    if (value < lowest_) {
      lowest_ = value;
      best_ = x;
    }
    if (!below_zero(value, options_)) return false;
    const Vector3 d = Octant::at(x);
    const Vector3 direction = sign_u_ * d.x() * base_.u + sign_v_ * d.y() * base_.v + d.z() * base_.w;
    if (!options_.literal && !below_zero(f(p_, direction), options_)) return false;
    found_ = direction;
    return true;
  }

  Point gradient(const Point& x) const noexcept { return octant_.gradient(x, cell_.signs); }

  /// G > 0 in the whole cell, by its tangent plane in x.
  bool cannot_improve(const Point& x) const noexcept {
    if (options_.literal) return false;
    const Point g = gradient(x);
    const double value = octant_.value(x, cell_.signs);
    for (int k = 0; k < cell_.count; ++k)
      if (!(value + g.dot(cell_.corners[k] - x) > 0)) return false;
    return true;
  }

  /// The line search of section 8 on x + r d, low <= r <= high. best_ is the lowest point of all steps so
  /// far. Returns whether it ended at `low` or `high`.
  bool search_line(const Point x, const Point d, double low, double high) noexcept {
    if (step_to(x + low * d) || step_to(x + high * d)) return true;
    const auto slope = [&](double r) { return d.dot(gradient(x + r * d)); };
    if (slope(low) >= 0 || slope(high) <= 0) return true;
    bisect(
        low, high, d.norm(), options_, [&](double r) { return step_to(x + r * d); }, slope);
    return false;
  }

  void search_sides() noexcept {
    for (int k = 0; k < cell_.count && !found_; ++k)
      search_line(cell_.corners[k], cell_.corners[(k + 1) % cell_.count] - cell_.corners[k], 0, 1);
  }

  /// Next to the tip of a cone the gradient is of no use. One line has to be tried.
  void leave_axes() noexcept {
    for (int i = 0; i < 2 && !found_; ++i)
      if (octant_.across(i, best_) < near_axis_tol) descend(octant_.off_axis(i, best_, cell_.signs));
  }

  /// Searches one line of a minimiser, from best_. Returns false if the search is over: separated, not
  /// lower, or in vain.
  bool descend(const Point& d) noexcept {
    const double before = lowest_;
    const Cell::Interval chord = cell_.chord(best_, d);
    if (!(chord.low <= chord.high && std::isfinite(chord.high - chord.low))) return false;
    const bool at_end = search_line(best_, d, chord.low, chord.high);
    if (found_) return false;
    if (at_end && stay_) {
      search_sides();
      ended_ = true;
      return false;
    }
    return lowest_ < before;
  }

  void conjugate_gradients() noexcept {
    Point g = gradient(best_), d = -g;
    bool steepest = true;
    for (int line = 0; line < options_.line_cap; ++line) {
      if (!descend(d)) {
        if (found_ || ended_ || steepest) return;
        d = -g;
        steepest = true;
        continue;
      }
      if (cannot_improve(best_)) return;
      const Point next = gradient(best_);
      const double beta = next.dot(next - g) / g.dot(g);  // Polak and Ribiere
      steepest = !(beta > 0 && (beta * d - next).dot(next) < 0);
      d = steepest ? Point(-next) : Point(beta * d - next);
      g = next;
    }
  }

  const Couple<double>& p_;
  const Base& base_;
  const double sign_u_, sign_v_;
  const Octant& octant_;
  const Cell& cell_;
  const Options& options_;
  bool stay_ = false, ended_ = false;
  Point best_{0, 0};
  double lowest_ = std::numeric_limits<double>::infinity();
  Direction found_;
};

}  // namespace

Direction separated_by_other_directions(const Couple<double>& p, const Options& options) noexcept {
  const Faults faults = options.faults;
  const Base base(p, options.literal || faults.has(Fault::one_octant));
  const Vector3 w0(p.w0x, p.w0y, p.w0z), w1(p.w1x, p.w1y, p.w1z);
  for (int i = 0; i < (faults.has(Fault::one_octant) ? 1 : 4); ++i) {
    const double sign_u = i == 0 || i == 3 ? 1 : -1, sign_v = i < 2 ? 1 : -1;
    const Octant octant{base.coordinates(w0, sign_u, sign_v),
                        base.coordinates(w1, sign_u, sign_v),
                        p.r0,
                        p.h0,
                        p.r1,
                        p.h1,
                        base.length,
                        faults.has(Fault::cancelling_root),
                        faults.has(Fault::division_by_vanished_root)};
    const auto search = [&](const Cell& cell) {
      return CellSearch(p, base, sign_u, sign_v, octant, cell, options).run();
    };
    if (faults.has(Fault::kinks_taken_for_smooth)) {
      if (const Direction d = search(Cell())) return d;
      continue;
    }
    for (double sign0 : {1.0, -1.0}) {
      Cell half;
      if (!half.keep(octant, 0, sign0)) continue;
      for (double sign1 : {1.0, -1.0}) {
        Cell cell = half;
        if (!cell.keep(octant, 1, sign1)) continue;
        if (const Direction d = search(cell)) return d;
      }
    }
  }
  return {};
}

}  // namespace cyl::literature
