// SPDX-License-Identifier: MIT
// Symbols as in distance.md.
#include "solver/distance.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "solver/detail/frame.hpp"

namespace cyl {
namespace {

double clamp(double x, double limit) noexcept { return larger(-limit, smaller(limit, x)); }

double support_gap(const Scaled& p, const Vector3& d) noexcept {
  return p.r0 * length(d.cross(p.w0)) + p.h0 * std::fabs(dot(d, p.w0)) + p.r1 * length(d.cross(p.w1)) +
         p.h1 * std::fabs(dot(d, p.w1)) - std::fabs(dot(d, p.delta));
}

// The point of a centred solid nearest to x.
Vector3 nearest(const Vector3& x, const Vector3& w, double r, double h) noexcept {
  const double along = dot(x, w);
  const Vector3 radial = x - along * w;
  const double square = dot(radial, radial);
  const double shrink = square > r * r ? r / std::sqrt(square) : 1;
  return clamp(along, h) * w + shrink * radial;
}

// Axes that are not parallel. Both are turned, and m0, m1 chosen perpendicular to them in their plane, so
// that
//   w0.w1 = c,  m0.w1 = m1.w0 = s,  m0.m1 = -c,  z = Delta.n >= 0,  e0 = Delta.m0 >= 0,  e1 = Delta.m1 >= 0.
struct TurnedFrame {
  TurnedFrame(const Scaled& p, const Axes& axes) noexcept {
    const double beside = dot(p.delta, axes.cross);
    s = std::sqrt(axes.square);
    n = axes.cross * std::copysign(1 / s, beside);
    z = std::fabs(beside) / s;
    m0 = p.w0.cross(n);
    m1 = p.w1.cross(n);
    const double turn0 = std::copysign(1.0, dot(p.delta, m0)), turn1 = std::copysign(1.0, dot(p.delta, m1));
    m0 *= turn0;
    m1 *= turn1;
    const double sign0 = std::copysign(1.0, dot(m1, p.w0)), sign1 = std::copysign(1.0, dot(m0, p.w1));
    w0 = p.w0 * sign0;
    w1 = p.w1 * sign1;
    const auto [along0, along1] = axes.along(p.delta);
    d0 = along0 * sign0;
    d1 = along1 * sign1;
    e0 = dot(p.delta, m0);
    e1 = dot(p.delta, m1);
    // At right angles within rounding: an angle of 2^-60 instead moves nothing, and no quotient below is 0/0.
    c = std::copysign(larger(std::fabs(axes.cosine), 0x1p-60), dot(w0, w1));
  }
  Vector3 n, w0, w1, m0, m1;
  double z, s, c, d0, d1, e0, e1;
};

constexpr int circle_step_cap = 60;  // 3 or 4 are usual

struct Turn {
  double x, y;
};

// Section 2. On the circle square to one axis: D = x n + y m, x and y >= 0. Beyond x = 1 the part of f that
// varies, r sqrt(x^2 + c^2 y^2) - z x - e y, has at most one minimum inside the quarter: E(t) = its
// derivative over x, t = y/x, is convex, and the minimum is at the larger root. {1, 0} where there is none.
Turn lowest_on_circle(double z, double e, double r, double s, double c, int& steps) noexcept {
  const double bend = r * s * s, cc = c * c;
  const double q1 = 1 / std::sqrt(1 + cc), g1 = z - e - bend * q1, slope1 = z - bend * (q1 * q1 * q1);
  if (g1 >= 0 && slope1 > 0) {
    double t = e > 0 ? e / (e + g1) : 1;
    for (int i = 0; i < circle_step_cap; ++i) {
      ++steps;
      const double q = 1 / std::sqrt(1 + cc * t * t);
      const double slope = z - bend * (q * q * q);
      if (!(slope > 0)) {
        if (i > 0 || t == 1) return {1, 0};
        t = 1;
        continue;
      }
      const double step = (z * t - e - bend * t * q) / slope;
      t -= step;
      if (!(t > 0)) return {1, 0};
      if (std::fabs(step) <= 0x1p-27 * t) break;
    }
    const double x = 1 / std::sqrt(1 + t * t);
    return {x, t * x};
  }
  double t = e > 0 && z > bend ? (z - bend) / e : 0;  // x/y here
  for (int i = 0; i < circle_step_cap; ++i) {
    ++steps;
    const double q = 1 / std::sqrt(t * t + cc);
    const double slope = e + bend * cc * (q * q * q);
    if (!(slope > 0)) return {1, 0};
    const double step = (z - e * t - bend * t * q) / slope;
    t = larger(0, t + step);
    if (std::fabs(step) <= 0x1p-27 * t || step == 0) break;
  }
  const double y = 1 / std::sqrt(1 + t * t);
  return {t * y, y};
}

// Two values of f within this times the reach may be the same: twice distance_error.
constexpr double tie_error = 2 * distance_error;

// Overlapping less than this times the reach may be not overlapping at all, with a direction badly known.
constexpr double shallow_tol = 0x1p-20;

constexpr int rim_step_cap = 60;    // of one rim on another; 6 to 10 are usual
constexpr int projection_cap = 60;  // of the points, where nothing else brought the bounds together

// A rim of each solid, and a point on each: (x, y) on (n, m0) and on (n, m1).
struct Rims {
  double side0, side1;  // which caps, along w0 and w1
  double x0, y0, x1, y1;
};

// (x, y) turned by about `angle` (its third order is off), still of unit length.
void turn(double& x, double& y, double x_old, double y_old, double angle) noexcept {
  const double q = angle / 2, i = 1 / (1 + q * q);
  x = ((1 - q * q) * x_old - 2 * q * y_old) * i;
  y = ((1 - q * q) * y_old + 2 * q * x_old) * i;
}

class Search {
 public:
  Search(const Scaled& p, const TurnedFrame& f) noexcept
      : p_(p), f_(f), reach_(p.r0 + p.h0 + p.r1 + p.h1 + length(p.delta)) {}

