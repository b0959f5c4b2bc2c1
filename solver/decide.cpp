// SPDX-License-Identifier: MIT
// Symbols as in derivation.md: w0 w1 unit axes, h0 h1 half heights here, n the common perpendicular, z =
// Delta.n >= 0, u the height of a slice above C0 along n, v = z - u its height below C1.
#include "solver/decide.hpp"

#include <Eigen/Geometry>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

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

// Of finite numbers; std::fmax and std::fmin are calls, these are one instruction.
double max(double a, double b) noexcept { return a < b ? b : a; }
double min(double a, double b) noexcept { return b < a ? b : a; }

double max_abs(const Vector3& x) noexcept {
  return max(std::fabs(x.x()), max(std::fabs(x.y()), std::fabs(x.z())));
}

double dot(const Vector3& a, const Vector3& b) noexcept {
  return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}

double length(const Vector3& a) noexcept { return std::sqrt(dot(a, a)); }

// The fixed order of the roles that makes the swap law hold bit for bit: it looks at nothing that scaling by
// 2^k or reversing an axis changes. True where b comes first.
bool out_of_order(const Prepared& a, const Prepared& b) noexcept {
  if (a.radius != b.radius) return a.radius > b.radius;
  if (a.height != b.height) return a.height > b.height;
  for (int i = 0; i < 3; ++i)
    if (a.unit_axis[i] != b.unit_axis[i]) return a.unit_axis[i] > b.unit_axis[i];
  for (int i = 0; i < 3; ++i)
    if (a.center[i] != b.center[i]) return a.center[i] > b.center[i];
  return false;
}

// The pair in a unit of 2^exponent in which nothing below overflows or loses digits to underflow: the scene's
// own where both solids are ordinary (prepare), else the one in which the largest of radii, heights and
// |Delta| is in [1, 2). Powers of two change no digit, so which of the two it is cannot be seen in an answer.
struct Scaled {
  const Vector3 &w0, &w1;
  Vector3 delta;
  double r0, h0, r1, h1;  // h0, h1: half heights
  int exponent;
};

// Both ordinary.
Scaled as_it_is(const Prepared& a, const Prepared& b) noexcept {
  return {a.unit_axis,    b.unit_axis, b.center - a.center, a.radius,
          a.height * 0.5, b.radius,    b.height * 0.5,      0};
}

Scaled scale(const Prepared& a, const Prepared& b) noexcept {
  if (a.ordinary && b.ordinary) return as_it_is(a, b);
  const double widest = max(max(a.radius, b.radius), max(a.height, b.height));
  Vector3 delta = b.center - a.center;
  double most = max(widest, max_abs(delta));
  // `before` brings back a Delta that overflowed (what vanishes beside it does not matter) and lifts
  // subnormal pairs, so that one normal factor brings the rest to 1.
  int shift = 0;
  if (!(max_abs(delta) <= std::numeric_limits<double>::max()))
    shift = -100;
  else if (most < 0x1p-1000)
    shift = 200;
  double radius0 = a.radius, height0 = a.height, radius1 = b.radius, height1 = b.height;
  if (shift != 0) {
    const double before = power_of_two(shift);
    delta = shift < 0 ? Vector3(b.center * before - a.center * before) : Vector3(delta * before);
    radius0 *= before;
    height0 *= before;
    radius1 *= before;
    height1 *= before;
    most = max(widest * before, max_abs(delta));
  }
  int exponent = most > 0 ? exponent_of(most) : 0;
  if (exponent > 1022) exponent = 1022;
  const double unit = power_of_two(-exponent), half = unit * 0.5;
  return {a.unit_axis,    b.unit_axis,    delta * unit,   radius0 * unit,
          height0 * half, radius1 * unit, height1 * half, exponent - shift};
}

// f(D) < 0 beyond rounding (derivation.md, section 6).
bool separates(const Scaled& p, const Vector3& d) noexcept {
  const double reach = p.r0 + p.h0 + p.r1 + p.h1 + length(p.delta);
  const double f = p.r0 * length(d.cross(p.w0)) + p.h0 * std::fabs(dot(d, p.w0)) +
                   p.r1 * length(d.cross(p.w1)) + p.h1 * std::fabs(dot(d, p.w1)) - std::fabs(dot(d, p.delta));
  return f < -separation_error * length(d) * reach;
}

// x, from C0, lies inside both solids beyond rounding.
bool in_both(const Scaled& p, const Vector3& x) noexcept {
  const Vector3 y = x - p.delta;
  const double e = membership_error * (length(x) + length(p.delta)) + underflow_error;
  return std::fabs(dot(x, p.w0)) + e < p.h0 && length(x.cross(p.w0)) + e < p.r0 &&
         std::fabs(dot(y, p.w1)) + e < p.h1 && length(y.cross(p.w1)) + e < p.r1;
}

