// SPDX-License-Identifier: MIT
// Symbols as in derivation.md: w0 w1 unit axes, h0 h1 half heights here, n the common perpendicular, z =
// Delta.n >= 0, u the height of a slice above C0 along n, v = z - u its height below C1.
#include "solver/decide.hpp"

#include <Eigen/Geometry>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

namespace cyl {
namespace {

// 2^exponent for -1022 <= exponent <= 1023.
double power_of_two(int exponent) noexcept {
  return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
}

// floor(log2 x) of a normal positive x.
int exponent_of(double x) noexcept {
  return static_cast<int>((std::bit_cast<std::uint64_t>(x) >> 52) & 0x7ff) - 1023;
}

double max_abs(const Vector3& x) noexcept {
  return std::fmax(std::fabs(x.x()), std::fmax(std::fabs(x.y()), std::fabs(x.z())));
}

double dot(const Vector3& a, const Vector3& b) noexcept {
  return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}

double length(const Vector3& a) noexcept { return std::sqrt(dot(a, a)); }

// Lexicographic order of two axes taken up to sign: < 0, 0, > 0.
int compare_lines(const Vector3& a, const Vector3& b) noexcept {
  auto sign = [](const Vector3& x) {
    for (int i = 0; i < 3; ++i)
      if (x[i] != 0) return x[i] > 0 ? 1.0 : -1.0;
    return 1.0;
  };
  const double sa = sign(a), sb = sign(b);
  for (int i = 0; i < 3; ++i)
    if (sa * a[i] != sb * b[i]) return sa * a[i] < sb * b[i] ? -1 : 1;
  return 0;
}

// The fixed order of the roles that makes the swap law hold bit for bit: it looks at nothing that scaling by
// 2^k or reversing an axis changes. True where b comes first.
bool out_of_order(const Prepared& a, const Prepared& b) noexcept {
  if (a.radius != b.radius) return a.radius > b.radius;
  if (a.height != b.height) return a.height > b.height;
  if (const int lines = compare_lines(a.unit_axis, b.unit_axis)) return lines > 0;
  for (int i = 0; i < 3; ++i)
    if (a.center[i] != b.center[i]) return a.center[i] > b.center[i];
  return false;
}

// The pair in its own unit, 2^exponent, in which the largest of radii, heights and |Delta| is in [1, 2).
struct Scaled {
  Vector3 w0, w1, delta;
  double r0, h0, r1, h1;  // h0, h1: half heights
  int exponent;
  double reach;  // r0 + h0 + r1 + h1 + |delta|, what rounding errors are multiples of
};

Scaled scale(const Prepared& a, const Prepared& b) noexcept {
  // Two factors, because one alone may be out of a double's range: `before` keeps Delta from overflowing and
  // lifts subnormal pairs, `after` brings the largest length to [1, 2).
  int shift = 0;
  const double farthest = std::fmax(max_abs(a.center), max_abs(b.center));
  if (farthest > 0x1p1000) shift = -100;
  double before = power_of_two(shift);
  Vector3 delta = b.center * before - a.center * before;
  auto largest = [&] {
    return std::fmax(std::fmax(std::fmax(a.radius, b.radius), std::fmax(a.height, b.height)) * before,
                     max_abs(delta));
  };
  double most = largest();
  if (most < 0x1p-1000) {
    shift = 200;
    before = power_of_two(shift);
    delta = (b.center - a.center) * before;
    most = largest();
  }
  const int exponent = most > 0 ? exponent_of(most) : 0;
  const double after = power_of_two(exponent > 1022 ? -1022 : -exponent);
  Scaled p;
  p.w0 = a.unit_axis;
  p.w1 = b.unit_axis;
  p.delta = delta * after;
  p.r0 = a.radius * before * after;
  p.h0 = a.height * before * after * 0.5;
  p.r1 = b.radius * before * after;
  p.h1 = b.height * before * after * 0.5;
  p.exponent = (exponent > 1022 ? 1022 : exponent) - shift;
  p.reach = p.r0 + p.h0 + p.r1 + p.h1 + length(p.delta);
  return p;
}

// f(D) < 0 beyond rounding (derivation.md, section 6).
bool separates(const Scaled& p, const Vector3& d) noexcept {
  const double f = p.r0 * length(d.cross(p.w0)) + p.h0 * std::fabs(dot(d, p.w0)) +
                   p.r1 * length(d.cross(p.w1)) + p.h1 * std::fabs(dot(d, p.w1)) - std::fabs(dot(d, p.delta));
  return f < -separation_error * length(d) * p.reach;
}

// x, from C0, lies in both solids beyond rounding.
bool in_both(const Scaled& p, const Vector3& x) noexcept {
  const Vector3 y = x - p.delta;
  const double e = membership_error * (length(x) + length(p.delta));
  return std::fabs(dot(x, p.w0)) + e <= p.h0 && length(x.cross(p.w0)) + e <= p.r0 &&
         std::fabs(dot(y, p.w1)) + e <= p.h1 && length(y.cross(p.w1)) + e <= p.r1;
}

// The answer under construction: verdicts come out at once, or only where their certificate holds.
template <bool prove>
struct Attempt {
  const Scaled& p;
  Vector3 base;  // C0, in the scene's unit
  Answer answer;

