// SPDX-License-Identifier: MIT
// Symbols as in distance.md.
#include "solver/distance.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "solver/detail/best_direction.hpp"
#include "solver/detail/distance_frame.hpp"
#include "solver/detail/distance_patches.hpp"
#include "solver/detail/distance_rims.hpp"
#include "solver/detail/rounded.hpp"

namespace cyl {
namespace {

// Overlapping less than this times the reach may be not overlapping at all, with a direction badly known.
constexpr double shallow_tol = 0x1p-20;

// The error of the bounds of section 6, divided by the reach.
constexpr double patch_error = 4 * distance_error;

constexpr int open_box_cap = 2;  // boxes of a pair of rims from which a search starts
constexpr int settle_cap = 12;   // of them if direction and points do not belong together

// If the axes are nearly parallel and the rims nearly touch, f is flat from the poles to the circles.
// Newton's method starts in that valley, from points that are each a quarter as far from the pole as the one
// before. These are its steps from each, and how often a step is shortened. From a best direction that is not
// stationary it takes up to 16 steps.
constexpr double valley_tol = 0x1p-6;         // sine of the angle between the axes
constexpr double valley_depth_tol = 0x1p-34;  // of the reach; if rims show it, deeper, section 3 finds it
constexpr int valley_start_cap = 10, valley_step_cap = 8, finish_step_cap = 24;
// By how much two solids that touch are made to overlap for decide() to find a common point, of the reach.
constexpr double touch_tols[] = {0x1p-44, 0x1p-38, 0x1p-32, 0x1p-26};

class Search : BestDirection {
 public:
  Search(const Scaled& p, const TurnedFrame& f) noexcept : BestDirection(p), f_(f) {}

  // `decided` is the answer of decide(), which is asked if faces and circles show no gap beyond rounding.
  template <class Decide>
  void run(Decide&& decided) noexcept {
    measure_faces();
    bool proved = look_at_faces(true) || look_at_circles() || look_at_faces(false);
    Proof proof = Proof::none;
    Vector3 shown_along(0, 0, 0);
    if (low_ > -distance_error * reach_) {
      const Answer answer = decided();
      proof = answer.proof;
      shown_along = answer.direction;
    }
    if (proof == Proof::point) {
      look_at_patches();
    } else if (!proved) {
      proved = look_at_starts();
      if (!proved && proof == Proof::direction) proved = look_along(shown_along);
      if (!proved && low_ < 0) proved = look_along(Vector3(direction_)) || project();
    }
    // A gap within rounding that neither decide() nor the points prove is none.
    const bool shown = proof == Proof::direction || (proof == Proof::none && proved);
    if (low_ < 0 && low_ > -distance_error * reach_ && !shown) {
      low_ = 0;
      anchor_ = on0_;
      on_b_ = false;
    }
    if (!(low_ < 0)) touch();
  }

  // For cores that are apart and are to grow. Both points will move along the direction by any length. If
  // many points are equally near within rounding, direction and points may belong to different ones. Then
  // this looks once more at all candidates for a direction and two points that belong together. It also takes
  // steps from each core to the other.
  void settle() noexcept {
    if (!(low_ < 0)) return;
    const Vector3 way = on1_ - on0_, off = way - dot(way, direction_) * direction_;
    const double rounding = distance_error * reach_;
    if (dot(off, off) <= rounding * rounding || belong_together(direction_, on0_, on1_)) return;
    settling_ = true;
    if (look_at_circles() || look_at_faces(true) || look_at_faces(false) || look_at_starts() ||
        look_along(on1_ - on0_) || look_along(Vector3(direction_)))
      return;
    Vector3 on0 = on0_, on1 = on1_;
    for (int i = 0; i < settle_cap; ++i) {
      ++steps_;
      on0 = nearest(on1, p_.w0, p_.r0, p_.h0);
      if (belong_together(direction_, on0, on1)) return;
      on1 = nearest(on0 - p_.delta, p_.w1, p_.r1, p_.h1) + p_.delta;
      if (belong_together(direction_, on0, on1)) return;
    }
  }

  void report(Distance& out) const noexcept {
    out.value = 0 - low_;  // never -0
    out.error = distance_error * reach_;
    out.direction = direction_;
    if (low_ < 0) out.error += larger(0, high_ + low_);
    out.least = is_least_;
    out.on_a = on0_;
    out.on_b = on1_ - p_.delta;
    out.iterations = steps_;
  }

