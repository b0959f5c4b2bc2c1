// SPDX-License-Identifier: MIT
// Whether no direction that points to two rims is lower than one that is known. For distance.cpp alone.
// Symbols as in distance.md, section 6.
#pragma once

#include <cmath>

#include "solver/detail/distance_rims.hpp"

namespace cyl {

inline constexpr int patch_box_cap = 5;  // boxes looked at of one pair of rims; one is usual

// Up to there axes count as square.
inline constexpr double square_cosine = 0.125;

// The range of a number.
struct ValueRange {
  double low, high;

  bool is_empty() const noexcept { return !(low <= high); }
  double middle() const noexcept { return 0.5 * (low + high); }
  double width() const noexcept { return high - low; }
  double least_size() const noexcept { return larger(0, larger(low, -high)); }
  double most_size() const noexcept { return larger(-low, high); }
};
inline ValueRange operator+(ValueRange a, ValueRange b) noexcept { return {a.low + b.low, a.high + b.high}; }
inline ValueRange operator*(double a, ValueRange b) noexcept {
  return a < 0 ? ValueRange{a * b.high, a * b.low} : ValueRange{a * b.low, a * b.high};
}
inline ValueRange both_of(ValueRange a, ValueRange b) noexcept {
  return {larger(a.low, b.low), smaller(a.high, b.high)};
}

// For solids that overlap. If f is least inside the patch of a rim of each solid, then y = -f D with 0 <= f
// <= most. That leaves a box of the rims' coordinates along m0 and m1, often none.
class PatchSearch {
  // The ranges of the two points, along m0 and along m1.
  struct Box {
    ValueRange q0, q1;
  };

 public:
  // `error`: of every length compared here.
  PatchSearch(const Scaled& p, const TurnedFrame& f, double most, double error) noexcept
      : p_(p), f_(f), error_(error), inverse_(1 / f.s) {
    lower(most);
  }

  // To a depth less than before.
  void lower(double most) noexcept {
    most_ = most;
    const double room = p_.r0 + p_.r1 - most;  // D.n <= z/(r0 + r1 - f)
    most_n_ = f_.z < room ? most * (f_.z / room) : most;
  }

  // Whether no D with D.w0 of the sign side0 and D.w1 of the sign side1 has f <= most; if not, it may be in
  // the boxes left.
  bool is_above(double side0, double side1) noexcept {
    side0_ = side0;
    side1_ = side1;
    e0_ = f_.e0 - side1 * p_.h1 * f_.s;
    e1_ = f_.e1 - side0 * p_.h0 * f_.s;
    l0_ = f_.d0 - side0 * p_.h0 - side1 * p_.h1 * f_.c;
    l1_ = f_.d1 - side1 * p_.h1 - side0 * p_.h0 * f_.c;
    const ValueRange depth = {-error_, most_ + error_};
    boxes_[0] = {both_of({-p_.r0, p_.r0}, inverse_ * (ValueRange{l1_, l1_} + side1 * depth)),
                 both_of({-p_.r1, p_.r1}, inverse_ * (ValueRange{l0_, l0_} + side0 * depth))};
    left_ = 0;
    if (boxes_[0].q0.is_empty() || boxes_[0].q1.is_empty()) return true;
    left_ = 1;
    for (int i = 0; i < patch_box_cap && left_ > 0; ++i) {
      const Box box = boxes_[--left_];
      if (is_above(box)) continue;
      Box half = box, other = box;
      if (box.q0.width() > box.q1.width())
        half.q0.high = other.q0.low = box.q0.middle();
      else
        half.q1.high = other.q1.low = box.q1.middle();
      boxes_[left_++] = half;
      boxes_[left_++] = other;
    }
    return left_ == 0;
  }

  // Takes the middle of the next remaining box that is not above the known depth; false if there is
  // none.
  bool next_open(Rims& open) noexcept {
    while (left_ > 0) {
      const Box& box = boxes_[--left_];
      if (is_above(box)) continue;
      open = {side0_, side1_, 1, 0, 1, 0};
      turn_to(p_.r0, box.q0, open.x0, open.y0);
      turn_to(p_.r1, box.q1, open.x1, open.y1);
      return true;
    }
    return false;
  }