  // `decided`: what decide() says of the pair, asked where the features show no gap and next to no depth.
  template <class Decide>
  void run(Decide&& decided) noexcept {
    constexpr double doubt_tol = 0x1p-20;  // of reach
    if (look_at_features()) return;
    if (low_ >= 0 && low_ < doubt_tol * reach_) {
      // Outwards, square to the middle of the axes: rims of disks almost in one plane hide from Newton.
      const Vector3 along = f_.w0 + (f_.c < 0 ? -f_.w1 : f_.w1);
      const Vector3 outwards = p_.delta - dot(p_.delta, along) / dot(along, along) * along;
      consider(outwards, on0_, false);
      const Answer answer = decided();
      if (answer.proof == Proof::direction) consider(answer.direction, on0_, false);
    }
    if (low_ < 0) project();
  }

  void report(Distance& out) const noexcept {
    out.value = -low_;
    out.error = distance_error * reach_;
    out.direction = direction_;
    if (low_ < 0) {
      out.error += larger(0, high_ + low_);
      out.on_a = on0_;
      out.on_b = on1_ - p_.delta;
    } else {
      out.on_a = on_b_ ? Vector3(anchor_ + low_ * direction_) : anchor_;
      out.on_b = (on_b_ ? anchor_ : Vector3(anchor_ - low_ * direction_)) - p_.delta;
    }
    out.iterations = steps_;
  }

 private:
  // Takes a direction and a point, from C0, of one of the solids that goes with it, if they are better; true
  // where they prove the gap.
  bool consider(const Vector3& along, const Vector3& anchor, bool on_b) noexcept {
    const double size = length(along);
    if (!(size > 0)) return false;
    const Vector3 d = along * ((dot(along, p_.delta) < 0 ? -1 : 1) / size);
    const double f = support_gap(p_, d);
    if (f < low_) {
      low_ = f;
      direction_ = d;
      anchor_ = anchor;
      on_b_ = on_b;
    }
    // As low within rounding: the direction is the same, its point may be the better one.
    return f < 0 && f <= low_ + tie_error * reach_ && meet(anchor, on_b);
  }

  // Takes a point and its nearest one in the other solid, if they are nearer; true where they prove the gap.
  bool meet(const Vector3& anchor, bool on_b) noexcept {
    const Vector3 other = on_b ? nearest(anchor, p_.w0, p_.r0, p_.h0)
                               : Vector3(nearest(anchor - p_.delta, p_.w1, p_.r1, p_.h1) + p_.delta);
    const double distance = length(other - anchor);
    if (distance < high_) {
      high_ = distance;
      on0_ = on_b ? other : anchor;
      on1_ = on_b ? anchor : other;
    }
    return high_ + low_ <= tie_error * reach_;
  }

