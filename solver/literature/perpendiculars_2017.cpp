// SPDX-License-Identifier: MIT
// Section 6 of the text of 2017: the directions perpendicular to W0, two quarter circles.
#include <cmath>

#include "solver/detail/frame.hpp"
#include "solver/literature/bisection.hpp"
#include "solver/literature/separation_2017.hpp"

namespace cyl::literature {
namespace {

double sign_of(double x) noexcept { return x > 0 ? 1 : x < 0 ? -1 : 0; }

/// The circle (1-t) U0 + t V0 or (t-1) U0 + t V0 and who looks for F < 0 on it.
class Circle {
 public:
  Circle(const Couple<double>& p, const Options& options) noexcept : p_(p), options_(options) {
    const Vector3 w0(p.w0x, p.w0y, p.w0z), w1(p.w1x, p.w1y, p.w1z), delta(p.dx, p.dy, p.dz);
    const double c1 = dot(w0, w1);
    double b1;
    if (options.faults.has(Fault::cancelling_sine)) {
      b1 = std::sqrt(1 - c1 * c1);
      v0_ = (w1 - c1 * w0) / b1;
      u0_ = v0_.cross(w0);
    } else {
      const Axes axes(w0, w1);
      b1 = std::sqrt(axes.square);
      u0_ = axes.cross * (std::copysign(1.0, -axes.cosine) / b1);  // Axes turns w1 towards w0
      v0_ = w0.cross(u0_);
    }
    quarter_ = {p.r0, p.r1, p.h1 * b1, c1 * c1, dot(delta, u0_), dot(delta, v0_)};
  }

  enum class End : unsigned char { separated, nothing, nothing_at_the_ends };

  /// Searches one quarter for F < 0. F has a kink if Delta is square to some D(t), that is if a2 and b2
  /// differ in sign. Otherwise F is convex. With a kink the ends are enough. Let a2 > 0 > b2. Before the
  /// kink F(t) >= (1-t) F(0), behind it F(t) >= t F(1), since |P_i D| is at least (1-t) |P_i U0| and t |P_i
  /// V0|.
  End search() noexcept {
    if (separates(0) || separates(1)) return End::separated;
    if (slope(0) >= 0 || slope(1) <= 0) return End::nothing_at_the_ends;
    if (quarter_.sign(0) != quarter_.sign(1) && !options_.faults.has(Fault::kink_taken_for_convex))
      return End::nothing;
    return find_between() ? End::separated : End::nothing;
  }

  /// On to the quarter from -U0 to V0.
  void turn() noexcept {
    u0_ = -u0_;
    quarter_.a2 = -quarter_.a2;
  }

  Vector3 direction() const noexcept { return (1 - t_) * u0_ + t_ * v0_; }

 private:
  bool separates(double t) noexcept {
    t_ = t;
    const double value = quarter_.value(t);
    if (!below_zero(value, options_)) return false;
    return options_.literal || below_zero(f(p_, direction()), options_);
  }

  double slope(double t) const noexcept {
    return options_.faults.has(Fault::division_by_vanished_root) ? quarter_.printed_slope(t)
                                                                 : quarter_.slope(t);
  }

  bool find_between() noexcept {
    return bisect(
        0, 1, 1, options_, [&](double t) { return separates(t); }, [&](double t) { return slope(t); });
  }

  const Couple<double>& p_;
  const Options& options_;
  Vector3 u0_, v0_;
  Quarter quarter_;
  double t_ = 0;
};

}  // namespace

double Quarter::value(double t) const noexcept {
  const double u = 1 - t;
  return r0 * std::sqrt(u * u + t * t) + r1 * std::sqrt(u * u + c1_square * t * t) + h1b1 * t -
         std::fabs(u * a2 + t * b2);
}

double Quarter::sign(double t) const noexcept { return sign_of((1 - t) * a2 + t * b2); }

double Quarter::slope(double t) const noexcept {
  const double u = 1 - t, root0 = std::sqrt(u * u + t * t), root1 = std::sqrt(u * u + c1_square * t * t);
  const double fall = root1 > 0 ? (c1_square * t - u) / root1 : -1;
  return r0 * (2 * t - 1) / root0 + r1 * fall + h1b1 - (b2 - a2) * sign(t);
}

double Quarter::printed_slope(double t) const noexcept {
  const double u = 1 - t;
  return r0 * (2 * t - 1) / std::sqrt(u * u + t * t) +
         r1 * ((1 + c1_square) * t - 1) / std::sqrt(u * u + c1_square * t * t) + h1b1 - (b2 - a2) * sign(t);
}

Direction separated_by_cylinder_perpendiculars(const Couple<double>& p, const Options& options) noexcept {
  Circle circle(p, options);
  Circle::End end = circle.search();
  if (end == Circle::End::separated) return circle.direction();
  if (end == Circle::End::nothing_at_the_ends && options.faults.has(Fault::first_quarter_ends_all)) return {};
  circle.turn();
  if (circle.search() == Circle::End::separated) return circle.direction();
  return {};
}

}  // namespace cyl::literature
