// SPDX-License-Identifier: MIT
// A point that both solids share, looked for in one slice parallel to both axes. For decide() alone.
#pragma once

#include "solver/detail/certify.hpp"

namespace cyl {

// A rectangle in a plane: centre, unit side, half lengths along it and across it.
template <class T>
struct Rectangle {
  T x, y, ax, ay;
  T along, across;
};

template <class T>
struct PlanePoint {
  T x, y;
};

// A point that is often in both. It is on the line along r's longer side that passes other's centre as near
// as possible inside r. There it is the middle of the part that both rectangles cut out of the line.
template <class T>
PlanePoint<T> on_long_side(const Rectangle<T>& r, const Rectangle<T>& other) noexcept {
  constexpr double inwards = 0.75;
  const bool first = r.along > r.across;
  const T lx = first ? r.ax : -r.ay, ly = first ? r.ay : r.ax;  // along the longer side
  const T sx = -ly, sy = lx;
  const T longer = first ? r.along : r.across, limit = T(inwards) * (first ? r.across : r.along);
  const T dx = other.x - r.x, dy = other.y - r.y;
  const T beside = larger(-limit, smaller(limit, dx * sx + dy * sy));
  const T ox = beside * sx, oy = beside * sy;
  // |from + t rate| <= half for both sides of the other.
  const T ex = dx - ox, ey = dy - oy;
  const T inverse0 = T(1) / (lx * other.ax + ly * other.ay),
          inverse1 = T(1) / (ly * other.ax - lx * other.ay);
  const T middle0 = (ex * other.ax + ey * other.ay) * inverse0, width0 = other.along * magnitude(inverse0);
  const T middle1 = (ey * other.ax - ex * other.ay) * inverse1, width1 = other.across * magnitude(inverse1);
  const T lo = larger(-longer, larger(middle0 - width0, middle1 - width1));
  const T hi = smaller(longer, smaller(middle0 + width0, middle1 + width1));
  // If almost nothing is left, rounding may give lo > hi, because a side of the other that is almost along
  // the line can end anywhere on it. The side that crosses it decides.
  const bool crosses0 = magnitude(inverse0) < magnitude(inverse1);
  const T middle = crosses0 ? middle0 : middle1, width = crosses0 ? width0 : width1;
  const T t =
      larger(larger(-longer, middle - width), smaller(smaller(longer, middle + width), (lo + hi) * T(0.5)));
  return {r.x + ox + t * lx, r.y + oy + t * ly};
}

// Deep in both: rectangle 1 clipped by rectangle 0, grown by `slack` so that rounding does not lose a
// splinter. The mean of the rest; false if nothing is left.
template <class T>
bool middle_of_overlap(const Rectangle<T>& r0, const Rectangle<T>& r1, T slack,
                       PlanePoint<T>& found) noexcept {
  const T ax = r1.along * r1.ax, ay = r1.along * r1.ay, bx = -r1.across * r1.ay, by = r1.across * r1.ax;
  PlanePoint<T> polygon[8] = {{r1.x - ax - bx, r1.y - ay - by},
                              {r1.x + ax - bx, r1.y + ay - by},
                              {r1.x + ax + bx, r1.y + ay + by},
                              {r1.x - ax + bx, r1.y - ay + by}};
  int count = 4;
  auto clip = [&](T PlanePoint<T>::*axis, T sign, T limit) {
    PlanePoint<T> kept[8];
    int n = 0;
    for (int i = 0; i < count; ++i) {
      const PlanePoint<T>&from = polygon[i], &to = polygon[i + 1 < count ? i + 1 : 0];
      const T d0 = limit - sign * (from.*axis), d1 = limit - sign * (to.*axis);
      // not covered: a rectangle cut four times has at most 8 corners
      if (d0 >= T(0) && n < 8) kept[n++] = from;
      if ((d0 > T(0) && d1 < T(0)) || (d0 < T(0) && d1 > T(0))) {
        const T t = d0 / (d0 - d1);
        // not covered: the same
        if (n < 8) kept[n++] = {from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)};
      }
    }
    count = n;
    for (int i = 0; i < n; ++i) polygon[i] = kept[i];
  };
  clip(&PlanePoint<T>::x, 1, r0.along + slack);
  clip(&PlanePoint<T>::x, -1, r0.along + slack);
  clip(&PlanePoint<T>::y, 1, r0.across + slack);
  clip(&PlanePoint<T>::y, -1, r0.across + slack);
  if (count == 0) return false;
  found = {0, 0};
  for (int i = 0; i < count; ++i) {
    found.x = found.x + polygon[i].x / T(count);
    found.y = found.y + polygon[i].y / T(count);
  }
  return true;
}

// Common points of the slice of `p` at height u above C0. `narrow`: the rectangles may have little in common.
template <class F>
bool try_slice(ProofTask& q, const Scaled& p, const F& frame, typename F::Scalar u, bool narrow) noexcept {
  using T = typename F::Scalar;
  const Slices<T> slices = frame.slices();
  const T v = slices.z - u;
  const T b0 = root(positive((p.r0 - u) * (p.r0 + u))), b1 = root(positive((p.r1 - v) * (p.r1 + v)));
  const Rectangle<T> r0{0, 0, 1, 0, p.h0, b0};
  const Rectangle<T> r1{slices.along, slices.beside, slices.cosine, slices.sine, p.h1, b1};
  auto attempt = [&](const PlanePoint<T>& at) { return try_point(q, frame.at(at.x, at.y, u)); };
  constexpr double slack_tol = proof_slack_tol / 8;  // of the reach: much of a rounding, little of the room
  const auto in_middle = [&](T slack) {
    PlanePoint<T> at;
    return middle_of_overlap(r0, r1, slack, at) && attempt(at);
  };
  return (narrow && in_middle(T(0))) || attempt(on_long_side(r0, r1)) || attempt(on_long_side(r1, r0)) ||
         (!narrow && in_middle(T(0))) || in_middle(T(slack_tol * q.reach));
}

}  // namespace cyl