  bool disjoint(const Vector3& direction) noexcept {
    if constexpr (prove) {
      if (!separates(p, direction)) return false;
      answer.proof = Proof::direction;
      answer.direction = direction;
    }
    answer.verdict = Verdict::disjoint;
    return true;
  }

  bool intersecting(const Vector3& x) noexcept {
    if constexpr (prove) {
      // The certificate is what is handed out, so that is what gets checked: back in the scene's unit, where
      // a subnormal coordinate may have lost bits.
      const Vector3 tail(std::ldexp(x.x(), p.exponent), std::ldexp(x.y(), p.exponent),
                         std::ldexp(x.z(), p.exponent));
      const Vector3 kept(std::ldexp(tail.x(), -p.exponent), std::ldexp(tail.y(), -p.exponent),
                         std::ldexp(tail.z(), -p.exponent));
      if (!in_both(p, kept)) return false;
      answer.proof = Proof::point;
      answer.point_head = base;
      answer.point_tail = tail;
    }
    answer.verdict = Verdict::intersecting;
    return true;
  }
};

// Axes exactly parallel: two numbers decide, the distance along the axis and the one across it.
template <bool prove>
void decide_parallel(Attempt<prove>& attempt, const Vector3& axis_sum) noexcept {
  const Scaled& p = attempt.p;
  const Vector3 w = axis_sum / length(axis_sum);
  const double along = dot(p.delta, w);
  const Vector3 across = p.delta - along * w;
  const double distance = length(p.delta.cross(w));
  if (std::fabs(along) > p.h0 + p.h1 && attempt.disjoint(along > 0 ? w : Vector3(-w))) return;
  if (distance > p.r0 + p.r1 && attempt.disjoint(across / distance)) return;
  if (std::fabs(along) > p.h0 + p.h1 || distance > p.r0 + p.r1) return;
  if constexpr (!prove) {
    attempt.answer.verdict = Verdict::intersecting;
    return;
  }
  auto middle = [](double reach0, double center1, double reach1) {
    return (std::fmax(-reach0, center1 - reach1) + std::fmin(reach0, center1 + reach1)) / 2;
  };
  Vector3 x = middle(p.h0, along, p.h1) * w;
  if (distance > 0) x += middle(p.r0, distance, p.r1) * (across / distance);
  attempt.intersecting(x);
}

// One piece g(u) = a b0(u) + b b1(z-u) - k of the slice formulation, with the unit vector e it comes from.
struct Piece {
  double a, b, k;
  Vector3 e;  // w0, w1, m0 or m1, signed so that e.Delta >= 0
};

// A slice evaluated: the lowest piece there, and the slopes of b0 and b1 that make its tangent.
struct Slice {
  double u, b0, b1;
  double p0, p1;  // u/b0 and v/b1
  int active;
  double g, slope;
};

// b is never taken below r 2^-27: sqrt(r^2 - u^2) of doubles is 0 or above that, and so no slope is infinite;
// the line with that slope still bounds b from above at every other double.
double ratio(double u, double b, double r) noexcept { return r > 0 ? u / std::fmax(b, r * 0x1p-27) : 0; }

Slice evaluate(const Scaled& p, const Piece* pieces, double z, double u) noexcept {
  Slice t;
  t.u = u;
  const double v = z - u;
  t.b0 = std::sqrt(std::fmax(0.0, (p.r0 - u) * (p.r0 + u)));
  t.b1 = std::sqrt(std::fmax(0.0, (p.r1 - v) * (p.r1 + v)));
  t.active = 0;
  t.g = pieces[0].a * t.b0 + pieces[0].b * t.b1 - pieces[0].k;
  for (int j = 1; j < 4; ++j) {
    const double g = pieces[j].a * t.b0 + pieces[j].b * t.b1 - pieces[j].k;
    if (g < t.g) {
      t.g = g;
      t.active = j;
    }
  }
  t.p0 = ratio(u, t.b0, p.r0);
  t.p1 = ratio(v, t.b1, p.r1);
  t.slope = pieces[t.active].b * t.p1 - pieces[t.active].a * t.p0;
  return t;
}

// A deep common point of the two rectangles of a slice: rectangle 1 clipped by rectangle 0, the mean of what
// is left. In the plane's coordinates (along w0, along m0). False where nothing is left.
bool common_point(const Scaled& p, const Vector3& m0, const Vector3& m1, double b0, double b1, double& x,
                  double& y) noexcept {
  struct Point {
    double x, y;
  };
  const Point center{dot(p.delta, p.w0), dot(p.delta, m0)};
  const Point along{p.h1 * dot(p.w1, p.w0), p.h1 * dot(p.w1, m0)};
  const Point across{b1 * dot(m1, p.w0), b1 * dot(m1, m0)};
  Point polygon[8] = {{center.x - along.x - across.x, center.y - along.y - across.y},
                      {center.x + along.x - across.x, center.y + along.y - across.y},
                      {center.x + along.x + across.x, center.y + along.y + across.y},
                      {center.x - along.x + across.x, center.y - along.y + across.y}};
  int count = 4;
  auto clip = [&](double Point::*axis, double sign, double limit) {
    Point kept[8];
    int n = 0;
    for (int i = 0; i < count; ++i) {
      const Point &from = polygon[i], &to = polygon[(i + 1) % count];
      const double d0 = limit - sign * (from.*axis), d1 = limit - sign * (to.*axis);
      if (d0 >= 0 && n < 8) kept[n++] = from;
      if ((d0 > 0 && d1 < 0) || (d0 < 0 && d1 > 0)) {
        const double t = d0 / (d0 - d1);
        if (n < 8) kept[n++] = {from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)};
      }
    }
    count = n;
    for (int i = 0; i < n; ++i) polygon[i] = kept[i];
  };
  clip(&Point::x, 1, p.h0);
  clip(&Point::x, -1, p.h0);
  clip(&Point::y, 1, b0);
  clip(&Point::y, -1, b0);
  if (count == 0) return false;
  x = y = 0;
  for (int i = 0; i < count; ++i) {
    x += polygon[i].x / count;
    y += polygon[i].y / count;
  }
  return true;
}

template <bool prove>
void decide_crossing(Attempt<prove>& attempt, const Vector3& cross) noexcept {
  const Scaled& p = attempt.p;
  const double cross_length = length(cross);
  const double s = cross_length / 2;
  Vector3 n = cross / cross_length;
  double z = dot(p.delta, n);
  if (z < 0) {
    z = -z;
    n = -n;
  }
  if (z > p.r0 + p.r1 && attempt.disjoint(n)) return;

  const double c = std::fabs(dot(p.w0, p.w1));
  const Vector3 m0 = p.w0.cross(n), m1 = p.w1.cross(n);
  auto towards = [&](const Vector3& e, double& d) {
    const bool back = d < 0;
    d = std::fabs(d);
    return back ? Vector3(-e) : e;
  };
  double d0 = dot(p.delta, p.w0), d1 = dot(p.delta, p.w1), d2 = dot(p.delta, m0), d3 = dot(p.delta, m1);
  const Vector3 e0 = towards(p.w0, d0), e1 = towards(p.w1, d1), e2 = towards(m0, d2), e3 = towards(m1, d3);
  const Piece pieces[4] = {{0, s, d0 - p.h0 - p.h1 * c, e0},
                           {s, 0, d1 - p.h1 - p.h0 * c, e1},
                           {1, c, d2 - p.h1 * s, e2},
                           {c, 1, d3 - p.h0 * s, e3}};
  for (const Piece& piece : pieces)
    if (piece.k > piece.a * p.r0 + piece.b * p.r1 && attempt.disjoint(piece.e)) return;

  const double lo = std::fmax(-p.r0, z - p.r1), hi = std::fmin(p.r0, z + p.r1);
  if (lo > hi) {
    // Only where z > r0 + r1, or within rounding of it.
    if constexpr (!prove) attempt.answer.verdict = Verdict::disjoint;
    return;
  }

  const double radii = p.r0 + p.r1;
  const double resolution = radii * unit_roundoff_error;
  double u = radii > 0 ? z * (p.r0 / radii) : 0;
  u = std::fmin(std::fmax(u, lo), hi);

  Slice left{}, right{};  // the bracket: slope > 0 at left, < 0 at right
  bool has_left = false, has_right = false;
  int misses = 0;     // steps since the bracket last halved
  int midpoints = 0;  // steps towards an end that has not been looked at
  double width = hi - lo;

  for (int& i = attempt.answer.iterations; i < iteration_cap; ++i) {
    const Slice t = evaluate(p, pieces, z, u);
    if (t.g >= 0) {
      if constexpr (prove) {
        double x, y;
        if (common_point(p, m0, m1, t.b0, t.b1, x, y) && attempt.intersecting(x * p.w0 + y * m0 + u * n))
          return;
      } else {
        attempt.answer.verdict = Verdict::intersecting;
        return;
      }
    }

    // The tangent of piece j at u bounds g from above. Where the tangents of both sides, slopes balanced by
    // lambda, stay below 0, D = lambda e_j + (1 - lambda) e_k + t n separates. t follows from either solid;
    // at the tip of one (its width 0, its slope without bound) from the other.
    const Piece& piece = pieces[t.active];
    const bool at_end = (t.slope > 0 && u >= hi) || (t.slope < 0 && u <= lo) || t.slope == 0 || lo == hi;
    if (at_end) {
      if (t.g >= 0) return;  // only when proving: the deepest slice, and its point is within rounding
      const bool tip0 = t.b0 <= t.b1;
      const double tilt = tip0 ? piece.b * t.p1 : piece.a * t.p0;
      if (attempt.disjoint(piece.e + tilt * n) || !prove) return;
      // Both widths 0: D -> n.
      attempt.disjoint(n);
      return;
    }
    if (t.slope > 0) {
      left = t;
      has_left = true;
    } else {
      right = t;
      has_right = true;
    }

    double next;
    if (has_left && has_right) {
      const double rise = left.slope, fall = -right.slope;
      const double lambda = fall / (rise + fall);
      const double bound = lambda * (left.g + left.slope * (right.u - left.u)) + (1 - lambda) * right.g;
      if (bound < 0) {
        const Piece &j = pieces[left.active], &k = pieces[right.active];
        const bool tip0 = std::fmin(left.b0, right.b0) * p.r1 <= std::fmin(left.b1, right.b1) * p.r0;
        const double tilt = tip0 ? lambda * j.b * left.p1 + (1 - lambda) * k.b * right.p1
                                 : lambda * j.a * left.p0 + (1 - lambda) * k.a * right.p0;
        if (attempt.disjoint(lambda * j.e + (1 - lambda) * k.e + tilt * n)) return;
      }
      const double gap = right.u - left.u;
      if (gap <= resolution) break;
      misses = gap <= width / 2 ? 0 : misses + 1;
      if (misses == 0) width = gap;
      next = left.u + (right.g - left.g + fall * gap) / (rise + fall);
      if (misses >= 2 || !(next > left.u && next < right.u)) next = left.u + gap / 2;
      if (!(next > left.u && next < right.u)) break;
    } else {
      // One side is an end not looked at: the tangent's height there bounds everything.
      const double end = has_left ? hi : lo;
      const bool tip0 = has_left ? hi == p.r0 : lo == -p.r0;
      if (t.g + t.slope * (end - u) < 0) {
        const double tilt = tip0 ? piece.b * t.p1 : piece.a * t.p0;
        if (attempt.disjoint(piece.e + tilt * n)) return;
      }
      next = ++midpoints > 4 ? end : u + (end - u) / 2;
      if (std::fabs(end - u) <= resolution) next = end;
    }
    u = next;
  }
  // The bracket is exhausted: the highest slice, seen on both sides, is below 0 (or, when proving, within
  // rounding).
  if constexpr (!prove) {
    if (attempt.answer.iterations < iteration_cap) attempt.answer.verdict = Verdict::disjoint;
  }
}

template <bool prove>
Answer run(const Prepared& a, const Prepared& b) noexcept {
  if (a.defect != Defect::none || b.defect != Defect::none) {
    Answer answer;
    answer.verdict = Verdict::invalid;
    return answer;
  }
  const bool swapped = out_of_order(a, b);
  const Prepared& first = swapped ? b : a;
  const Prepared& second = swapped ? a : b;
  const Scaled p = scale(first, second);
  Attempt<prove> attempt{p, first.center, {}};

  // w0 x w1 from the sum and the difference of the axes (one taken backwards where they are opposite): those
  // two are perpendicular, so their cross product is accurate relative to its own length, however small the
  // angle.
  const Vector3 w1 = dot(p.w0, p.w1) < 0 ? Vector3(-p.w1) : p.w1;
  const Vector3 sum = p.w0 + w1;
  const Vector3 cross = (p.w0 - w1).cross(sum);
  if (cross.x() == 0 && cross.y() == 0 && cross.z() == 0)
    decide_parallel(attempt, sum);
  else
    decide_crossing(attempt, cross);
  if (swapped) attempt.answer.direction = -attempt.answer.direction;
  return attempt.answer;
}

}  // namespace

Prepared prepare(const Cylinder& c) noexcept {
  Prepared p{c.center, {0, 0, 1}, c.radius, c.height, find_defect(c)};
  if (p.defect != Defect::none) return p;
  // By powers of two until the largest coordinate is in [1, 2): squares neither overflow nor vanish.
  double most = max_abs(c.axis);
  Vector3 w = c.axis;
  if (most < 0x1p-1000) {
    w *= 0x1p200;
    most *= 0x1p200;
  }
  const int exponent = exponent_of(most);
  w *= exponent > 1022 ? 0x1p-1022 : power_of_two(-exponent);
  p.unit_axis = w / length(w);
  return p;
}

Verdict intersect(const Prepared& a, const Prepared& b) noexcept { return run<false>(a, b).verdict; }
Verdict intersect(const Cylinder& a, const Cylinder& b) noexcept { return intersect(prepare(a), prepare(b)); }
Answer decide(const Prepared& a, const Prepared& b) noexcept { return run<true>(a, b); }
Answer decide(const Cylinder& a, const Cylinder& b) noexcept { return decide(prepare(a), prepare(b)); }

}  // namespace cyl