  bool look_at_features() noexcept {
    const Scaled& p = p_;
    const TurnedFrame& f = f_;
    // Sides: the direction n.
    const bool crossing = f.e0 <= p.h1 * f.s && f.e1 <= p.h0 * f.s;
    const double t1 = smaller(1, f.e0 / (p.h1 * f.s));
    if (crossing && consider(f.n, p.delta - t1 * p.h1 * f.w1 - p.r1 * f.n, true)) return true;
    // Caps.
    const double s0 = std::copysign(1.0, f.d0), s1 = std::copysign(1.0, f.d1), sc = std::copysign(1.0, f.c);
    const double c = std::fabs(f.c);
    const double q0 = f.e0 - sc * s0 * p.h1 * f.s + p.r1 * s0 * f.c;
    const double q1 = f.e1 - sc * s1 * p.h0 * f.s + p.r0 * s1 * f.c;
    const double far0 = f.z * f.z + q0 * q0, far1 = f.z * f.z + q1 * q1;
    const bool on_cap0 = far0 <= p.r0 * p.r0, on_cap1 = far1 <= p.r1 * p.r1;
    if (consider(s0 * f.w0, p.delta - sc * s0 * p.h1 * f.w1 - s0 * p.r1 * f.m1, true)) return true;
    if (consider(s1 * f.w1, sc * s1 * p.h0 * f.w0 + s1 * p.r0 * f.m0, false)) return true;
    // Circles.
    const Turn k0 = lowest_on_circle(f.z, f.e0 - p.h1 * f.s, p.r1, f.s, c, steps_);
    const double rho0 = std::sqrt(k0.x * k0.x + f.c * f.c * k0.y * k0.y);
    const double at0 = f.d0 - f.c * (p.h1 - p.r1 * f.s * k0.y / rho0);
    const double cx0 = k0.x / rho0, cy0 = -f.c * k0.y / rho0;  // rim point of 1 on (n, m1)
    if (k0.y > 0 &&
        consider(k0.x * f.n + k0.y * f.m0, p.delta - p.h1 * f.w1 - p.r1 * (cx0 * f.n + cy0 * f.m1), true))
      return true;
    const Turn k1 = lowest_on_circle(f.z, f.e1 - p.h0 * f.s, p.r0, f.s, c, steps_);
    const double rho1 = std::sqrt(k1.x * k1.x + f.c * f.c * k1.y * k1.y);
    const double at1 = -f.d1 + f.c * (p.h0 - p.r0 * f.s * k1.y / rho1);
    const double cx1 = k1.x / rho1, cy1 = -f.c * k1.y / rho1;
    if (k1.y > 0 && consider(k1.x * f.n + k1.y * f.m1, p.h0 * f.w0 + p.r0 * (cx1 * f.n + cy1 * f.m0), false))
      return true;
    // Rims.
    if (k0.y > 0 && std::fabs(at0) > p.h0 && look_at_rims({std::copysign(1.0, at0), 1, k0.x, k0.y, cx0, cy0}))
      return true;
    if (k1.y > 0 && std::fabs(at1) > p.h1 &&
        look_at_rims({1, -std::copysign(1.0, at1), cx1, cy1, k1.x, k1.y}))
      return true;
    // From a pole the facing rim starts at its lowest point; where the pole's point is just on its own rim
    // that is a stationary point of section 3 but perhaps no minimum, so that it starts beside it, too.
    constexpr double aside = 20.0 / 101, up = 99.0 / 101, tie_tol = 0x1p-20;  // of the squared radius
    const double i0 = 1 / std::sqrt(larger(far0, 0x1p-1000)), i1 = 1 / std::sqrt(larger(far1, 0x1p-1000));
    Rims pole0{s0, sc * s0, f.z * i0, q0 * i0, 0, s0}, pole1{sc * s1, s1, 0, s1, f.z * i1, q1 * i1};
    if (!on_cap0 && look_at_rims(pole0)) return true;
    if (!on_cap1 && look_at_rims(pole1)) return true;
    pole0.x1 = pole1.x0 = aside;
    pole0.y1 = up * s0;
    pole1.y0 = up * s1;
    if (std::fabs(far0 - p.r0 * p.r0) <= tie_tol * p.r0 * p.r0 && look_at_rims(pole0)) return true;
    if (std::fabs(far1 - p.r1 * p.r1) <= tie_tol * p.r1 * p.r1 && look_at_rims(pole1)) return true;
    return false;
  }

