// SPDX-License-Identifier: MIT
// A point that both solids share, looked for in one slice parallel to both axes. For decide() alone.
#pragma once

#include "solver/detail/certify.hpp"

namespace cyl {

// A rectangle in a plane: centre, unit side, half lengths along it and across it.
struct Rectangle {
  double x, y, ax, ay;
  double along, across;
};

struct PlanePoint {
  double x, y;
};

// A point that is often in both: on the line along r's longer side that passes other's centre as near as well
// inside r it can, the middle of what both rectangles cut out of it.
inline PlanePoint on_long_side(const Rectangle& r, const Rectangle& other) noexcept {
  constexpr double inwards = 0.75;
  const bool first = r.along > r.across;
  const double lx = first ? r.ax : -r.ay, ly = first ? r.ay : r.ax;  // along the longer side
  const double sx = -ly, sy = lx;
  const double longer = first ? r.along : r.across, limit = inwards * (first ? r.across : r.along);
  const double dx = other.x - r.x, dy = other.y - r.y;
  const double beside = larger(-limit, smaller(limit, dx * sx + dy * sy));
  const double ox = beside * sx, oy = beside * sy;
  // |from + t rate| <= half for both sides of the other.
  const double ex = dx - ox, ey = dy - oy;
  const double inverse0 = 1 / (lx * other.ax + ly * other.ay), inverse1 = 1 / (ly * other.ax - lx * other.ay);
  const double middle0 = (ex * other.ax + ey * other.ay) * inverse0,
               width0 = other.along * std::fabs(inverse0);
  const double middle1 = (ey * other.ax - ex * other.ay) * inverse1,
               width1 = other.across * std::fabs(inverse1);
  const double lo = larger(-longer, larger(middle0 - width0, middle1 - width1));
  const double hi = smaller(longer, smaller(middle0 + width0, middle1 + width1));
  // Where next to nothing is left, rounding may have lo > hi, since a side of the other all but along the
  // line ends anywhere on it: the side that crosses it has the last word.
  const bool crosses0 = std::fabs(inverse0) < std::fabs(inverse1);
  const double middle = crosses0 ? middle0 : middle1, width = crosses0 ? width0 : width1;
  const double t =
      larger(larger(-longer, middle - width), smaller(smaller(longer, middle + width), (lo + hi) / 2));
  return {r.x + ox + t * lx, r.y + oy + t * ly};
}

// Deep in both: rectangle 1 clipped by rectangle 0 grown by `slack`, so that rounding does not lose a
// splinter; the mean of what is left. False where nothing is left.
inline bool middle_of_overlap(const Rectangle& r0, const Rectangle& r1, double slack,
                              PlanePoint& found) noexcept {
  const double ax = r1.along * r1.ax, ay = r1.along * r1.ay, bx = -r1.across * r1.ay, by = r1.across * r1.ax;
  PlanePoint polygon[8] = {{r1.x - ax - bx, r1.y - ay - by},
                           {r1.x + ax - bx, r1.y + ay - by},
                           {r1.x + ax + bx, r1.y + ay + by},
                           {r1.x - ax + bx, r1.y - ay + by}};
  int count = 4;
  auto clip = [&](double PlanePoint::*axis, double sign, double limit) {
    PlanePoint kept[8];
    int n = 0;
    for (int i = 0; i < count; ++i) {
      const PlanePoint &from = polygon[i], &to = polygon[(i + 1) % count];
      const double d0 = limit - sign * (from.*axis), d1 = limit - sign * (to.*axis);
      // untaken: a rectangle cut four times has at most 8 corners
      if (d0 >= 0 && n < 8) kept[n++] = from;
      if ((d0 > 0 && d1 < 0) || (d0 < 0 && d1 > 0)) {
        const double t = d0 / (d0 - d1);
        // untaken: the same
        if (n < 8) kept[n++] = {from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)};
      }
    }
    count = n;
    for (int i = 0; i < n; ++i) polygon[i] = kept[i];
  };
  clip(&PlanePoint::x, 1, r0.along + slack);
  clip(&PlanePoint::x, -1, r0.along + slack);
  clip(&PlanePoint::y, 1, r0.across + slack);
  clip(&PlanePoint::y, -1, r0.across + slack);
  if (count == 0) return false;
  found = {0, 0};
  for (int i = 0; i < count; ++i) {
    found.x += polygon[i].x / count;
    found.y += polygon[i].y / count;
  }
  return true;
}

// What is to be decided, and where its certificate goes: each is checked against these solids.
struct Question {
  const Scaled& solids;
  const Base& base;
  Answer& answer;
};

// Common points of the slice of `p` at height u above C0.
inline bool try_slice(const Question& q, const Scaled& p, const Frame& frame, double u) noexcept {
  const double v = frame.z - u;
  const double b0 = std::sqrt(larger(0, (p.r0 - u) * (p.r0 + u)));
  const double b1 = std::sqrt(larger(0, (p.r1 - v) * (p.r1 + v)));
  const Rectangle r0{0, 0, 1, 0, p.h0, b0};
  const Rectangle r1{frame.d[0], frame.d[2], dot(frame.w1, frame.w0), dot(frame.w1, frame.m0), p.h1, b1};
  auto attempt = [&](PlanePoint at) {
    return try_point(q.solids, q.base, at.x * frame.w0 + at.y * frame.m0 + u * frame.n, q.answer);
  };
  constexpr double slack_tol = room_tol / 8;  // of the reach: much of a rounding, little of the room
  PlanePoint at;
  return attempt(on_long_side(r0, r1)) || attempt(on_long_side(r1, r0)) ||
         (middle_of_overlap(r0, r1, 0, at) && attempt(at)) ||
         (middle_of_overlap(r0, r1, slack_tol * reach_of(p), at) && attempt(at));
}

}  // namespace cyl
