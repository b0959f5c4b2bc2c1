// SPDX-License-Identifier: MIT
// The verdict with its proof. Symbols as in derivation.md. Whatever the search does here, what is handed out
// has passed a check with a rounding bound; what has not is `undecided`.
#include "solver/decide.hpp"

#include <Eigen/Geometry>
#include <bit>
#include <cmath>

#include "solver/detail/frame.hpp"
#include "solver/detail/iteration_cap.hpp"
#include "solver/detail/sections.hpp"

namespace cyl {
namespace {

// The centre of the solid whose frame is used; answers are given from it.
struct Base {
  const Vector3& center;
  int exponent;  // of the frame's unit
};

Vector3 times_power(const Vector3& x, int exponent) noexcept {
  if (exponent == 0) return x;
  return {std::ldexp(x.x(), exponent), std::ldexp(x.y(), exponent), std::ldexp(x.z(), exponent)};
}

double reach_of(const Scaled& p) noexcept { return p.r0 + p.h0 + p.r1 + p.h1 + length(p.delta); }

// f(D) < 0 beyond rounding (derivation.md, section 8).
bool separates(const Scaled& p, const Vector3& d) noexcept {
  const double f = p.r0 * length(d.cross(p.w0)) + p.h0 * std::fabs(dot(d, p.w0)) +
                   p.r1 * length(d.cross(p.w1)) + p.h1 * std::fabs(dot(d, p.w1)) - std::fabs(dot(d, p.delta));
  return f < -separation_error * length(d) * reach_of(p);
}

// x, from C0, lies inside both solids beyond rounding.
bool in_both(const Scaled& p, const Vector3& x) noexcept {
  const Vector3 y = x - p.delta;
  const double e = membership_error * (length(x) + length(p.delta)) + underflow_error;
  const double room0 = p.r0 - e, room1 = p.r1 - e;
  const Vector3 across0 = x.cross(p.w0), across1 = y.cross(p.w1);
  const bool along = (std::fabs(dot(x, p.w0)) + e < p.h0) && (std::fabs(dot(y, p.w1)) + e < p.h1);
  return along && room0 > 0 && room1 > 0 && length(across0) < room0 && length(across1) < room1;
}

bool try_direction(const Scaled& p, Vector3 direction, Answer& answer) noexcept {
  // Weights are products of lengths; a direction has no unit.
  const double most = max_abs(direction);
  if (!(most >= 0x1p-900)) return false;
  direction *= power_of_two(-exponent_of(most));
  if (!separates(p, direction)) return false;
  answer.verdict = Verdict::disjoint;
  answer.proof = Proof::direction;
  answer.direction = dot(direction, p.delta) < 0 ? Vector3(-direction) : direction;
  return true;
}

bool try_point(const Scaled& p, const Base& base, const Vector3& x, Answer& answer) noexcept {
  // The certificate is what is handed out, so that is what gets checked: back in the scene's unit, where a
  // subnormal coordinate may have lost bits.
  const Vector3 tail = times_power(x, base.exponent);
  if (!in_both(p, times_power(tail, -base.exponent))) return false;
  answer.verdict = Verdict::intersecting;
  answer.proof = Proof::point;
  answer.point_head = base.center;
  answer.point_tail = tail;
  return true;
}

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
PlanePoint on_long_side(const Rectangle& r, const Rectangle& other) noexcept {
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
  const double t = (lo + hi) / 2;
  return {r.x + ox + t * lx, r.y + oy + t * ly};
}

// Deep in both: rectangle 1 clipped by rectangle 0, the mean of what is left. False where nothing is left.
bool middle_of_overlap(const Rectangle& r0, const Rectangle& r1, PlanePoint& found) noexcept {
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
      if (d0 >= 0 && n < 8) kept[n++] = from;
      if ((d0 > 0 && d1 < 0) || (d0 < 0 && d1 > 0)) {
        const double t = d0 / (d0 - d1);
        if (n < 8) kept[n++] = {from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)};
      }
    }
    count = n;
    for (int i = 0; i < n; ++i) polygon[i] = kept[i];
  };
  clip(&PlanePoint::x, 1, r0.along);
  clip(&PlanePoint::x, -1, r0.along);
  clip(&PlanePoint::y, 1, r0.across);
  clip(&PlanePoint::y, -1, r0.across);
  if (count == 0) return false;
  found = {0, 0};
  for (int i = 0; i < count; ++i) {
    found.x += polygon[i].x / count;
    found.y += polygon[i].y / count;
  }
  return true;
}

