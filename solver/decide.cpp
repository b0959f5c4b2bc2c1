// SPDX-License-Identifier: MIT
// The verdict with its proof. Symbols as in derivation.md. Whatever the search does here, what is handed out
// has passed a check with a rounding bound; what has not is `undecided`.
#include "solver/decide.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "solver/frame.hpp"
#include "solver/sections.hpp"

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

Vector3 axis0(const Couple<double>& p) noexcept { return {p.w0x, p.w0y, p.w0z}; }
Vector3 axis1(const Couple<double>& p) noexcept { return {p.w1x, p.w1y, p.w1z}; }
Vector3 delta_of(const Couple<double>& p) noexcept { return {p.dx, p.dy, p.dz}; }

double reach_of(const Couple<double>& p) noexcept { return p.r0 + p.h0 + p.r1 + p.h1 + length(delta_of(p)); }

// f(D) < 0 beyond rounding (derivation.md, section 7).
bool separates(const Couple<double>& p, const Vector3& d) noexcept {
  const Vector3 w0 = axis0(p), w1 = axis1(p);
  const double f = p.r0 * length(d.cross(w0)) + p.h0 * std::fabs(dot(d, w0)) + p.r1 * length(d.cross(w1)) +
                   p.h1 * std::fabs(dot(d, w1)) - std::fabs(dot(d, delta_of(p)));
  return f < -separation_error * length(d) * reach_of(p);
}

// x, from C0, lies inside both solids beyond rounding.
bool in_both(const Couple<double>& p, const Vector3& x) noexcept {
  const Vector3 w0 = axis0(p), w1 = axis1(p), delta = delta_of(p), y = x - delta;
  const double e = membership_error * (length(x) + length(delta)) + underflow_error;
  const double room0 = p.r0 - e, room1 = p.r1 - e;
  const Vector3 across0 = x.cross(w0), across1 = y.cross(w1);
  return (std::fabs(dot(x, w0)) + e < p.h0) & (std::fabs(dot(y, w1)) + e < p.h1) & (room0 > 0) &
             (room1 > 0) &&
         (length(across0) < room0) & (length(across1) < room1);
}

Answer disjoint(const Couple<double>& p, const Vector3& direction) noexcept {
  Answer answer;
  answer.verdict = Verdict::disjoint;
  answer.proof = Proof::direction;
  answer.direction = dot(direction, delta_of(p)) < 0 ? Vector3(-direction) : direction;
  return answer;
}

bool try_direction(const Couple<double>& p, Vector3 direction, Answer& answer) noexcept {
  // Weights are products of lengths; a direction has no unit.
  const double most = max_abs(direction);
  if (!(most >= 0x1p-900)) return false;
  direction *= power_of_two(-exponent_of(most));
  if (!separates(p, direction)) return false;
  answer = disjoint(p, direction);
  return true;
}

