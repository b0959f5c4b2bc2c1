// SPDX-License-Identifier: MIT
// The referee's own search for a certificate: a direction that separates, or a common point. Its result is a
// guess until it is checked. So it may be approximate, and one text serves double and every precision of
// MPFR.
//
// Planes parallel to both axes cut each solid in a rectangle. The solids meet iff the rectangles meet in some
// plane. Let u be the height of the plane above C0 along the common normal. The four separating axes of the
// rectangles give four concave functions of u. The height that maximises the least of them decides. The
// search brackets that height by the sign of the slope. It halves the bracket in turn with one of three
// steps:
// 1. to the point at which the tangents meet,
// 2. by Newton's method, if one function is the least at both ends,
// 3. beside a rim, to a square of the distance to it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/vec3.hpp"
#include "solver/solid.hpp"

namespace cyl {

/// A pair in numbers of one kind. The axes may have any length. b's centre is relative to a's. Heights are
/// halved.
template <class R>
struct SearchPair {
  Vec3<R> axis0, axis1, delta;
  R radius0, half0, radius1, half1;
};

/// A legal pair in double, with all lengths times 2^-exponent so that the largest is near 1, and the axes
/// near unit length. Numbers that become subnormal are rounded. This is good for a search, but not for a
/// proof.
SearchPair<double> double_pair(const Pair& pair, int& exponent);

/// The points at which the rims of a cross the rims of b, seen along a's axis, from a's centre. Faces at a
/// tiny angle may be nearest only there.
std::array<Vec3<double>, 4> crossings_of_rims(const SearchPair<double>& p);

/// The result of a search. Either may be absent. Near touching it has both.
template <class R>
struct Found {
  bool has_direction = false, has_point = false;
  Vec3<R> direction{};  ///< direction.delta >= 0
  Vec3<R> point{};      ///< relative to a's centre
  int slices = 0;       ///< looked at between the two ends of the range
};

namespace search_detail {

using std::abs;
using std::sqrt;

template <class R>
R max2(const R& a, const R& b) {
  return a < b ? b : a;
}
template <class R>
R min2(const R& a, const R& b) {
  return b < a ? b : a;
}

template <class R>
struct Line {
  R a, b, k;  // a b0(u) + b b1(z - u) - k
  Vec3<R> e;  // the axis of the test, pointing from a to b
};

template <class R>
struct Cut {
  R u, b0, b1;          // height, half widths
  R value, slope;       // of the least function
  R tilt0, tilt1;       // u/b0, v/b1 of the two widths; 0 if the width is 0
  bool steep0, steep1;  // the width is 0 at the rim of its disk: tilt without bound
  int least;
};

template <class R>
struct Point2 {
  R x, y;
};

// The mean of the corners of rectangle 1 clipped by rectangle 0 after both grew by `slack`.
template <class R>
bool overlap(const Point2<R>& center, const Point2<R>& along, const Point2<R>& across, const R& half_length,
             const R& half_width, const R& slack, Point2<R>& mean) {
  std::vector<Point2<R>> corners = {{center.x - along.x - across.x, center.y - along.y - across.y},
                                    {center.x + along.x - across.x, center.y + along.y - across.y},
                                    {center.x + along.x + across.x, center.y + along.y + across.y},
                                    {center.x - along.x + across.x, center.y - along.y + across.y}};
  for (int side = 0; side < 4; ++side) {
    const bool horizontal = side < 2, positive = side % 2 == 0;
    const R limit = (horizontal ? half_length : half_width) + slack;
    auto inside = [&](const Point2<R>& p) {
      const R& c = horizontal ? p.x : p.y;
      return positive ? limit - c : limit + c;
    };
    std::vector<Point2<R>> kept;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Point2<R>&from = corners[i], &to = corners[(i + 1) % corners.size()];
      const R d0 = inside(from), d1 = inside(to), zero = R(0);
      if (d0 >= zero) kept.push_back(from);
      if ((d0 > zero && d1 < zero) || (d0 < zero && d1 > zero)) {
        const R t = d0 / (d0 - d1);
        kept.push_back({from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)});
      }
    }
    corners.swap(kept);
    // not covered: rectangles are cut with a margin of fine_, and the least function is above -fine_
    if (corners.empty()) return false;
  }
  mean = {R(0), R(0)};
  const R count = R(static_cast<double>(corners.size()));
  for (const Point2<R>& p : corners) mean = {mean.x + p.x / count, mean.y + p.y / count};
  return true;
}

