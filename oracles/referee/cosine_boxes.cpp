// SPDX-License-Identifier: MIT
// Let t_i = D.w_i be the cosines between a direction D and the axes, and s(t) = sqrt(1 - t^2). Then
//     f(D) = sum (h_i |t_i| + r_i s(t_i)) - D.delta.
// In a box of cosines of fixed signs, all terms except s(t_i) are linear in D. s is concave. So for any
// slope k, s(t) >= k t + c, if c is the lesser of s - k t at the two ends of the interval. Hence
//     f(D) >= sum r_i c_i + z.D,   z = sum (+-h_i + r_i k_i) w_i - delta,
// with the secant's slope as k. This is exact at the corners of the box, which include the kinks of f (t = 0
// and t = +-1). Elsewhere it is short by the square of the box's width. Duality bounds the least z.D in the
// box. If l_i >= 0, let b_i be the lower end of interval i, else the upper end. Then
//     z.D >= -|z - l_0 w_0 - l_1 w_1| + l_0 b_0 + l_1 b_1.
// Every l gives a valid bound, so a poor choice of l does no harm. l is chosen so that the right side is
// least at a D in the box. Then l is 0, or D is on one side of the box, or at a corner. If no D has both
// cosines of a corner, and l has the right signs there, the box is empty.
//
// The frame is (w_0, e, n), with n along w_0 x w_1 towards b. c and q are the cosine and sine between the
// axes. A direction is (x, y, v), with t_0 = x and t_1 = c x + q y. If v >= 0, f is at most as great at D as
// at its mirror image with -v. So only that half is searched.
//
// A local minimum closes the boxes that hold the least value. Its bound is exact on a cap
// (direction_bounds.cpp). For the cap about D* = alpha w_0 + beta w_1 + v* n,
//     D*.D = alpha t_0 + beta t_1 + v* v(t).
// v(t) is concave, because it is the square root of a concave function. So the least value is at a corner of
// the box if all four exist. Otherwise it is at least that of the linear part.
#include "oracles/referee/cosine_boxes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>

namespace cyl {
namespace {

/// The least sine between the axes. Below it, boxes as small as the angle between the axes would be needed.
constexpr double least_tilt_tol = 0x1p-20;
/// Cap on slopes, and on multipliers relative to the reach. Above it, rounding loses more than they gain.
constexpr double slope_cap = 0x1p20;
/// The rounding error of a bound, for each unit of |l_i| or r_i |k_i|. There are fewer than 16 operations.
constexpr double term_error = 16 * 0x1p-53;
/// The cosine of the widest cap in which a local minimum is tried as a bound.
constexpr double widest_cap_cosine = 0.5;
/// A box is split at a kink of the other solid that lies at least this far inside, relative to its width.
constexpr double kink_share = 0x1p-6;
/// Boxes below this width start a search for another local minimum, up to this number of minima.
constexpr double small_box_tol = 0.05;
constexpr std::size_t minima_cap = 4;
/// A local minimum is searched for on a kink within this sine.
constexpr double kink_sine = 0x1p-12;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// An interval of one cosine, which has one sign. It holds s at its ends, and the secant of s between them.
struct Interval1 {
  double low, high, sine_low, sine_high, slope, intercept;
};

double sine_of(double t) { return std::sqrt((1 - t) * (1 + t)); }

Interval1 interval(double low, double sine_low, double high, double sine_high) {
  const double slope = std::clamp((sine_high - sine_low) / (high - low), -slope_cap, slope_cap);
  return {low, high, sine_low, sine_high, slope, std::min(sine_low - slope * low, sine_high - slope * high)};
}

struct Box {
  std::array<Interval1, 2> t;
  double below;
  double x, y, v;  ///< the direction at which its bound is attained
  bool operator<(const Box& o) const { return below > o.below; }  // the least bound first
};

class Boxes {
 public:
  Boxes(const DirectionBounds& bounds, const SearchPair<double>& p, LeastValue& least)
      : bounds_(bounds), least_(least), radius_{p.radius0, p.radius1}, half_{p.half0, p.half1} {
    w0_ = normalized(p.axis0);
    const Vec w1 = normalized(p.axis1);
    c_ = dot(w0_, w1);
    tilt_ = length(cross(w0_, w1));
    const Vec rest = normalized(w1 - c_ * w0_);
    e_ = normalized(rest - dot(rest, w0_) * w0_);  // restores the right angle, which the difference may lose
    n_ = cross(w0_, e_);
    if (dot(n_, p.delta) < 0) n_ = -1.0 * n_;
    q_ = dot(e_, w1);
    inverse_q_ = 1 / q_;
    delta_ = {dot(p.delta, w0_), dot(p.delta, e_), dot(p.delta, n_)};
  }