 private:
  // The normals of the three flat faces of K. f is known there in closed form.
  void measure_faces() noexcept {
    const Scaled& p = p_;
    const TurnedFrame& f = f_;
    const double c = std::fabs(f.c), s0 = std::copysign(1.0, f.d0), s1 = std::copysign(1.0, f.d1);
    const double sc = std::copysign(1.0, f.c);
    // The middle of the disk's lowest point, from the face's.
    const double q0 = f.e0 - sc * s0 * p.h1 * f.s + p.r1 * s0 * f.c;
    const double q1 = f.e1 - sc * s1 * p.h0 * f.s + p.r0 * s1 * f.c;
    const double far0 = f.z * f.z + q0 * q0, far1 = f.z * f.z + q1 * q1, rr0 = p.r0 * p.r0, rr1 = p.r1 * p.r1;
    at_n_ = {p.r0 + p.r1 - f.z, f.e0 <= p.h1 * f.s && f.e1 <= p.h0 * f.s};
    at_w0_ = {p.h0 + p.h1 * c + p.r1 * f.s - std::fabs(f.d0), far0 <= rr0};
    at_w1_ = {p.h1 + p.h0 * c + p.r0 * f.s - std::fabs(f.d1), far1 <= rr1};
    least_face_ = smaller(at_n_.value, smaller(at_w0_.value, at_w1_.value));
    // A pole whose point is just on the rim of its face is a stationary point of section 3, too.
    constexpr double tie_tol = 0x1p-20;  // of the squared radius
    if (far0 > (1 - tie_tol) * rr0) {
      const double inverse = 1 / std::sqrt(far0);  // of 0: not looked at
      add_start(at_w0_.value, {s0, sc * s0, f.z * inverse, q0 * inverse, 0, s0});
    }
    if (far1 > (1 - tie_tol) * rr1) {
      const double inverse = 1 / std::sqrt(far1);
      add_start(at_w1_.value, {sc * s1, s1, 0, s1, f.z * inverse, q1 * inverse});
    }
  }

  // Takes the faces of least value. `inside` selects the faces that hold the point nearest to them, or all
  // others.
  bool look_at_faces(bool inside) noexcept {
    const Scaled& p = p_;
    const TurnedFrame& f = f_;
    const double s0 = std::copysign(1.0, f.d0), s1 = std::copysign(1.0, f.d1), sc = std::copysign(1.0, f.c);
    const double most = smaller(least_face_, low_) + tie_error * reach_;
    if (at_n_.value <= most && at_n_.inside == inside) {
      const double t1 = smaller(1, f.e0 / (p.h1 * f.s));
      if (consider_unit(f.n, p.delta - t1 * p.h1 * f.w1 - p.r1 * f.n, true)) return true;
    }
    if (at_w0_.value <= most && at_w0_.inside == inside &&
        consider_unit(s0 * f.w0, p.delta - sc * s0 * p.h1 * f.w1 - s0 * p.r1 * f.m1, true))
      return true;
    return at_w1_.value <= most && at_w1_.inside == inside &&
           consider_unit(s1 * f.w1, sc * s1 * p.h0 * f.w0 + s1 * p.r0 * f.m0, false);
  }

  // The circles perpendicular to one axis, unless they cannot be lower.
  bool look_at_circles() noexcept {
    const Scaled& p = p_;
    const TurnedFrame& f = f_;
    const double c = std::fabs(f.c), e0 = f.e0 - p.h1 * f.s, e1 = f.e1 - p.h0 * f.s;
    double most = smaller(least_face_, low_) + tie_error * reach_;
    if (!circle_is_above(f.z, e0, p.r0, p.r1, c, most)) {
      const Turn k = lowest_on_circle(f.z, e0, p.r1, f.s, c, steps_);
      const double rho = std::sqrt(k.x * k.x + f.c * f.c * k.y * k.y),
                   value = p.r0 + p.r1 * rho - f.z * k.x - e0 * k.y;
      const double x1 = k.x / rho, y1 = -f.c * k.y / rho;  // rim point of 1 on (n, m1)
      if (k.y > 0 && value <= most &&
          consider(k.x * f.n + k.y * f.m0, p.delta - p.h1 * f.w1 - p.r1 * (x1 * f.n + y1 * f.m1), true))
        return true;
      const double at = f.d0 - f.c * (p.h1 - p.r1 * f.s * k.y / rho);
      if (k.y > 0 && std::fabs(at) > p.h0) add_start(value, {std::copysign(1.0, at), 1, k.x, k.y, x1, y1});
    }
    most = smaller(most, low_ + tie_error * reach_);
    if (!circle_is_above(f.z, e1, p.r1, p.r0, c, most)) {
      const Turn k = lowest_on_circle(f.z, e1, p.r0, f.s, c, steps_);
      const double rho = std::sqrt(k.x * k.x + f.c * f.c * k.y * k.y),
                   value = p.r1 + p.r0 * rho - f.z * k.x - e1 * k.y;
      const double x0 = k.x / rho, y0 = -f.c * k.y / rho;
      if (k.y > 0 && value <= most &&
          consider(k.x * f.n + k.y * f.m1, p.h0 * f.w0 + p.r0 * (x0 * f.n + y0 * f.m0), false))
        return true;
      const double at = -f.d1 + f.c * (p.h0 - p.r0 * f.s * k.y / rho);
      if (k.y > 0 && std::fabs(at) > p.h1) add_start(value, {1, -std::copysign(1.0, at), x0, y0, k.x, k.y});
    }
    return false;
  }