template <class R>
class Search {
 public:
  Search(const SearchPair<R>& p, int bits)
      : p_(p), bits_(bits), size_(p.radius0 + p.half0 + p.radius1 + p.half1), fine_(size_) {
    for (int left = bits - 10; left > 0; left -= 1000)
      fine_ = fine_ * R(std::ldexp(1.0, -std::min(left, 1000)));
  }

  const Found<R>& run() {
    if (size_ == zero_) {  // two points
      offer_direction(p_.delta);
      offer_point({zero_, zero_, zero_});
      return found_;
    }
    w0_ = p_.axis0 / R(sqrt(dot(p_.axis0, p_.axis0)));
    w1_ = p_.axis1 / R(sqrt(dot(p_.axis1, p_.axis1)));
    const Vec3<R> raw = cross(p_.axis0, p_.axis1);
    const R raw_length = sqrt(dot(raw, raw));
    if (raw_length == zero_) {
      search_parallel();
    } else {
      set_frame(raw / raw_length);
      if (!offer_separating_axis()) search_slices();
    }
    return found_;
  }

 private:
  void offer_direction(const Vec3<R>& d) {
    found_.has_direction = true;
    found_.direction = dot(d, p_.delta) < zero_ ? R(-1.0) * d : d;
  }

  void offer_point(const Vec3<R>& x) {
    found_.has_point = true;
    found_.point = x;
  }

  void search_parallel() {
    const R along = dot(p_.delta, w0_);
    const Vec3<R> across = p_.delta - along * w0_;
    const R distance = sqrt(dot(across, across));
    const R beyond = abs(along) - p_.half0 - p_.half1, beside = distance - p_.radius0 - p_.radius1;
    if (beyond > -fine_ || beside > -fine_) offer_direction(beyond > beside ? w0_ : across);
    if (beyond < fine_ && beside < fine_) {
      auto middle = [&](const R& reach0, const R& center, const R& reach1) {
        return (max2(R(-reach0), R(center - reach1)) + min2(reach0, R(center + reach1))) / two_;
      };
      Vec3<R> x = middle(p_.half0, along, p_.half1) * w0_;
      if (distance > zero_) x = x + R(middle(p_.radius0, distance, p_.radius1) / distance) * across;
      offer_point(x);
    }
  }

  /// `n`: the common normal, near unit length.
  void set_frame(Vec3<R> n) {
    n = n - R(dot(n, w0_)) * w0_;
    n_ = n / R(sqrt(dot(n, n)));
    z_ = dot(p_.delta, n_);
    if (z_ < zero_) {
      z_ = -z_;
      n_ = R(-1.0) * n_;
    }
    m0_ = cross(w0_, n_);
    m1_ = cross(w1_, n_);
    const R s = abs(dot(w1_, m0_)), c = abs(dot(w0_, w1_));
    auto towards = [&](const Vec3<R>& e) { return dot(e, p_.delta) < zero_ ? R(-1.0) * e : e; };
    auto gap = [&](const Vec3<R>& e) { return R(abs(dot(e, p_.delta))); };
    lines_ = {Line<R>{zero_, s, gap(w0_) - p_.half0 - p_.half1 * c, towards(w0_)},
              Line<R>{s, zero_, gap(w1_) - p_.half1 - p_.half0 * c, towards(w1_)},
              Line<R>{one_, c, gap(m0_) - p_.half1 * s, towards(m0_)},
              Line<R>{c, one_, gap(m1_) - p_.half0 * s, towards(m1_)}};
  }

  bool offer_separating_axis() {
    if (z_ - p_.radius0 - p_.radius1 > fine_) {
      offer_direction(n_);
      return true;
    }
    for (const Line<R>& line : lines_)
      if (line.k - line.a * p_.radius0 - line.b * p_.radius1 > fine_) {
        offer_direction(line.e);
        return true;
      }
    return false;
  }

  const Line<R>& line_of(const Cut<R>& t) const { return lines_[static_cast<std::size_t>(t.least)]; }

