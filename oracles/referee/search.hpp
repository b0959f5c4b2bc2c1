// SPDX-License-Identifier: MIT
// The referee's own search for a certificate: a direction that separates, or a common point. What it finds is
// a guess until it is checked; so it is free to be approximate, and one text serves double and every
// precision of MPFR.
//
// Planes parallel to both axes cut each solid in a rectangle; the solids meet iff in some plane the
// rectangles do. With u the height of the plane above C0 along the common normal, the rectangles' four
// separating axes give four concave functions of u, and the height that maximises the least of them decides.
// Here that height is bracketed by the sign of the slope, by the meeting point of tangents and by halving in
// turn.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "oracles/referee/vec3.hpp"
#include "solver/cylinder.hpp"

namespace cyl {

/// A pair in numbers of one kind; axes of any length; b's centre relative to a's; half heights.
template <class R>
struct SearchPair {
  Vec3<R> axis0, axis1, delta;
  R radius0, half0, radius1, half1;
};

/// A legal pair in double, all lengths times 2^-exponent so that the largest is near 1, the axes near unit
/// length. Where that makes numbers subnormal they are rounded: good for searching, no proof.
SearchPair<double> double_pair(const Pair& pair, int& exponent);

/// What the search offers; either may be absent, both are offered near touching.
template <class R>
struct Found {
  bool has_direction = false, has_point = false;
  Vec3<R> direction;  ///< direction.delta >= 0
  Vec3<R> point;      ///< relative to a's centre
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
  R tilt0, tilt1;       // u/b0, v/b1 of the two widths, 0 where the width is
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
    auto room = [&](const Point2<R>& p) {
      const R& c = horizontal ? p.x : p.y;
      return positive ? limit - c : limit + c;
    };
    std::vector<Point2<R>> kept;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Point2<R>&from = corners[i], &to = corners[(i + 1) % corners.size()];
      const R d0 = room(from), d1 = room(to), zero = R(0);
      if (d0 >= zero) kept.push_back(from);
      if ((d0 > zero && d1 < zero) || (d0 < zero && d1 > zero)) {
        const R t = d0 / (d0 - d1);
        kept.push_back({from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)});
      }
    }
    corners.swap(kept);
    if (corners.empty()) return false;
  }
  mean = {R(0), R(0)};
  const R count = R(static_cast<double>(corners.size()));
  for (const Point2<R>& p : corners) mean = {mean.x + p.x / count, mean.y + p.y / count};
  return true;
}

}  // namespace search_detail