// Common points of the slice at height u above C0.
bool try_slice(const Scaled& p, const Frame& frame, const Base& base, double u, Answer& answer) noexcept {
  const double v = frame.z - u;
  const double b0 = std::sqrt(larger(0, (p.r0 - u) * (p.r0 + u)));
  const double b1 = std::sqrt(larger(0, (p.r1 - v) * (p.r1 + v)));
  const Rectangle r0{0, 0, 1, 0, p.h0, b0};
  const Rectangle r1{frame.d[0], frame.d[2], dot(frame.w1, frame.w0), dot(frame.w1, frame.m0), p.h1, b1};
  auto attempt = [&](PlanePoint q) {
    return try_point(p, base, q.x * frame.w0 + q.y * frame.m0 + u * frame.n, answer);
  };
  PlanePoint q;
  return attempt(on_long_side(r0, r1)) || attempt(on_long_side(r1, r0)) ||
         (middle_of_overlap(r0, r1, q) && attempt(q));
}

void prove_parallel(const Scaled& p, const Parallel& found, const Base& base, Answer& answer) noexcept {
  if (found.stacked && try_direction(p, found.w, answer)) return;
  if (found.beside && try_direction(p, found.across(), answer)) return;
  if (found.stacked | found.beside) return;
  Vector3 x = middle_of_both(p.h0, found.along, p.h1) * found.w;
  if (found.distance > 0) x += middle_of_both(p.r0, found.distance, p.r1) * found.across();
  try_point(p, base, x, answer);
}

// The middle of the slices where both widths suffice: those at most u from C0 and v from C1.
bool try_middle(const Scaled& p, const Frame& frame, const Base& base, double u, double v,
                Answer& answer) noexcept {
  return try_slice(p, frame, base, middle_of_both(u, frame.z, v), answer);
}

// Widths x, y and half lengths u, v of two disks.
struct Widths {
  double x, u, y, v;
};

// Half lengths u and v at the widths demanded that leave a gap, u + v < z. Beside a tip (u or v is 0) the
// multipliers, x/u and y/v, are without bound. A quarter of the gap more for either, and the widths that go
// with it, demand less: with u' + v' < z still, their direction has f <= u' + v' - z, because r^2 - x' x <=
// u'^2 where x' <= x.
Widths beside_tips(double r0, double u, double r1, double v, double z) noexcept {
  const double spare = (z - (u + v)) / 4;
  u = larger(u, smaller(r0, spare));
  v = larger(v, smaller(r1, spare));
  return {std::sqrt((r0 - u) * (r0 + u)), u, std::sqrt((r1 - v) * (r1 + v)), v};
}

// weight_i e_i + weight_j e_j + weight_n n, in the cone of the demands.
Vector3 combine(const Frame& frame, int i, double weight_i, int j, double weight_j,
                double weight_n) noexcept {
  return larger(0, weight_i) * frame.e(i) + larger(0, weight_j) * frame.e(j) + weight_n * frame.n;
}

