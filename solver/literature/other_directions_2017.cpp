// SPDX-License-Identifier: MIT
// Section 7 and the end of section 8 of the text of 2017: any direction, found by minimising G. The text
// leaves two points open, and this file settles them.
//
// A cell is searched along its sides first, each a convex function of one variable. From the lowest point
// found there no line search ends on the boundary again, because G is higher there. So the minimiser may be
// one without constraints, and inside the cell G is smooth.
//
// A search ends if convexity proves that it is in vain. As G(y) >= G(x) + g.(y - x), G > 0 in the whole cell
// as soon as this bound is > 0 at its corners.
#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "solver/detail/frame.hpp"
#include "solver/literature/bisection.hpp"
#include "solver/literature/octant_2017.hpp"
#include "solver/literature/separation_2017.hpp"

namespace cyl::literature {
namespace {

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