  Cut<R> cut_at(const R& u) const {
    Cut<R> t;
    t.u = u;
    const R v = z_ - u;
    const R square0 = (p_.radius0 - u) * (p_.radius0 + u), square1 = (p_.radius1 - v) * (p_.radius1 + v);
    t.b0 = square0 > zero_ ? R(sqrt(square0)) : zero_;
    t.b1 = square1 > zero_ ? R(sqrt(square1)) : zero_;
    t.steep0 = t.b0 == zero_ && p_.radius0 > zero_;
    t.steep1 = t.b1 == zero_ && p_.radius1 > zero_;
    t.tilt0 = t.b0 > zero_ ? R(u / t.b0) : zero_;
    t.tilt1 = t.b1 > zero_ ? R(v / t.b1) : zero_;
    t.least = 0;
    for (int j = 0; j < 4; ++j) {
      const Line<R>& line = lines_[static_cast<std::size_t>(j)];
      const R value = line.a * t.b0 + line.b * t.b1 - line.k;
      if (j == 0 || value < t.value) {
        t.value = value;
        t.least = j;
      }
    }
    const Line<R>& line = line_of(t);
    t.slope = line.b * t.tilt1 - line.a * t.tilt0;
    // Without bound: only the sign counts.
    if (t.steep0 && line.a > zero_) t.slope = u > zero_ ? R(-1.0) : one_;
    if (t.steep1 && line.b > zero_) t.slope = v > zero_ ? one_ : R(-1.0);
    return t;
  }

  bool steep(const Cut<R>& t) const {
    return (t.steep0 && line_of(t).a > zero_) || (t.steep1 && line_of(t).b > zero_);
  }

  void offer_slice_point(const Cut<R>& cut) {
    Point2<R> mean;
    // not covered: the same
    if (overlap<R>({dot(p_.delta, w0_), dot(p_.delta, m0_)},
                   {p_.half1 * dot(w1_, w0_), p_.half1 * dot(w1_, m0_)},
                   {cut.b1 * dot(m1_, w0_), cut.b1 * dot(m1_, m0_)}, p_.half0, cut.b0, fine_, mean))
      offer_point(mean.x * w0_ + mean.y * m0_ + cut.u * n_);
  }

  // The direction D for a slice that is the highest. At the rim of one disk, the other disk gives the tilt.
  // At both rims, a steep enough tilt does (r sqrt(A^2 + t^2) - r t < r A^2/(2t)). There both parts of D are
  // multiplied by k, because a tiny k would make the tilt infinite.
  void offer_peak(const Cut<R>& t) {
    const Line<R>& line = line_of(t);
    if (t.b0 == zero_ && t.b1 == zero_ && line.k > zero_ && p_.radius0 + p_.radius1 > zero_)
      offer_direction(line.k * line.e + R(p_.radius0 * line.a * line.a + p_.radius1 * line.b * line.b) * n_);
    else
      offer_direction(line.e + (t.b0 > t.b1 ? R(line.a * t.tilt0) : R(line.b * t.tilt1)) * n_);
  }

  void search_slices() {
    R lo = max2(R(-p_.radius0), R(z_ - p_.radius1)), hi = min2(p_.radius0, R(z_ + p_.radius1));
    if (lo > hi) {  // within rounding of touching along n
      lo = (lo + hi) / two_;
      hi = lo;
      offer_direction(n_);
    }
    const Cut<R> left = cut_at(lo), right = cut_at(hi);
    // not covered: of one slice the two slopes are the same
    if (left.slope <= zero_ || right.slope >= zero_ || lo == hi) {
      const Cut<R>& peak = left.slope <= zero_ ? left : right;
      if (peak.value < fine_ || lo == hi) {
        if (peak.value < fine_) offer_peak(peak);
        if (peak.value > -fine_) offer_slice_point(peak);
        return;
      }
      // The highest slice grazes a solid at its tip; one further in, lower but still above 0, has a deeper
      // point.
    }
    bracket_peak(left, right);
  }