  // The starts are kept by their f, the lowest first.
  void add_start(double value, const Rims& rims) noexcept {
    int at = starts_++;
    for (; at > 0 && start_[at - 1].value > value; --at) start_[at] = start_[at - 1];
    start_[at] = {value, rims};
  }

  bool look_at_starts() noexcept {
    for (int i = 0; i < starts_; ++i)
      if (look_at_rims(start_[i].rims)) return true;
    return false;
  }

  bool next_start(int& next, double side0, double side1, Rims& rims) const noexcept {
    while (next < starts_) {
      rims = start_[next++].rims;
      if (rims.side0 == side0 && rims.side1 == side1) return true;
    }
    return false;
  }

  // For solids that overlap: the rims that may be lower than the best direction.
  void look_at_patches() noexcept {
    overlap_ = true;
    PatchSearch patches(p_, f_, low_, patch_error * reach_);
    is_least_ = true;
    for (const double side0 : {1.0, -1.0})
      for (const double side1 : {1.0, -1.0}) {
        if (patches.is_above(side0, side1)) continue;
        is_least_ = false;
        int next = 0, boxes = 0;
        for (Rims rims;
             next_start(next, side0, side1, rims) || (boxes++ < open_box_cap && patches.next_open(rims));) {
          look_at_rims(rims, &rims);
          patches.close_around(rims, low_);
        }
      }
    if (!is_least_ && low_ < valley_depth_tol * reach_ && f_.s < valley_tol) look_along_valley();
  }

  // Section 3, in directions instead of points. If the rims nearly touch, y is mostly rounding.
  void look_along_valley() noexcept {
    const Vector3 out = f_.z * f_.n + f_.e0 * f_.m0;
    const double size = length(out);
    if (!(size > 0)) return;
    for (const double side : {1.0, -1.0}) {
      double sine = 0.5;
      for (int i = 0; i < valley_start_cap; ++i, sine /= 4)
        descend(std::sqrt((1 - sine) * (1 + sine)) * side * f_.w0 + (sine / size) * out, valley_step_cap);
    }
  }

  // Section 3. D is perpendicular to both tangents, and along y. Near contact y is mostly rounding. If the
  // tangents are nearly parallel, their product is too.
  bool look_at_rims(const Rims& start, Rims* found = nullptr) noexcept {
    RimPoints rims(p_, f_, start);
    // If the solids overlap, f at a minimum is the length of y there.
    const bool came = rims.come_near(steps_, overlap_ ? low_ : std::numeric_limits<double>::infinity());
    if (found) *found = rims.at();
    if (!came) return false;
    const Vector3 on0 = rims.on0(), on1 = rims.on1(), y = rims.y();
    if (consider(rims.near() ? rims.product() : y, on0, false)) return true;
    if (low_ > shallow_tol * reach_) return false;
    const Vector3 tangent0 = rims.tangent0(), tangent1 = rims.tangent1();
    return consider(rims.near() ? y : rims.product(), on1, true) ||
           consider(y - dot(y, tangent0) * tangent0, on0, false) ||
           consider(y - dot(y, tangent1) * tangent1, on1, true);
  }