/// Searches with `bits` of precision; R's own precision is at least that. Cost: about 5 slices of 4 square
/// roots on random pairs, up to 3 `bits` of them near touching.
template <class R>
Found<R> search(const SearchPair<R>& p, int bits) {
  using namespace search_detail;
  const R zero(0), one(1), two(2);
  Found<R> found;
  auto offer_direction = [&](const Vec3<R>& d) {
    found.has_direction = true;
    found.direction = dot(d, p.delta) < zero ? R(-1.0) * d : d;
  };
  auto offer_point = [&](const Vec3<R>& x) {
    found.has_point = true;
    found.point = x;
  };

  const R size = p.radius0 + p.half0 + p.radius1 + p.half1;
  if (size == zero) {  // two points
    offer_direction(p.delta);
    offer_point({zero, zero, zero});
    return found;
  }
  R fine = size;  // times 2^(10 - bits): below this, rounding may have the word
  for (int left = bits - 10; left > 0; left -= 1000) fine = fine * R(std::ldexp(1.0, -std::min(left, 1000)));

  const Vec3<R> w0 = p.axis0 / R(sqrt(dot(p.axis0, p.axis0)));
  const Vec3<R> w1 = p.axis1 / R(sqrt(dot(p.axis1, p.axis1)));
  const Vec3<R> raw = cross(p.axis0, p.axis1);
  const R raw_length = sqrt(dot(raw, raw));

  if (raw_length == zero) {
    const R along = dot(p.delta, w0);
    const Vec3<R> across = p.delta - along * w0;
    const R distance = sqrt(dot(across, across));
    const R beyond = abs(along) - p.half0 - p.half1, beside = distance - p.radius0 - p.radius1;
    if (beyond > -fine || beside > -fine) offer_direction(beyond > beside ? w0 : across);
    if (beyond < fine && beside < fine) {
      auto middle = [&](const R& reach0, const R& center, const R& reach1) {
        return (max2(R(-reach0), R(center - reach1)) + min2(reach0, R(center + reach1))) / two;
      };
      Vec3<R> x = middle(p.half0, along, p.half1) * w0;
      if (distance > zero) x = x + R(middle(p.radius0, distance, p.radius1) / distance) * across;
      offer_point(x);
    }
    return found;
  }

  Vec3<R> n = raw / raw_length;
  n = n - R(dot(n, w0)) * w0;
  n = n / R(sqrt(dot(n, n)));
  R z = dot(p.delta, n);
  if (z < zero) {
    z = -z;
    n = R(-1.0) * n;
  }
  const Vec3<R> m0 = cross(w0, n), m1 = cross(w1, n);
  const R s = abs(dot(w1, m0)), c = abs(dot(w0, w1));
  auto towards = [&](const Vec3<R>& e) { return dot(e, p.delta) < zero ? R(-1.0) * e : e; };
  auto gap = [&](const Vec3<R>& e) { return R(abs(dot(e, p.delta))); };
  const std::array<Line<R>, 4> lines = {Line<R>{zero, s, gap(w0) - p.half0 - p.half1 * c, towards(w0)},
                                        Line<R>{s, zero, gap(w1) - p.half1 - p.half0 * c, towards(w1)},
                                        Line<R>{one, c, gap(m0) - p.half1 * s, towards(m0)},
                                        Line<R>{c, one, gap(m1) - p.half0 * s, towards(m1)}};

  auto offer_slice_point = [&](const Cut<R>& cut) {
    Point2<R> mean;
    if (overlap<R>({dot(p.delta, w0), dot(p.delta, m0)}, {p.half1 * dot(w1, w0), p.half1 * dot(w1, m0)},
                   {cut.b1 * dot(m1, w0), cut.b1 * dot(m1, m0)}, p.half0, cut.b0, fine, mean))
      offer_point(mean.x * w0 + mean.y * m0 + cut.u * n);
  };

  const R apart = z - p.radius0 - p.radius1;
  if (apart > fine) {
    offer_direction(n);
    return found;
  }
  for (const Line<R>& line : lines)
    if (line.k - line.a * p.radius0 - line.b * p.radius1 > fine) {
      offer_direction(line.e);
      return found;
    }

  R lo = max2(R(-p.radius0), R(z - p.radius1)), hi = min2(p.radius0, R(z + p.radius1));
  if (lo > hi) {  // within rounding of touching along n
    lo = (lo + hi) / two;
    hi = lo;
    offer_direction(n);
  }

  auto cut_at = [&](const R& u) {
    Cut<R> t;
    t.u = u;
    const R v = z - u;
    const R square0 = (p.radius0 - u) * (p.radius0 + u), square1 = (p.radius1 - v) * (p.radius1 + v);
    t.b0 = square0 > zero ? R(sqrt(square0)) : zero;
    t.b1 = square1 > zero ? R(sqrt(square1)) : zero;
    t.steep0 = t.b0 == zero && p.radius0 > zero;
    t.steep1 = t.b1 == zero && p.radius1 > zero;
    t.tilt0 = t.b0 > zero ? R(u / t.b0) : zero;
    t.tilt1 = t.b1 > zero ? R(v / t.b1) : zero;
    t.least = 0;
    for (int j = 0; j < 4; ++j) {
      const Line<R>& line = lines[static_cast<std::size_t>(j)];
      const R value = line.a * t.b0 + line.b * t.b1 - line.k;
      if (j == 0 || value < t.value) {
        t.value = value;
        t.least = j;
      }
    }
    const Line<R>& line = lines[static_cast<std::size_t>(t.least)];
    t.slope = line.b * t.tilt1 - line.a * t.tilt0;
    // Without bound: only the sign counts.
    if (t.steep0 && line.a > zero) t.slope = u > zero ? R(-1.0) : one;
    if (t.steep1 && line.b > zero) t.slope = v > zero ? one : R(-1.0);
    return t;
  };
  auto steep = [&](const Cut<R>& t) {
    const Line<R>& line = lines[static_cast<std::size_t>(t.least)];
    return (t.steep0 && line.a > zero) || (t.steep1 && line.b > zero);
  };
  // D for one slice that is as high as it gets: at the rim of one disk the other gives the tilt, at both rims
  // a steep enough tilt does (r sqrt(A^2 + t^2) - r t < r A^2/(2t)).
  auto offer_peak = [&](const Cut<R>& t) {
    const Line<R>& line = lines[static_cast<std::size_t>(t.least)];
    R tilt = t.b0 > t.b1 ? line.a * t.tilt0 : line.b * t.tilt1;
    if (t.b0 == zero && t.b1 == zero && line.k > zero && p.radius0 + p.radius1 > zero)
      tilt = (p.radius0 * line.a * line.a + p.radius1 * line.b * line.b) / line.k;
    offer_direction(line.e + tilt * n);
  };

  const R radii = p.radius0 + p.radius1;
  Cut<R> left = cut_at(lo), right = cut_at(hi);
  Cut<R> best = left.value < right.value ? right : left;
  if (left.slope <= zero || right.slope >= zero || lo == hi) {
    const Cut<R>& peak = left.slope <= zero ? left : right;
    if (peak.value < fine || lo == hi) {
      if (peak.value < fine) offer_peak(peak);
      if (peak.value > -fine) offer_slice_point(peak);
      return found;
    }
    // The highest slice grazes a solid at its tip; one further in, lower but still above 0, has a deeper
    // point.
  }

  R next = radii > zero ? R(z * p.radius0 / radii) : zero;
  if (!(next > lo && next < hi)) next = (lo + hi) / two;
  for (int step = 0; step < 3 * bits + 20; ++step) {
    const Cut<R> t = cut_at(next);
    if (t.value > best.value || t.value > fine) best = t;
    if (t.value > fine) break;
    if (t.slope == zero) {
      offer_peak(t);
      break;
    }
    (t.slope > zero ? left : right) = t;

    const R width = right.u - left.u;
    R meeting = left.u + width / two;
    if (!steep(left) && !steep(right) && left.slope > zero && right.slope < zero) {
      const R fall = -right.slope, total = left.slope + fall;
      const R lambda = fall / total;
      const R bound = lambda * (left.value + left.slope * width) + (one - lambda) * right.value;
      if (bound < zero) {
        const Line<R>&j = lines[static_cast<std::size_t>(left.least)],
              &k = lines[static_cast<std::size_t>(right.least)];
        // Either solid gives the tilt; the one whose widths are further from 0 gives it more accurately.
        const bool use0 = min2(left.b0, right.b0) * p.radius1 > min2(left.b1, right.b1) * p.radius0;
        const R tilt = use0 ? R(lambda * j.a * left.tilt0 + (one - lambda) * k.a * right.tilt0)
                            : R(lambda * j.b * left.tilt1 + (one - lambda) * k.b * right.tilt1);
        offer_direction(lambda * j.e + R(one - lambda) * k.e + tilt * n);
        if (bound < -fine) return found;
      }
      if (step % 2 == 0) meeting = left.u + (right.value - left.value + fall * width) / total;
    }
    if (!(meeting > left.u && meeting < right.u)) meeting = left.u + width / two;
    if (!(meeting > left.u && meeting < right.u) || width < fine * fine / size) break;
    next = meeting;
  }
  if (best.value > -fine) offer_slice_point(best);
  return found;
}

}  // namespace cyl