  void search() {
    // Not q_: if the axes differ by less than the rounding of their lengths, e_ is along them.
    if (tilt_ < least_tilt_tol) return;
    const Interval1 positive = interval(0, 1, 1, 0), negative = interval(-1, 0, 0, 1);
    for (const Interval1& t0 : {positive, negative})
      for (const Interval1& t1 : {positive, negative}) add({{t0, t1}, -infinity, 0, 0, 0});
    better_ = true;
    while (!is_done() && boxes_ < cosine_box_cap) {
      if (better_) find_minimum(least_.direction, 0);
      Box box = queue_.top();
      queue_.pop();
      close_by_minima(box);
      if (!is_closed(box)) split(box);
    }
    least_.cells += boxes_;
    least_.floor_at(std::min({closed_, least_.best, queue_.empty() ? infinity : queue_.top().below}));
  }

 private:
  struct Minimum {
    LocalMinimum at;
    double alpha, beta, v;
  };

  bool is_done() const {
    return least_.is_found() || queue_.empty() || queue_.top().below >= least_.best - least_.width;
  }

  bool is_closed(const Box& box) {
    if (box.below < least_.best - least_.width) return false;
    closed_ = std::min(closed_, box.below);
    return true;
  }

  double value(double x, double y, double v) const {
    const double t1 = c_ * x + q_ * y, out = q_ * x - c_ * y;
    return half_[0] * std::fabs(x) + half_[1] * std::fabs(t1) + radius_[0] * std::sqrt(y * y + v * v) +
           radius_[1] * std::sqrt(out * out + v * v) - (x * delta_[0] + y * delta_[1] + v * delta_[2]);
  }

  void add(Box box) {
    ++boxes_;
    bound(box);
    if (is_closed(box)) return;
    const double f = value(box.x, box.y, box.v);
    if (f < least_.best) {
      better_ = true;
      least_.take(f, box.x * w0_ + box.y * e_ + box.v * n_);
    }
    queue_.push(box);
  }

  void bound(Box& box) const;

  void find_minimum(const Vec& from, std::size_t slot) {
    Minimum& m = minima_[slot];
    m.at = bounds_.minimum_near(from, kink_sine);
    const Vec& d = m.at.direction;
    m.v = dot(d, n_);
    m.beta = dot(d, e_) * inverse_q_;
    m.alpha = dot(d, w0_) - c_ * m.beta;
    least_.floor_at(-m.at.nearest);
    least_.take(m.at.f, d);
    count_ = std::max(count_, slot + 1);
    better_ = false;
  }

  /// Cosine of a cap about the minimum that holds the box.
  double cap_cosine(const Box& box, const Minimum& m) const {
    constexpr double error = 0x1p-44;  // relative to 1 / q
    if (m.v < -error) return -1;
    double linear = 1, all = 1;
    for (const double b0 : {box.t[0].low, box.t[0].high})
      for (const double b1 : {box.t[1].low, box.t[1].high}) {
        const double y = (b1 - c_ * b0) * inverse_q_, left = 1 - b0 * b0 - y * y;
        const double part = m.alpha * b0 + m.beta * b1;
        linear = std::min(linear, part);
        all = std::min(all, left > 0 ? part + m.v * std::sqrt(left) : -1);
      }
    return std::max(all, linear) - error * inverse_q_;
  }