// The direction whose weights are the multipliers of the demands that hold the corner, which has no slice.
void separate_at_corner(const Scaled& p, const Frame& frame, const Corner<double, int>& at,
                        Answer& answer) noexcept {
  const Sections<double>& f = frame.f;
  auto try_widths = [&](double x, double u, double y, double v) {
    if (!(x > 0 || u > 0)) u = 1;  // a segment: only x/u and y/v count
    if (!(y > 0 || v > 0)) v = 1;
    const double fall0 = x * v, fall1 = y * u, uv = u * v;
    const Vector3 direction = at.on2 & at.on3
                                  ? combine(frame, 2, fall0 - f.c * fall1, 3, fall1 - f.c * fall0, f.s2 * uv)
                              : at.on2 ? combine(frame, 2, f.s * fall0, 0, fall1 - f.c * fall0, f.s * uv)
                              : at.on3 ? combine(frame, 3, f.s * fall1, 1, fall0 - f.c * fall1, f.s * uv)
                                       : combine(frame, 1, fall0, 0, fall1, f.s * uv);
    return try_direction(p, direction, answer);
  };
  const auto [x, u, y, v] = beside_tips(p.r0, at.u, p.r1, at.v, at.z);
  if (try_widths(x, u, y, v)) return;
  // Where a demand is more than a radius, or the multipliers of these leave the cone of the demands':
  // demanding less leaves room for all directions.
  for (double share = 1; share > 0.2; share /= 2) {
    const double less0 = share * at.x, less1 = share * at.y;
    if (try_widths(less0, std::sqrt(larger(0, (p.r0 - less0) * (p.r0 + less0))), less1,
                   std::sqrt(larger(0, (p.r1 - less1) * (p.r1 + less1)))))
      return;
  }
}

// Up the line along which H rises from the corner.
void prove_on_edge(const Scaled& p, const Frame& frame, const Base& base, const Corner<double, int>& at,
                   Answer& answer) noexcept {
  const int line = at.rises2 ? 2 : 3;
  const Edge<double> e = edge(at);
  // u and v as the edge has them: of solid a, of solid b.
  auto try_edge_point = [&](double u, double v) {
    return at.rises2 ? try_middle(p, frame, base, u, v, answer) : try_middle(p, frame, base, v, u, answer);
  };
  const auto end = top(e);
  if (end.here) {
    if (end.met)
      try_edge_point(end.u, end.cv / e.c);
    else {
      const auto [x, u, y, v] = beside_tips(e.ra, end.u, e.rb, end.cv / e.c, e.z);
      const double slope = x > 0 || u > 0 ? u : 1, cb = e.c * y, cv = e.c * v;
      try_direction(p,
                    combine(frame, line, frame.f.s * (cb * slope), at.rises2 ? 1 : 0,
                            e.c * (x * cv) - cb * slope, e.c * frame.f.s * (slope * cv)),
                    answer);
    }
    return;
  }
  const auto [low, first] = start(e);
  double t = first;
  int misses = 0;  // verdicts whose certificate did not hold
  while (answer.iterations < iteration_cap && misses <= 3) {
    ++answer.iterations;
    const auto now = step(e, low, t);
    if (now.apart) {
      // Far out F hardly falls any more; a smaller t weighs its depth against a shorter direction.
      const double tilt = smaller(t, (e.ra + e.rb) / -now.min_gap);
      if (try_direction(p, frame.e(line) + tilt * frame.n, answer)) return;
    }
    if (now.met) {
      const double next = now.t;  // F is flat at its minimum, the slice is not: one step more
      const double u = e.ra * next / root(1 + next * next), v = e.rb * next / root(e.c * e.c + next * next);
      if (try_edge_point(u, v)) return;
    }
    misses += now.found | now.apart;
    t = now.t;
  }
}

// Where H is greatest there is the deepest slice, and the multipliers of the demands that hold it there are
// the weights of a direction (section 7).
void prove_at_optimum(const Scaled& p, const Frame& frame, const Base& base, Answer& answer) noexcept {
  const auto at = corner(frame.f);
  if (at.met && try_middle(p, frame, base, at.u, at.v, answer)) return;
  if (at.rises2 | at.rises3) prove_on_edge(p, frame, base, at, answer);
  // Also where the edge gave no proof: with axes all but square its first steps are shorter than a rounding
  // of the widths, and H at the corner is as great as anywhere.
  if (answer.proof == Proof::none && !at.met) separate_at_corner(p, frame, at, answer);
}