  /// Narrows the bracket down to the slice at which the least function is greatest, or until what the
  /// tangents leave above the best slice is rounding.
  void bracket_peak(Cut<R> left, Cut<R> right) {
    Cut<R> best = left.value < right.value ? right : left;
    const R radii = p_.radius0 + p_.radius1, rounding = fine_ / R(256);
    // not covered: lo < hi, so that a radius is positive
    R next = radii > zero_ ? R(z_ * p_.radius0 / radii) : zero_;
    if (!(next > left.u && next < right.u)) next = (left.u + right.u) / two_;
    // not covered: no pair that was ever seen comes to the cap
    for (int step = 0; step < 3 * bits_ + 20; ++step) {
      const Cut<R> t = cut_at(next);
      ++found_.slices;
      if (t.value > best.value || t.value > fine_) best = t;
      if (t.value > fine_) break;
      if (t.slope == zero_) {
        offer_peak(t);
        break;
      }
      (t.slope > zero_ ? left : right) = t;

      const R width = right.u - left.u, middle = left.u + width / two_;
      R guess = middle;
      if (left.slope > zero_ && right.slope < zero_) {
        if (steep(left) || steep(right)) {
          if (!steep(left) || !steep(right)) {
            const Cut<R>&rim = steep(left) ? left : right, &other = steep(left) ? right : left;
            const R top = other.value + R(abs(other.slope)) * width;
            if (offer_beside(rim, other, top)) return;
            if (top - best.value < rounding) break;
            if (step % 2 == 0) guess = rim.u + R((other.u - rim.u) * (width / size_));
          }
        } else {
          const R fall = -right.slope, total = left.slope + fall, lambda = fall / total;
          const R top = lambda * (left.value + left.slope * width) + (one_ - lambda) * right.value;
          if (offer_between(left, right, lambda, top)) return;
          if (top - best.value < rounding) break;
          if (step % 2 == 0)
            guess = left.least == right.least ? level_after(t)
                                              : R(left.u + (right.value - left.value + fall * width) / total);
        }
      }
      if (!(guess > left.u && guess < right.u)) guess = middle;
      // not covered: rounding ends it first
      if (!(guess > left.u && guess < right.u) || width < fine_ * fine_ / size_) break;
      next = guess;
    }
    if (best.value > -fine_) offer_slice_point(best);
  }

  /// Returns the height at which the function that is least at `t` is level, by one step of Newton's method.
  /// Not for a rim.
  R level_after(const Cut<R>& t) const {
    const Line<R>& line = line_of(t);
    R bend = zero_;
    // not covered: within the bracket both are positive
    if (t.b0 > zero_) bend = line.a * (one_ + t.tilt0 * t.tilt0) / t.b0;
    // not covered: the same
    if (t.b1 > zero_) bend = bend + line.b * (one_ + t.tilt1 * t.tilt1) / t.b1;
    return t.u + t.slope / bend;
  }

  /// Offers the direction for which the two tangents, mixed by `lambda`, show that f is at most `bound`.
  /// Returns true if that separates by more than rounding.
  bool offer_between(const Cut<R>& left, const Cut<R>& right, const R& lambda, const R& bound) {
    if (!(bound < zero_)) return false;
    const Line<R>&j = line_of(left), &k = line_of(right);
    // Either solid gives the tilt; the one whose widths are further from 0 gives it more accurately.
    const bool use0 = min2(left.b0, right.b0) * p_.radius1 > min2(left.b1, right.b1) * p_.radius0;
    const R tilt = use0 ? R(lambda * j.a * left.tilt0 + (one_ - lambda) * k.a * right.tilt0)
                        : R(lambda * j.b * left.tilt1 + (one_ - lambda) * k.b * right.tilt1);
    offer_direction(lambda * j.e + R(one_ - lambda) * k.e + tilt * n_);
    return bound < -fine_;
  }

  /// The same if the bracket ends at a disk's `rim`, beside which widths grow without bound. One tangent may
  /// show it alone, tilted as the other solid is at `t`.
  bool offer_beside(const Cut<R>& rim, const Cut<R>& t, const R& bound) {
    if (!(bound < zero_)) return false;
    const Line<R>& line = line_of(t);
    offer_direction(line.e + (rim.steep0 ? R(line.b * t.tilt1) : R(line.a * t.tilt0)) * n_);
    return bound < -fine_;
  }

  const R zero_ = R(0), one_ = R(1), two_ = R(2);
  const SearchPair<R>& p_;
  int bits_;
  R size_;
  R fine_;                     // the size times 2^(10 - bits): below this, rounding may have the word
  Vec3<R> w0_{}, w1_{};        // unit axes
  Vec3<R> n_{}, m0_{}, m1_{};  // the common normal, and square to it and to either axis
  R z_{};                      // height of b's centre along n, >= 0
  std::array<Line<R>, 4> lines_{};
  Found<R> found_;
};

}  // namespace search_detail

/// Searches with `bits` of precision. R must have at least as many. Cost: 3 slices of 2 square roots on
/// random pairs, in the mean 13 near touching, up to about 100 for extreme lengths or angles.
template <class R>
Found<R> search(const SearchPair<R>& p, int bits) {
  return search_detail::Search<R>(p, bits).run();
}

}  // namespace cyl