  // A search ended there, and so much is known now: what its box and those beside it may hold lower was
  // found. Away from square axes a second minimum in one patch is too rare to be worth another search.
  void close_around(const Rims& found, double low) noexcept {
    if (!(std::fabs(f_.c) <= square_cosine)) left_ = 0;
    if (left_ == 0) return;
    lower(low);
    const auto is_near = [](ValueRange q, double at) { return std::fabs(at - q.middle()) <= q.width(); };
    int kept = 0;
    for (int i = 0; i < left_; ++i)
      if (!is_near(boxes_[i].q0, p_.r0 * found.y0) || !is_near(boxes_[i].q1, p_.r1 * found.y1))
        boxes_[kept++] = boxes_[i];
    left_ = kept;
  }

 private:
  static void turn_to(double r, ValueRange q, double& x, double& y) noexcept {
    y = r > 0 ? q.middle() / r : 0;
    x = std::sqrt(larger(0, (1 - y) * (1 + y)));
  }

  static double along_n(double r, double q) noexcept {
    const double size = smaller(r, q);
    return std::sqrt((r - size) * (r + size));
  }

  // First the tests that exclude half of the boxes, then the rest at once, because branch predictors cannot
  // predict which of them excludes a box.
  bool is_above(const Box& box) const noexcept {
    const auto& [q0, q1] = box;
    ValueRange p0{along_n(p_.r0, q0.most_size()), 0}, p1{along_n(p_.r1, q1.most_size()), 0};
    ValueRange n{p0.low + p1.low - f_.z, 0};  // -y.n = f D.n
    if (n.low > most_n_ + error_) return true;
    p0.high = along_n(p_.r0, q0.least_size());
    p1.high = along_n(p_.r1, q1.least_size());
    n.high = p0.high + p1.high - f_.z;
    const double most = most_ + error_;
    const ValueRange m0 = ValueRange{e0_, e0_} + (-1 * q0) + f_.c * q1,
                     m1 = ValueRange{e1_, e1_} + f_.c * q0 + (-1 * q1);
    const ValueRange w0 = ValueRange{l0_, l0_} + (-f_.s) * q1, w1 = ValueRange{l1_, l1_} + (-f_.s) * q0;
    const double square = larger(square_of(m0) + square_of(w0), square_of(m1) + square_of(w1)) + square_of(n);
    return (n.high < -error_) | (square > most * most) | is_askew(p_.r0, p0, q0, n, m0) |
           is_askew(p_.r1, p1, q1, n, m1);
  }

  static double square_of(ValueRange x) noexcept { return x.least_size() * x.least_size(); }

  // Whether y is never opposite to the part of D perpendicular to the axis. p and q are along n and m. There
  // -y has n and y has m. A point, of radius 0, has all directions.
  bool is_askew(double r, ValueRange p, ValueRange q, ValueRange n, ValueRange m) const noexcept {
    const bool turned = q.low < 0;
    const double near = turned ? -q.high : q.low, far = turned ? -q.low : q.high, slack = 2 * error_ * r;
    const double low = turned ? m.low : -m.high, high = turned ? m.high : -m.low;  // of -m towards q
    const bool known = (r > 0) & ((q.low >= 0) | (q.high <= 0));
    return known & ((high < -error_) | (p.low * larger(0, low) > far * larger(0, n.high) + slack) |
                    (p.high * larger(0, high) < near * larger(0, n.low) - slack));
  }

  const Scaled& p_;
  const TurnedFrame& f_;
  double most_ = 0, most_n_ = 0, error_, inverse_;  // inverse_: 1/s
  double side0_ = 1, side1_ = 1;
  Box boxes_[patch_box_cap + 1];
  int left_ = 0;
  double e0_ = 0, e1_ = 0, l0_ = 0, l1_ = 0;  // between the centres of the caps, along m0, m1, w0, w1
};

}  // namespace cyl