// The five directions and the slice that decide most pairs.
bool prove_by_filter(const Scaled& p, const Frame& frame, const Base& base, Answer& answer) noexcept {
  const Sections<double>& f = frame.f;
  const auto filter = separating_axis_filter(f);
  if (filter.apart) {
    const double most[] = {f.s * f.r1, f.s * f.r0, f.s * (f.r0 + f.c * f.r1), f.s * (f.c * f.r0 + f.r1)};
    const double k[] = {f.k0, f.k1, f.k2_s, f.k3_s};
    if (f.z_s > f.s * (f.r0 + f.r1) && try_direction(p, frame.n, answer)) return true;
    for (int j = 0; j < 4; ++j)
      if (k[j] > most[j] && try_direction(p, frame.e(j), answer)) return true;
    return false;
  }
  const double radii = f.r0 + f.r1;
  return filter.met && try_slice(p, frame, base, radii > 0 ? frame.z * (f.r0 / radii) : 0, answer);
}

// The filter's own numbers as proof that the solids are apart, where they show it by more than rounding.
[[gnu::always_inline]] inline bool prove_apart_by_filter(const Couple<double>& p, const Products<double>& q,
                                                         const Sections<double>& f, double reach,
                                                         Answer& answer) noexcept {
  const double error = filter_error * reach;
  const unsigned beyond = (f.z_s - f.s * (p.r0 + p.r1) > error ? 1u : 0u) |
                          (f.k0 - f.s * p.r1 > error ? 2u : 0u) | (f.k1 - f.s * p.r0 > error ? 4u : 0u) |
                          (f.k2_s - f.s * (p.r0 + f.c * p.r1) > error ? 8u : 0u) |
                          (f.k3_s - f.s * (f.c * p.r0 + p.r1) > error ? 16u : 0u);
  if (beyond == 0) return false;
  // n, w0, w1, m0 and m1 as sums of w0, w1 and n. A table, since which of them it is nobody can predict.
  const double weights[5][3] = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {q.cosine, -1, 0}, {-1, q.cosine, 0}};
  const double along[5] = {q.dn, q.d0, q.d1, q.cosine * q.d0 - q.d1, q.cosine * q.d1 - q.d0};
  const int j = std::countr_zero(beyond);
  const double sign = std::copysign(1.0, along[j]);
  const double a = sign * weights[j][0], b = sign * weights[j][1], n = sign * weights[j][2];
  answer.verdict = Verdict::disjoint;
  answer.proof = Proof::direction;
  answer.direction = {a * p.w0x + b * p.w1x + n * q.nx, a * p.w0y + b * p.w1y + n * q.ny,
                      a * p.w0z + b * p.w1z + n * q.nz};
  return true;
}