bool try_point(const Couple<double>& p, const Base& base, const Vector3& x, Answer& answer) noexcept {
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

// A rectangle in a plane: centre, half length along its first unit side, half length along the other.
struct Rectangle {
  double x, y;    // centre
  double ax, ay;  // first side; the other is (-ay, ax)
  double half0, half1;
};

struct PlanePoint {
  double x, y;
};

// The point of `share` times the rectangle nearest to q.
PlanePoint nearest(const Rectangle& r, PlanePoint q, double share) noexcept {
  const double dx = q.x - r.x, dy = q.y - r.y;
  const double along = dx * r.ax + dy * r.ay, across = dy * r.ax - dx * r.ay;
  const double a = smaller(larger(along, -share * r.half0), share * r.half0);
  const double b = smaller(larger(across, -share * r.half1), share * r.half1);
  return {r.x + a * r.ax - b * r.ay, r.y + a * r.ay + b * r.ax};
}

bool inside(const Rectangle& r, PlanePoint q) noexcept {
  const double dx = q.x - r.x, dy = q.y - r.y;
  return (std::fabs(dx * r.ax + dy * r.ay) < r.half0) & (std::fabs(dy * r.ax - dx * r.ay) < r.half1);
}

// Deep in both: rectangle 1 clipped by rectangle 0, the mean of what is left. False where nothing is left.
bool middle_of_overlap(const Rectangle& r0, const Rectangle& r1, PlanePoint& found) noexcept {
  const double ax = r1.half0 * r1.ax, ay = r1.half0 * r1.ay, bx = -r1.half1 * r1.ay, by = r1.half1 * r1.ax;
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
  clip(&PlanePoint::x, 1, r0.half0);
  clip(&PlanePoint::x, -1, r0.half0);
  clip(&PlanePoint::y, 1, r0.half1);
  clip(&PlanePoint::y, -1, r0.half1);
  if (count == 0) return false;
  found = {0, 0};
  for (int i = 0; i < count; ++i) {
    found.x += polygon[i].x / count;
    found.y += polygon[i].y / count;
  }
  return true;
}

// Common points of the slice at height u above C0.
bool try_slice(const Couple<double>& p, const Frame& frame, const Base& base, double u,
               Answer& answer) noexcept {
  const double v = frame.z - u;
  const double b0 = std::sqrt(larger(0, (p.r0 - u) * (p.r0 + u)));
  const double b1 = std::sqrt(larger(0, (p.r1 - v) * (p.r1 + v)));
  const Rectangle r0{0, 0, 1, 0, p.h0, b0};
  const Rectangle r1{frame.d[0], frame.d[2], dot(frame.w1, frame.w0), dot(frame.w1, frame.m0), p.h1, b1};
  auto attempt = [&](PlanePoint q) {
    return try_point(p, base, q.x * frame.w0 + q.y * frame.m0 + u * frame.n, answer);
  };
  // Most overlaps hold the point of one rectangle nearest to the other's centre, taken a little inwards.
  constexpr double inwards = 0.75;
  PlanePoint q = nearest(r0, {r1.x, r1.y}, inwards);
  for (int i = 0; i < 2; ++i) {
    if (inside(r1, q) && attempt(q)) return true;
    q = nearest(r1, q, inwards);
    if (inside(r0, q) && attempt(q)) return true;
    q = nearest(r0, q, inwards);
  }
  return middle_of_overlap(r0, r1, q) && attempt(q);
}

void prove_parallel(const Couple<double>& p, const Parallel& found, const Base& base,
                    Answer& answer) noexcept {
  if (found.stacked && try_direction(p, found.w, answer)) return;
  if (found.beside && try_direction(p, found.across(), answer)) return;
  if (found.stacked | found.beside) return;
  auto middle = [](double reach0, double center1, double reach1) {
    return (larger(-reach0, center1 - reach1) + smaller(reach0, center1 + reach1)) / 2;
  };
  Vector3 x = middle(p.h0, found.along, p.h1) * found.w;
  if (found.distance > 0) x += middle(p.r0, found.distance, p.r1) * found.across();
  try_point(p, base, x, answer);
}

// The middle of the slices where both widths suffice: those at most u from C0 and v from C1.
bool try_middle(const Couple<double>& p, const Frame& frame, const Base& base, double u, double v,
                Answer& answer) noexcept {
  return try_slice(p, frame, base, (larger(-u, frame.z - v) + smaller(u, frame.z + v)) / 2, answer);
}

// Where H is greatest there is the deepest slice, and the multipliers of the demands that hold it there are
// the weights of a direction (section 5).
void prove_at_optimum(const Couple<double>& p, const Frame& frame, const Base& base,
                      Answer& answer) noexcept {
  const Sections<double>& f = frame.f;
  auto combine = [&](int i, double weight_i, int j, double weight_j, double weight_n) {
    return Vector3(larger(0, weight_i) * frame.e(i) + larger(0, weight_j) * frame.e(j) + weight_n * frame.n);
  };
  const auto at = corner(f);
  if (at.met && try_middle(p, frame, base, at.u, at.v, answer)) return;
  if (!(at.rises2 | at.rises3)) {
    // Beside a tip (u or v is 0) the multipliers of the corner itself are without bound. Demanding less
    // leaves room for all directions.
    for (double share = 1; !at.met && share > 0.2; share /= 2) {
      const double x = share * at.x, y = share * at.y;
      double u = std::sqrt(larger(0, (p.r0 - x) * (p.r0 + x)));
      double v = std::sqrt(larger(0, (p.r1 - y) * (p.r1 + y)));
      if (!(x > 0 || u > 0)) u = 1;  // a segment: only x/u and y/v count
      if (!(y > 0 || v > 0)) v = 1;
      const double fall0 = x * v, fall1 = y * u, uv = u * v;
      const Vector3 direction = at.on2 & at.on3
                                    ? combine(2, fall0 - f.c * fall1, 3, fall1 - f.c * fall0, f.s2 * uv)
                                : at.on2 ? combine(2, f.s * fall0, 0, fall1 - f.c * fall0, f.s * uv)
                                : at.on3 ? combine(3, f.s * fall1, 1, fall0 - f.c * fall1, f.s * uv)
                                         : combine(1, fall0, 0, fall1, f.s * uv);
      if (try_direction(p, direction, answer)) return;
    }
    return;
  }
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
    else
      try_direction(p,
                    combine(line, f.s * (end.cb * end.u), at.rises2 ? 1 : 0,
                            e.c * (e.least * end.cv) - end.cb * end.u, e.c * f.s * (end.u * end.cv)),
                    answer);
    return;
  }
  const auto [least, first] = start(e);
  double t = first;
  int visits = 0;  // at the minimum
  for (int& i = answer.iterations; i < iteration_cap; ++i) {
    const auto now = step(e, least, t);
    Answer found;
    found.iterations = i + 1;
    if (now.apart) {
      // Far out F hardly falls any more; a smaller t weighs its depth against a shorter direction.
      const double tilt = smaller(t, (e.ra + e.rb) / -now.least);
      if (try_direction(p, frame.e(line) + tilt * frame.n, found)) {
        answer = found;
        return;
      }
    }
    if (now.met) {
      const double next = now.t;  // F is flat at its minimum, the slice is not: one step more
      const double u = e.ra * next / root(1 + next * next), v = e.rb * next / root(e.c * e.c + next * next);
      if (try_edge_point(u, v)) return;
    }
    if (now.found && ++visits > 2) return;
    t = now.t;
  }
}