  void close_by(const Minimum& m, Box& box) const {
    const double cosine = cap_cosine(box, m);
    if (!(cosine > widest_cap_cosine)) return;
    const double sine = sine_of(cosine) * (1 + 0x1p-40);
    box.below = std::max(box.below, bounds_.bound_near(m.at, {m.at.direction, cosine, sine}));
  }

  void close_by_minima(Box& box) {
    const auto is_open = [&] { return box.below < least_.best - least_.width; };
    for (std::size_t i = 0; i < count_ && is_open(); ++i) close_by(minima_[i], box);
    const auto is_small = [](const Interval1& t) { return t.high - t.low < small_box_tol; };
    if (!is_open() || count_ == minima_cap || !is_small(box.t[0]) || !is_small(box.t[1])) return;
    find_minimum(box.x * w0_ + box.y * e_ + box.v * n_, count_);
    close_by(minima_[count_ - 1], box);
  }

  /// Halves the angle of the interval whose secant is farther from s, or splits it at the other axis.
  void split(const Box& box) {
    std::array<double, 2> at{}, at_sine{}, gap{};
    for (std::size_t i = 0; i < 2; ++i) {
      const Interval1& t = box.t[i];
      const double a = t.low + t.high, b = t.sine_low + t.sine_high, size = std::sqrt(a * a + b * b);
      at[i] = a / size;
      at_sine[i] = b / size;
      gap[i] = radius_[i] * (at_sine[i] - t.slope * at[i] - t.intercept);
      const double least = kink_share * (t.high - t.low);
      for (const double kink : {c_, -c_})
        if (kink - t.low > least && t.high - kink > least) at[i] = kink, at_sine[i] = q_;
      if (!(at[i] > t.low && at[i] < t.high)) gap[i] = -1;
    }
    const std::size_t i = gap[0] >= gap[1] ? 0 : 1;
    if (gap[i] < 0) {
      closed_ = std::min(closed_, box.below);
      return;
    }
    const Interval1& t = box.t[i];
    Box lower = box, upper = box;
    lower.t[i] = interval(t.low, t.sine_low, at[i], at_sine[i]);
    upper.t[i] = interval(at[i], at_sine[i], t.high, t.sine_high);
    add(lower);
    add(upper);
  }

  const DirectionBounds& bounds_;
  LeastValue& least_;
  const std::array<double, 2> radius_, half_;
  Vec w0_, e_, n_;
  double tilt_, c_, q_, inverse_q_;
  std::array<double, 3> delta_;  ///< in the frame
  std::priority_queue<Box> queue_;
  std::array<Minimum, minima_cap> minima_;
  std::size_t count_ = 0;
  std::size_t boxes_ = 0;
  bool better_ = false;       ///< whether `best` improved after the last local minimum
  double closed_ = infinity;  ///< the least bound of boxes that are not in the queue any more
};

/// The dual bound of one box.
class Dual {
 public:
  Dual(Box& box, double c, double q, double inverse_q, double za, double zb, double dn, double cap)
      : box_(box), c_(c), q_(q), inverse_q_(inverse_q), za_(za), zb_(zb), dn_(dn), cap_(cap) {}

  double least() {
    at(0, 0);
    const int side0 = side(0, box_.x), side1 = side(1, c_ * box_.x + q_ * box_.y);
    if (side0 != 0 && side1 == 0) {
      if (const int other = on_side(0, side0); other != 0 && !at_corner(side0, other)[0]) on_side(1, other);
    } else if (side1 != 0 && side0 == 0) {
      if (const int other = on_side(1, side1); other != 0 && !at_corner(other, side1)[1]) on_side(0, other);
    } else if (side0 != 0) {
      const int beyond1 = on_side(0, side0), beyond0 = beyond1 == 0 ? 0 : on_side(1, side1);
      if (beyond0 != 0) {
        at_corner(side0, side1);
        if (beyond1 != side1) at_corner(side0, beyond1);
        if (beyond0 != side0) at_corner(beyond0, side1);
      }
    }
    return best_;
  }

 private:
  /// Returns 1 below the interval, -1 above it, and 0 inside.
  int side(std::size_t i, double t) const { return t < box_.t[i].low ? 1 : t > box_.t[i].high ? -1 : 0; }