// The answer under construction: verdicts come out at once, or only where their certificate holds.
template <bool prove>
struct Attempt {
  const Scaled& p;
  Vector3 base;  // C0, in the scene's unit
  Answer answer;

  // `direction` makes the certificate, where one is asked for.
  template <class Direction>
  bool disjoint(Direction&& make) noexcept {
    if constexpr (prove) {
      const Vector3 direction = make();
      if (!separates(p, direction)) return false;
      answer.proof = Proof::direction;
      answer.direction = dot(direction, p.delta) < 0 ? Vector3(-direction) : direction;
    }
    answer.verdict = Verdict::disjoint;
    return true;
  }

  template <class Point>
  bool intersecting(Point&& make) noexcept {
    if constexpr (prove) {
      const Vector3 x = make();
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
  const double along = dot(p.delta, w), distance = length(p.delta.cross(w));
  const bool beyond = std::fabs(along) > p.h0 + p.h1, beside = distance > p.r0 + p.r1;
  auto across = [&] { return Vector3((p.delta - along * w) / distance); };
  if (beyond && attempt.disjoint([&] { return along > 0 ? w : Vector3(-w); })) return;
  if (beside && attempt.disjoint(across)) return;
  if (beyond || beside) return;
  attempt.intersecting([&] {
    auto middle = [](double reach0, double center1, double reach1) {
      return (max(-reach0, center1 - reach1) + min(reach0, center1 + reach1)) / 2;
    };
    Vector3 x = middle(p.h0, along, p.h1) * w;
    if (distance > 0) x += middle(p.r0, distance, p.r1) * across();
    return x;
  });
}

// One piece g(u) = a b0(u) + b b1(z-u) - k of the slice formulation.
struct Piece {
  double a, b, k;
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
double ratio(double u, double b, double r) noexcept { return r > 0 ? u / max(b, r * 0x1p-27) : 0; }

Slice evaluate(const Scaled& p, const Piece* pieces, double z, double u) noexcept {
  Slice t;
  t.u = u;
  const double v = z - u;
  t.b0 = std::sqrt(max(0.0, (p.r0 - u) * (p.r0 + u)));
  t.b1 = std::sqrt(max(0.0, (p.r1 - v) * (p.r1 + v)));
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

// w0 x w1 from the sum and the difference of the axes (one taken backwards where they are opposite): but for
// the rounding of their lengths those two are perpendicular, so their cross product is accurate relative to
// its own length. Swapping the roles or reversing an axis changes at most the sign of `cross`.
struct Axes {
  Axes(const Vector3& w0, const Vector3& w1) noexcept : cosine(dot(w0, w1)) {
    const Vector3 aligned = w1 * std::copysign(1.0, cosine);  // no branch: the data would decide it
    sum = w0 + aligned;
    cross = (w0 - aligned).cross(sum);
    square = dot(cross, cross);
  }
  // Below an angle of 2^-49 the difference may be mostly one of the rounded lengths, and the cross product
  // noise. Taking such axes as parallel moves no point of a solid by more than 2^-50 of its height.
  bool parallel() const noexcept { return square < 0x1p-96; }

  double cosine;
  Vector3 sum, cross;  // cross = 2 w0 x w1 up to sign
  double square;       // |cross|^2
};

// Axes that are not parallel: the common normal and what the slices need of it.
struct Frame {
  Frame(const Scaled& p, const Axes& axes) noexcept {
    const double length = std::sqrt(axes.square), inverse = 1 / length, beside = dot(p.delta, axes.cross);
    s = length / 2;
    c = std::fabs(axes.cosine);
    n = axes.cross * std::copysign(inverse, beside);
    z = std::fabs(beside) * inverse;
    m0 = p.w0.cross(n);
    m1 = p.w1.cross(n);
    d[0] = dot(p.delta, p.w0);
    d[1] = dot(p.delta, p.w1);
    d[2] = dot(p.delta, m0);
    d[3] = dot(p.delta, m1);
    pieces[0] = {0, s, std::fabs(d[0]) - p.h0 - p.h1 * c};
    pieces[1] = {s, 0, std::fabs(d[1]) - p.h1 - p.h0 * c};
    pieces[2] = {1, c, std::fabs(d[2]) - p.h1 * s};
    pieces[3] = {c, 1, std::fabs(d[3]) - p.h0 * s};
    most[0] = s * p.r1;
    most[1] = s * p.r0;
    most[2] = p.r0 + c * p.r1;
    most[3] = c * p.r0 + p.r1;
  }

  Vector3 n, m0, m1;  // n.Delta >= 0
  double z, s, c;
  double d[4];      // Delta along w0, w1, m0, m1
  Piece pieces[4];  // in that order
  double most[4];   // of a b0 + b b1
};

// Five rejections in one branch and one slice in another: they decide most pairs, and a branch that the data
// decides costs more than the arithmetic. At u = z r0/(r0 + r1) both widths are their radius times sqrt(1 -
// (z/(r0 + r1))^2). Symmetric in the roles bit for bit, as Frame is.
Verdict at_first_sight(const Scaled& p, const Frame& f) noexcept {
  const double radii = p.r0 + p.r1, share = f.z / radii, q = std::sqrt((1 - share) * (1 + share));
  const bool apart = (f.z > radii) | (f.pieces[0].k > f.most[0]) | (f.pieces[1].k > f.most[1]) |
                     (f.pieces[2].k > f.most[2]) | (f.pieces[3].k > f.most[3]);
  const bool met = (f.pieces[0].k <= q * f.most[0]) & (f.pieces[1].k <= q * f.most[1]) &
                   (f.pieces[2].k <= q * f.most[2]) & (f.pieces[3].k <= q * f.most[3]);
  if (apart | met) return apart ? Verdict::disjoint : Verdict::intersecting;
  return Verdict::undecided;
}

template <bool prove>
void decide_crossing(Attempt<prove>& attempt, const Frame& f) noexcept {
  // Radii whose squares underflow are 0 to the search; the certificates are checked with what they are.
  Scaled p = attempt.p;
  if (p.r0 < 0x1p-400) p.r0 = 0;
  if (p.r1 < 0x1p-400) p.r1 = 0;
  const Vector3 &n = f.n, &m0 = f.m0, &m1 = f.m1;
  const double z = f.z, radii = p.r0 + p.r1;
  const Piece* pieces = f.pieces;
  // e_j, pointing from a to b.
  auto e = [&](int j) {
    const Vector3& axis = j == 0 ? p.w0 : j == 1 ? p.w1 : j == 2 ? m0 : m1;
    return f.d[j] < 0 ? Vector3(-axis) : axis;
  };
  if (z > radii && attempt.disjoint([&] { return n; })) return;
  for (int j = 0; j < 4; ++j)
    if (pieces[j].k > f.most[j] && attempt.disjoint([&] { return e(j); })) return;

  const double lo = max(-p.r0, z - p.r1), hi = min(p.r0, z + p.r1);
  if (lo > hi) {
    // Only where z > r0 + r1, or within rounding of it.
    if constexpr (!prove) attempt.answer.verdict = Verdict::disjoint;
    return;
  }

  const double resolution = radii * unit_roundoff_error;
  double u = radii > 0 ? z * (p.r0 / radii) : 0;
  u = min(max(u, lo), hi);

  Slice left{}, right{};  // the bracket: slope > 0 at left, < 0 at right
  bool has_left = false, has_right = false;
  int misses = 0;     // steps since the bracket last halved
  int midpoints = 0;  // steps towards an end that has not been looked at
  double width = hi - lo;

  for (int& i = attempt.answer.iterations; i < iteration_cap; ++i) {
    const Slice t = evaluate(p, pieces, z, u);
    if (t.g >= 0) {
      double x = 0, y = 0;
      if ((!prove || common_point(p, m0, m1, t.b0, t.b1, x, y)) &&
          attempt.intersecting([&] { return Vector3(x * p.w0 + y * m0 + u * n); }))
        return;
    }

    // The tangent of piece j at u bounds g from above. Where the tangents of both sides, slopes balanced by
    // lambda, stay below 0, D = lambda e_j + (1 - lambda) e_k + t n separates. t follows from either solid;
    // at the tip of one (its width 0, its slope without bound) from the other.
    const Piece& piece = pieces[t.active];
    const bool at_end = (t.slope > 0 && u >= hi) || (t.slope < 0 && u <= lo) || t.slope == 0 || lo == hi;
    if (at_end) {
      if (t.g >= 0) {
        // Only when proving. At a tip a width is 0, and so is the room around any point: the slices further
        // in are lower and wider.
        const double inwards = (u >= hi ? lo : hi) - u;
        for (int halvings = 1; halvings < 40 && inwards != 0; ++halvings) {
          const double v = u + std::ldexp(inwards, -halvings);
          const Slice inner = evaluate(p, pieces, z, v);
          double x = 0, y = 0;
          if (inner.g >= 0 && common_point(p, m0, m1, inner.b0, inner.b1, x, y) &&
              attempt.intersecting([&] { return Vector3(x * p.w0 + y * m0 + v * n); }))
            return;
        }
        return;
      }
      const double tilt = t.b0 <= t.b1 ? piece.b * t.p1 : piece.a * t.p0;
      if (attempt.disjoint([&] { return Vector3(e(t.active) + tilt * n); })) return;
      attempt.disjoint([&] { return n; });  // both widths 0: D -> n
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
      const double gap = right.u - left.u;
      const double rise = left.slope, fall = -right.slope;
      const double lambda = fall / (rise + fall);
      const double bound = lambda * (left.g + left.slope * gap) + (1 - lambda) * right.g;
      if (bound < 0 && attempt.disjoint([&] {
            const Piece &j = pieces[left.active], &k = pieces[right.active];
            const bool tip0 = min(left.b0, right.b0) * p.r1 <= min(left.b1, right.b1) * p.r0;
            const double tilt = tip0 ? lambda * j.b * left.p1 + (1 - lambda) * k.b * right.p1
                                     : lambda * j.a * left.p0 + (1 - lambda) * k.a * right.p0;
            return Vector3(lambda * e(left.active) + (1 - lambda) * e(right.active) + tilt * n);
          }))
        return;
      if (gap <= resolution) break;
      misses = gap <= width / 2 ? 0 : misses + 1;
      if (misses == 0) width = gap;
      next = left.u + (right.g - left.g + fall * gap) / (rise + fall);
      if (misses >= 2 || !(next > left.u && next < right.u)) next = left.u + gap / 2;
      if (!(next > left.u && next < right.u)) break;
    } else {
      // One side is an end not looked at: the tangent's height there bounds everything.
      const double end = has_left ? hi : lo;
      if (t.g + t.slope * (end - u) < 0 && attempt.disjoint([&] {
            const bool tip0 = has_left ? hi == p.r0 : lo == -p.r0;
            return Vector3(e(t.active) + (tip0 ? piece.b * t.p1 : piece.a * t.p0) * n);
          }))
        return;
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
  Answer answer;
  if ((a.defect != Defect::none) | (b.defect != Defect::none)) {
    answer.verdict = Verdict::invalid;
    return answer;
  }
  const bool swapped = out_of_order(a, b);
  const Prepared& first = swapped ? b : a;
  const Prepared& second = swapped ? a : b;
  const Axes axes(first.unit_axis, second.unit_axis);
  const Scaled p = scale(first, second);
  Attempt<prove> attempt{p, first.center, answer};
  if (axes.parallel())
    decide_parallel(attempt, axes.sum);
  else
    decide_crossing(attempt, Frame(p, axes));
  if (swapped) attempt.answer.direction = -attempt.answer.direction;
  return attempt.answer;
}

}  // namespace

Prepared prepare(const Cylinder& c) noexcept {
  Prepared p{c.center, {0, 0, 1}, c.radius, c.height, find_defect(c), false};
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
  // The solid does not know which way its axis points; here its first coordinate that is not 0 is positive.
  const double first = w.x() != 0 ? w.x() : w.y() != 0 ? w.y() : w.z();
  p.unit_axis = w / std::copysign(length(w), first);
  // Coordinates below 2^-200 go: no angle shows them, and products with them could underflow.
  for (int i = 0; i < 3; ++i)
    if (std::fabs(p.unit_axis[i]) < 0x1p-200) p.unit_axis[i] = 0;  // never -0

  auto within = [](double x, double limit) {
    const double size = std::fabs(x);
    return (size == 0) | ((size >= 1 / limit) & (size <= limit));
  };
  p.ordinary = within(c.center.x(), 0x1p250) & within(c.center.y(), 0x1p250) & within(c.center.z(), 0x1p250) &
               within(c.radius, 0x1p200) & within(c.height, 0x1p200);
  return p;
}

Verdict intersect(const Prepared& a, const Prepared& b) noexcept {
  const Axes axes(a.unit_axis, b.unit_axis);
  if (a.defect == Defect::none && b.defect == Defect::none && !axes.parallel()) {
    const Scaled p = scale(a, b);
    const Verdict seen = at_first_sight(p, Frame(p, axes));
    if (seen != Verdict::undecided) return seen;
  }
  return run<false>(a, b).verdict;
}
Verdict intersect(const Cylinder& a, const Cylinder& b) noexcept { return intersect(prepare(a), prepare(b)); }
Answer decide(const Prepared& a, const Prepared& b) noexcept { return run<true>(a, b); }
Answer decide(const Cylinder& a, const Cylinder& b) noexcept { return decide(prepare(a), prepare(b)); }

}  // namespace cyl