// The five directions and the slice that decide most pairs.
bool prove_at_first_sight(const Couple<double>& p, const Frame& frame, const Base& base,
                          Answer& answer) noexcept {
  const Sections<double>& f = frame.f;
  const auto sight = at_first_sight(f);
  if (sight.apart) {
    const double most[] = {f.s * f.r1, f.s * f.r0, f.s * (f.r0 + f.c * f.r1), f.s * (f.c * f.r0 + f.r1)};
    const double k[] = {f.k0, f.k1, f.k2_s, f.k3_s};
    if (f.z_s > f.s * (f.r0 + f.r1) && try_direction(p, frame.n, answer)) return true;
    for (int j = 0; j < 4; ++j)
      if (k[j] > most[j] && try_direction(p, frame.e(j), answer)) return true;
    return false;
  }
  const double radii = f.r0 + f.r1;
  return sight.met && try_slice(p, frame, base, radii > 0 ? frame.z * (f.r0 / radii) : 0, answer);
}

}  // namespace

Answer decide(const Prepared& a, const Prepared& b) noexcept {
  Answer answer;
  if ((a.defect != Defect::none) | (b.defect != Defect::none)) {
    answer.verdict = Verdict::invalid;
    return answer;
  }
  const bool swapped = out_of_order(a, b);
  const Prepared& first = swapped ? b : a;
  const Prepared& second = swapped ? a : b;
  const Scaled scaled = scale(first, second);
  const Couple<double>& p = scaled.couple;
  const Base base{first.center, scaled.exponent};
  const Axes axes(first.unit_axis, second.unit_axis);
  if (axes.parallel()) {
    prove_parallel(p, Parallel(p, axes.sum), base, answer);
  } else {
    const Frame frame(p, axes);
    if (!prove_at_first_sight(p, frame, base, answer)) prove_at_optimum(p, frame, base, answer);
  }
  if (swapped) answer.direction = -answer.direction;
  return answer;
}

Answer decide(const Cylinder& a, const Cylinder& b) noexcept { return decide(prepare(a), prepare(b)); }

}  // namespace cyl