  // A direction that another search found, and the rims that it points to.
  bool look_along(const Vector3& d) noexcept {
    if (consider(d, on0_, false)) return true;
    const TurnedFrame& f = f_;
    const double along = dot(d, f.n), u0 = dot(d, f.m0), u1 = dot(d, f.m1);
    const double i0 = 1 / std::sqrt(larger(along * along + u0 * u0, 0x1p-1000));
    const double i1 = 1 / std::sqrt(larger(along * along + u1 * u1, 0x1p-1000));
    return look_at_rims({std::copysign(1.0, dot(d, f.w0)), std::copysign(1.0, dot(d, f.w1)), along * i0,
                         u0 * i0, along * i1, u1 * i1});
  }

  // Moved along the direction by the depth, b touches a in the plane perpendicular to it. A common point is
  // then a's deepest. The anchor is such a point, with three exceptions.
  // * It may go with another direction that is as good within rounding.
  // * It is the end of a side that lies in the plane as a whole. Then steps go from the point farthest along
  //   the direction, from each solid to the other and back.
  // * The search for the direction ended early, before a minimum. Then it goes on.
  // If that takes long, b is moved a little less, and decide() finds the point.
  void touch() noexcept {
    if (come_to_plane()) return;
    if (const double before = low_; overlap_ && before > 0) {
      descend(direction_, finish_step_cap);
      low_ = larger(0, low_);  // below 0 is rounding
      if (low_ < before && come_to_plane()) return;
    }
    const Vector3 moved = p_.delta + low_ * direction_;
    const Prepared a{Vector3(0, 0, 0), p_.w0, p_.r0, 2 * p_.h0, Defect::none, 0, Shape::cylinder, 0};
    Prepared b{moved, p_.w1, p_.r1, 2 * p_.h1, Defect::none, 0, Shape::cylinder, 0};
    for (const double overlap : touch_tols) {
      b.center = moved - overlap * reach_ * direction_;
      const Answer answer = decide(a, b);
      if (answer.proof == Proof::point) {
        come_together(answer.point_head + answer.point_tail, moved, tie_error * reach_);
        return;
      }
    }
  }

  const TurnedFrame& f_;
  bool overlap_ = false, is_least_ = false;
  struct {
    double value;
    bool inside;
  } at_n_, at_w0_, at_w1_;  // of the faces: f, and whether the solids are nearest there if they are apart
  double least_face_ = 0;
  struct {
    double value;
    Rims rims;
  } start_[6];  // two poles, and two of each look at the circles
  int starts_ = 0;
};

}  // namespace

void bring_to_scene(Distance& out, int exponent) noexcept {
  // In two factors, since one may be out of range.
  const int half = exponent / 2;
  auto scaled = [&](double x) { return in_range(x * power_of_two(half) * power_of_two(exponent - half)); };
  out.value = scaled(out.value);
  // A gap that is not a double in the scene's unit is still not a gap of 0.
  if (out.verdict == Verdict::disjoint)
    out.value = larger(out.value, std::numeric_limits<double>::denorm_min());
  // If they are subnormal, value, error and points are rounded once or twice more. For the nine numbers of
  // the points, this is below the following bound in total.
  constexpr double subnormal_error = 8 * std::numeric_limits<double>::denorm_min();
  out.error = scaled(out.error) + subnormal_error;
  for (int i = 0; i < 3; ++i) {
    out.on_a[i] = scaled(out.on_a[i]);
    out.on_b[i] = scaled(out.on_b[i]);
  }
}

Distance distance_of_cores(const Prepared& a, const Prepared& b, bool grows) noexcept {
  Distance out;
  const bool swapped = out_of_order(a, b);
  const Prepared& first = swapped ? b : a;
  const Prepared& second = swapped ? a : b;
  const Axes axes(first.unit_axis, second.unit_axis);
  const Scaled p = scale(first, second);
  if (axes.parallel()) {
    measure_parallel(p, axes.sum, out);
    // not covered: if decide() proves a point, the depth is beyond rounding, or the centres are one
    if (out.value > 0 && out.value <= out.error && decide(first, second).proof == Proof::point) {
      out.value = 0;
      out.least = true;
    }
  } else {
    const TurnedFrame frame(p, axes);
    Search search(p, frame);
    search.run([&] { return decide(first, second); });
    if (grows) search.settle();
    search.report(out);
  }
  out.verdict = out.value > 0 ? Verdict::disjoint : Verdict::intersecting;
  if (p.exponent != 0) bring_to_scene(out, p.exponent);
  if (swapped) {
    out.direction = -out.direction;
    const Vector3 on_first = out.on_a;
    out.on_a = out.on_b;
    out.on_b = on_first;
  }
  return out;
}

}  // namespace cyl