  // Section 3. Newton on |y|^2 over the two angles, y the vector from the point of rim 0 to that of rim 1.
  bool look_at_rims(Rims k) noexcept {
    const Scaled& p = p_;
    const TurnedFrame& f = f_;
    const double e0 = f.e0 - k.side1 * p.h1 * f.s, e1 = f.e1 - k.side0 * p.h0 * f.s;
    const double l0 = f.d0 - k.side0 * p.h0 - k.side1 * p.h1 * f.c;
    double yn, y0, y1, yw;      // y along n, m0, m1, w0
    double cn, cm, cw, square;  // the product of the tangents along n, m0, w0, and its square
    double last = std::numeric_limits<double>::infinity(), turn0 = 0, turn1 = 0, slack = 0;
    Rims kept = k;
    bool fine = false;
    for (int i = 0;; ++i) {
      ++steps_;
      yn = f.z - p.r0 * k.x0 - p.r1 * k.x1;
      y0 = e0 - p.r0 * k.y0 + p.r1 * f.c * k.y1;
      y1 = e1 + p.r0 * f.c * k.y0 - p.r1 * k.y1;
      yw = l0 - p.r1 * f.s * k.y1;
      cn = f.s * k.x0 * k.x1;
      cm = f.s * k.x1 * k.y0;
      cw = k.x0 * k.y1 + f.c * k.x1 * k.y0;
      square = cn * cn + cm * cm + cw * cw;
      if (fine || i == rim_step_cap) break;
      const double now = yn * yn + y0 * y0 + yw * yw;
      if (now > last * (1 + 0x1p-40)) {
        turn0 /= 4;
        turn1 /= 4;
      } else {
        last = now;
        kept = k;
        const double g0 = k.x0 * y0 - k.y0 * yn, g1 = k.x1 * y1 - k.y1 * yn;
        double u0 = k.x0 * yn + k.y0 * y0, u1 = k.x1 * yn + k.y1 * y1;
        const double bent = k.y0 * k.y1 - f.c * k.x0 * k.x1;
        const double across = p.r0 * p.r1 * square;
        // H of distance.md, section 3; where it is not positive, without what makes it so.
        double det = across + p.r0 * u1 + p.r1 * u0 + u0 * u1;
        if (!(p.r0 + u0 > 0 && det > 0)) {
          u0 = larger(u0, 0x1p-500);
          u1 = larger(u1, 0x1p-500);
          det = across + p.r0 * u1 + p.r1 * u0 + u0 * u1;
        }
        const double inverse = 1 / larger(det, 0x1p-1000);
        turn0 = clamp(((p.r1 + u1) * g0 - bent * p.r1 * g1) * inverse, 1);
        turn1 = clamp(((p.r0 + u0) * g1 - bent * p.r0 * g0) * inverse, 1);
        slack = larger(0x1p-40 * (det / ((p.r0 + u0) * (p.r1 + u1))), 0x1p-90);
      }
      fine = larger(turn0 * turn0, turn1 * turn1) <= slack;
      turn(k.x0, k.y0, kept.x0, kept.y0, turn0);
      turn(k.x1, k.y1, kept.x1, kept.y1, turn1);
    }
    // D is square to both tangents, and along y. Near contact y is mostly rounding, and where the tangents
    // are nearly parallel their product is.
    const Vector3 on0 = k.side0 * p.h0 * f.w0 + p.r0 * (k.x0 * f.n + k.y0 * f.m0);
    const Vector3 on1 = p.delta - k.side1 * p.h1 * f.w1 - p.r1 * (k.x1 * f.n + k.y1 * f.m1);
    const Vector3 product = cn * f.n + cw * f.w0 + cm * f.m0, y = yn * f.n + yw * f.w0 + y0 * f.m0;
    const bool near = square * (p.r0 + p.r1) * (p.r0 + p.r1) > yn * yn + y0 * y0 + yw * yw;
    if (consider(near ? product : y, on0, false)) return true;
    if (low_ > shallow_tol * reach_) return false;
    const Vector3 tangent0 = k.x0 * f.m0 - k.y0 * f.n, tangent1 = k.x1 * f.m1 - k.y1 * f.n;
    return consider(near ? y : product, on1, true) || consider(y - dot(y, tangent0) * tangent0, on0, false) ||
           consider(y - dot(y, tangent1) * tangent1, on1, true);
  }