  /// Tries the bound with l_0 w_0 + l_1 w_1 = (m0, m1) in the frame.
  void at(double m0, double m1) {
    const double l1 = m1 * inverse_q_, l0 = m0 - c_ * l1;
    const double b0 = l0 > 0 ? box_.t[0].low : box_.t[0].high, b1 = l1 > 0 ? box_.t[1].low : box_.t[1].high;
    const double a = za_ - m0, b = zb_ - m1, z = std::sqrt(a * a + b * b + dn_ * dn_);
    const double error = std::fabs(m0) + std::fabs(m1) * (1 + (std::fabs(b0) + std::fabs(b1)) * inverse_q_);
    const double below = -z + m0 * b0 + m1 * ((b1 - c_ * b0) * inverse_q_) - term_error * error;
    if (!(below > best_)) return;
    best_ = below;
    const double scale = z > 0 ? 1 / z : 0;
    box_.x = -a * scale;
    box_.y = -b * scale;
    box_.v = z > 0 ? dn_ * scale : 1;
  }

  /// Returns on which side of the other interval the least D is.
  int on_side(std::size_t i, int from) {
    const Interval1& t = box_.t[i];
    const double b = from > 0 ? t.low : t.high, s = from > 0 ? t.sine_low : t.sine_high;
    const double along = i == 0 ? za_ : c_ * za_ + q_ * zb_, beside = i == 0 ? zb_ : q_ * za_ - c_ * zb_;
    const double out = std::sqrt(beside * beside + dn_ * dn_);
    const double l = std::clamp(along + (s > 0 ? b * (out / s) : b * cap_), -cap_, cap_);
    i == 0 ? at(l, 0) : at(c_ * l, q_ * l);
    return side(1 - i, c_ * b - (out > 0 ? beside / out * s : 0) * q_);
  }

  /// Returns whether each multiplier has the sign that the side calls for.
  std::array<bool, 2> at_corner(int side0, int side1) {
    const double b0 = side0 > 0 ? box_.t[0].low : box_.t[0].high,
                 b1 = side1 > 0 ? box_.t[1].low : box_.t[1].high;
    const double y = (b1 - c_ * b0) * inverse_q_, left = 1 - b0 * b0 - y * y;
    const double z = left > 0 ? std::min(cap_, dn_ / std::sqrt(left)) : 0;
    const double m0 = left > 0 ? za_ + z * b0 : b0, m1 = left > 0 ? zb_ + z * y : y;
    const double l1 = m1 * inverse_q_, l0 = m0 - c_ * l1;
    const std::array<bool, 2> right{l0 * side0 >= 0, l1 * side1 >= 0};
    if (!right[0] || !right[1]) return right;
    const double error = 0x1p-48 * (1 + (std::fabs(b0) + std::fabs(b1)) * inverse_q_ * (1 + std::fabs(y)));
    if (left > 0) at(m0, m1);
    if (left < -error) best_ = infinity;
    return right;
  }

  Box& box_;
  const double c_, q_, inverse_q_, za_, zb_, dn_, cap_;
  double best_ = -infinity;
};

void Boxes::bound(Box& box) const {
  double constant = 0, error = 0;
  std::array<double, 2> along{};
  for (std::size_t i = 0; i < 2; ++i) {
    const Interval1& t = box.t[i];
    constant += radius_[i] * t.intercept;
    along[i] = (t.low < 0 ? -half_[i] : half_[i]) + radius_[i] * t.slope;
    error += radius_[i] * std::fabs(t.slope);
  }
  const double za = along[0] + c_ * along[1] - delta_[0], zb = q_ * along[1] - delta_[1];
  Dual dual(box, c_, q_, inverse_q_, za, zb, delta_[2], slope_cap * bounds_.reach());
  box.below = std::max(box.below, constant + dual.least() - term_error * error);
}

}  // namespace

void narrow_by_cosines(const DirectionBounds& bounds, const SearchPair<double>& p, LeastValue& least) {
  Boxes(bounds, p, least).search();
}

}  // namespace cyl