// The common case, where the separating-axis filter decides by more than rounding and the numbers it compared
// are proof enough (section 8): ordinary solids, axes at an angle.
[[gnu::always_inline]] inline bool prove_on_fast_path(const Couple<double>& p, const Base& base,
                                                      Answer& answer) noexcept {
  const Products<double> q = products(p);
  if (!(magnitude(q.cosine) <= steep_cosine)) return false;
  const Sections<double> f = sections(p, q);
  const auto filter = separating_axis_filter(f);
  const double radii = p.r0 + p.r1;
  const double reach = radii + p.h0 + p.h1 + std::fabs(p.dx) + std::fabs(p.dy) + std::fabs(p.dz);
  if (filter.apart) return prove_apart_by_filter(p, q, f, reach, answer);
  if (!filter.met) return false;
  // The slice at u, in coordinates along w0 and along (w1 - C w0)/s, in units of r0 + r1.
  const double inverse = 1 / f.s, unit = 1 / radii;
  const double h0 = p.h0 * unit, r0 = p.r0 * unit, h1 = p.h1 * unit, r1 = p.r1 * unit;
  const double z = f.z_s * inverse * unit, u = z * r0, v = z - u;
  const double along = q.d0 * unit, across = (q.d1 - q.cosine * q.d0) * inverse * unit;
  // The point where the squares of its coordinates in both rectangles, in units of their half lengths, sum up
  // to least: of the candidates tried the best that needs no case distinction. Weights times all squares, so
  // that there is one division.
  const double q2 = (1 - z) * (1 + z);
  const double hh0 = h0 * h0, bb0 = q2 * r0 * r0, hh1 = h1 * h1, bb1 = q2 * r1 * r1;
  const double first = hh0 * bb0, second = hh1 * bb1;
  const double along0 = bb0 * second, across0 = hh0 * second, along1 = bb1 * first, across1 = hh1 * first;
  const double c2 = f.c * f.c, xx = along1 * c2 + across1 * f.s2, yy = along1 * f.s2 + across1 * c2;
  const double xy = (along1 - across1) * (q.cosine * f.s);
  const double gx = xx * along + xy * across, gy = xy * along + yy * across;
  const double mx = xx + along0, my = yy + across0, solve = 1 / (mx * my - xy * xy);
  const double error = point_error * (reach * unit), room0 = r0 - error, room1 = r1 - error;
  const auto inside = [&](const PlanePoint& at) {
    const double dx = at.x - along, dy = at.y - across;
    const double x1 = dx * q.cosine + dy * f.s, y1 = dy * q.cosine - dx * f.s;
    return (std::fabs(at.x) < h0 - error) & (std::fabs(x1) < h1 - error) & (room0 > 0) & (room1 > 0) &
           (at.y * at.y + u * u < room0 * room0) & (y1 * y1 + v * v < room1 * room1);
  };
  PlanePoint at{(my * gx - xy * gy) * solve, (mx * gy - xy * gx) * solve};
  if (!inside(at)) {
    const double b = std::sqrt(positive(q2));
    const Rectangle rectangle0{0, 0, 1, 0, h0, b * r0}, rectangle1{along, across, q.cosine, f.s, h1, b * r1};
    at = on_long_side(rectangle0, rectangle1);
    if (!inside(at)) at = on_long_side(rectangle1, rectangle0);
    if (!inside(at)) return false;
  }
  const double w1 = at.y * inverse * radii, w0 = at.x * radii - w1 * q.cosine;
  const double n = u * radii * std::copysign(inverse, q.dn);
  answer.verdict = Verdict::intersecting;
  answer.proof = Proof::point;
  answer.point_head = base.center;
  answer.point_tail = {w0 * p.w0x + w1 * p.w1x + n * q.nx, w0 * p.w0y + w1 * p.w1y + n * q.ny,
                       w0 * p.w0z + w1 * p.w1z + n * q.nz};
  return true;
}

// Everything else.
[[gnu::noinline]] void prove_in_full(const Prepared& first, const Prepared& second, Answer& answer) noexcept {
  if ((first.defect != Defect::none) | (second.defect != Defect::none)) {
    answer.verdict = Verdict::invalid;
    return;
  }
  const Scaled p = scale(first, second);
  const Base base{first.center, p.exponent};
  // As decide() does with ordinary solids, so that the scene's unit cannot be seen in the answer; but where
  // it is so small that a point may lose bits when it goes back into it.
  if (!(first.ordinary & second.ordinary) && p.exponent > -900 &&
      prove_on_fast_path(p.couple(), base, answer)) {
    answer.point_tail = times_power(answer.point_tail, p.exponent);
    if (answer.point_tail.allFinite()) return;
    answer = Answer{};  // the largest double is near: other points may be nearer
  }
  const Axes axes(first.unit_axis, second.unit_axis);
  if (axes.parallel()) {
    prove_parallel(p, Parallel(p.delta, p.h0 + p.h1, p.r0 + p.r1, axes.sum), base, answer);
  } else {
    const Frame frame(p, axes);
    if (!prove_by_filter(p, frame, base, answer)) prove_at_optimum(p, frame, base, answer);
  }
}

}  // namespace

Answer decide(const Prepared& a, const Prepared& b) noexcept {
  Answer answer;
  bool swapped = a.radius > b.radius;
  if (a.radius == b.radius) swapped = out_of_order(a, b);
  // Looked up, since nobody can predict it.
  const Prepared* const roles[] = {&a, &b};
  const Prepared &first = *roles[swapped], &second = *roles[!swapped];
  if (!(a.ordinary & b.ordinary) ||
      !prove_on_fast_path(as_it_is(first, second).couple(), {first.center, 0}, answer))
    prove_in_full(first, second, answer);
  answer.direction *= 1 - 2 * static_cast<double>(swapped);
  return answer;
}

Answer decide(const Cylinder& a, const Cylinder& b) noexcept { return decide(prepare(a), prepare(b)); }

}  // namespace cyl