  // From each solid to the other and back.
  void project() noexcept {
    for (int i = 0; i < projection_cap; ++i) {
      ++steps_;
      if (meet(on0_, false) || meet(on1_, true)) return;
    }
  }

  const Scaled& p_;
  const TurnedFrame& f_;
  double reach_;
  double low_ = std::numeric_limits<double>::infinity();   // least f seen
  double high_ = std::numeric_limits<double>::infinity();  // least distance of two points seen
  Vector3 direction_{0, 0, 0}, anchor_{0, 0, 0}, on0_{0, 0, 0}, on1_{0, 0, 0};
  bool on_b_ = false;
  int steps_ = 0;
};

// Parallel axes: apart along w, across it, or both.
void measure_parallel(const Scaled& p, const Vector3& axis_sum, Distance& out) noexcept {
  const Vector3 w = axis_sum / length(axis_sum);
  const double along = dot(p.delta, w);
  const Vector3 off = p.delta - along * w;
  const double across = length(off);
  // Any direction square to w where there is none.
  Vector3 u;
  if (across > 0) {
    u = off / across;
  } else {
    int least = 0;
    for (int i = 1; i < 3; ++i)
      if (std::fabs(w[i]) < std::fabs(w[least])) least = i;
    Vector3 unit(0, 0, 0);
    unit[least] = 1;
    u = w.cross(unit);
    u /= length(u);
  }
  const double beyond = std::fabs(along) - p.h0 - p.h1, beside = across - p.r0 - p.r1;
  const double sign = std::copysign(1.0, along);
  const bool by_caps = beyond > 0 || (beside <= 0 && beyond >= beside), by_sides = beside > 0 || !by_caps;
  const double along0 = by_caps ? sign * p.h0 : middle_of_both(p.h0, along, p.h1);
  const double along1 = by_caps ? -sign * p.h1 : along0 - along;
  const double across0 = by_sides ? p.r0 : middle_of_both(p.r0, across, p.r1);
  const double across1 = by_sides ? -p.r1 : across0 - across;
  out.on_a = along0 * w + across0 * u;
  out.on_b = along1 * w + across1 * u;
  if (by_caps && by_sides) {
    const double most = larger(beyond, beside), x = beyond / most, y = beside / most;
    const double root = std::sqrt(x * x + y * y);
    out.value = most * root;
    out.direction = (x / root * sign) * w + (y / root) * u;
  } else {
    out.value = by_caps ? beyond : beside;
    out.direction = by_caps ? Vector3(sign * w) : u;
  }
  out.error = distance_error * (p.r0 + p.h0 + p.r1 + p.h1 + length(p.delta));
}

}  // namespace

Distance distance(const Prepared& a, const Prepared& b) noexcept {
  Distance out;
  if ((a.defect != Defect::none) | (b.defect != Defect::none)) {
    out.verdict = Verdict::invalid;
    return out;
  }
  const bool swapped = out_of_order(a, b);
  const Prepared& first = swapped ? b : a;
  const Prepared& second = swapped ? a : b;
  const Axes axes(first.unit_axis, second.unit_axis);
  const Scaled p = scale(first, second);
  if (axes.parallel()) {
    measure_parallel(p, axes.sum, out);
  } else {
    const TurnedFrame frame(p, axes);
    Search search(p, frame);
    search.run([&] { return decide(first, second); });
    search.report(out);
  }
  out.verdict = out.value > 0 ? Verdict::disjoint : Verdict::intersecting;
  if (p.exponent != 0) {
    // In two factors, since one may be out of range.
    const int half = p.exponent / 2;
    auto scaled = [&](double x) {
      const double y = x * power_of_two(half) * power_of_two(p.exponent - half);
      return clamp(y, std::numeric_limits<double>::max());
    };
    out.value = scaled(out.value);
    out.error = scaled(out.error);
    for (int i = 0; i < 3; ++i) {
      out.on_a[i] = scaled(out.on_a[i]);
      out.on_b[i] = scaled(out.on_b[i]);
    }
  }
  if (swapped) {
    out.direction = -out.direction;
    const Vector3 on_first = out.on_a;
    out.on_a = out.on_b;
    out.on_b = on_first;
  }
  return out;
}

Distance distance(const Cylinder& a, const Cylinder& b) noexcept { return distance(prepare(a), prepare(b)); }

}  // namespace cyl
