// SPDX-License-Identifier: MIT
// The verdict on pairs with a box or a half-space, with its proof. Every certificate is checked in the
// scene's frame, with the bound of boxes.md, section 6.
#include <cmath>
#include <utility>

#include "solver/detail/certify.hpp"
#include "solver/detail/shapes.hpp"

namespace cyl {
namespace {

bool is_in_box(const Edges& edges, const Vector3& half, const Vector3& x, double error) noexcept {
  const Vector3 at = edges.seen(x);
  return (std::fabs(at[0]) + error < half[0]) & (std::fabs(at[1]) + error < half[1]) &
         (std::fabs(at[2]) + error < half[2]);
}

class BoxProof {
 public:
  BoxProof(const ShapePair& p, const Vector3& head, Answer& answer) noexcept
      : p_(p),
        answer_(answer),
        head_(head),
        delta_(p.b.center - p.a.center),
        view_(p.a, p.b),
        shrunk_(view_),
        reach_(core_size(p.a) + core_size(p.b) + length(delta_) + p.contact),
        error_(box_error * reach_ + underflow_error) {
    const double by = box_slack_tol * reach_;
    hull_ = view_.box ? Hull::space : hull_of(view_.r, view_.h, reach_);
    const bool line = (hull_ == Hull::line) | (hull_ == Hull::center);
    const bool plane = (hull_ == Hull::plane) | (hull_ == Hull::center);
    for (int i = 0; i < 3; ++i) {
      shrunk_.half[i] -= by;
      shrunk_.half1[i] -= by;
      flat_ |= shrunk_.half[i] < 0 || (view_.box && shrunk_.half1[i] < 0);
    }
    shrunk_.r = line ? 0 : view_.r - by;
    shrunk_.h = plane ? 0 : view_.h - by;
  }

  void run() noexcept { p_.contact > 0 ? (void)prove_near() : (void)prove_cores(); }

 private:
  bool prove_cores() noexcept {
    const int axis = separating_axis(view_);
    if (axis >= 0) {
      if (try_direction(axis_of(view_, axis))) return true;
    } else {
      Vector3 at;
      if (!flat_ && find_common_point(shrunk_, at) && try_point(at)) return true;
      if (view_.box || view_.r == 0 || clip(view_).meets) return false;  // no direction separates
    }
    const NearestPoints found = nearest_points(view_, -1);
    return found.square > error_ * error_ && try_directions(found.on0, found.on1);
  }

  bool prove_near() noexcept {
    if (!view_.box && view_.r == 0) {
      const SegmentPoint found = nearest_on_segment(view_, p_.contact);
      if (!found.near && try_direction(found.way)) return true;
      if (is_hopeless(found.way)) return false;
      const Vector3 on1 = view_.d + found.t * view_.e[0];
      if (try_points(on1, on1)) return true;
      const SegmentPoint again = nearest_on_segment(shrunk_, 0);
      const Vector3 nearest = view_.d + again.t * view_.e[0];
      return try_points(nearest, nearest) || try_directions(on1 - found.way, on1);
    }
    const NearestPoints found = nearest_points(view_, p_.contact);
    if (found.apart ? try_direction(found.on1 - found.on0) : try_points(found.on0, found.on1)) return true;
    if (is_hopeless(found.on1 - found.on0)) return false;
    Vector3 at;
    if (!flat_ && separating_axis(shrunk_) < 0 && find_common_point(shrunk_, at) && try_point(at))
      return true;
    const NearestPoints all = nearest_points(view_, -1);
    return try_points(all.on0, all.on1) || try_directions(all.on0, all.on1);
  }

  // Whether nothing can be proved, because two points have the distance `contact` but for rounding, and the
  // way between them separates as much.
  bool is_hopeless(const Vector3& way) const noexcept {
    const double size = length(way), below = p_.contact - error_;
    return (below > 0) & (size <= p_.contact + 0.5 * error_) & (view_.gap(way) > below * size);
  }

  bool try_directions(const Vector3& on0, const Vector3& on1) noexcept {
    Vector3 found[direction_cap];
    const int count = find_directions(view_, on0, on1, found);
    for (int i = 0; i < count; ++i)
      if (try_direction(found[i])) return true;
    return false;
  }

  // f(D) < 0 beyond rounding. D is given along the edges of the box.
  bool try_direction(const Vector3& seen) noexcept {
    const double most = max_abs(seen);
    if (!(most >= 0x1p-900)) return false;
    const Vector3 d = view_.edges.world(seen * power_of_two(-exponent_of(most)));
    const double size = length(d), along = dot(d, delta_);
    const double f = core_support(p_.a, d) + core_support(p_.b, d) + p_.contact * size - std::fabs(along);
    if (!(f < -error_ * size)) return false;
    hand_out(along < 0 ? Vector3(-d) : d, answer_);
    return true;
  }

  // A vector in the unit, as it is after it was handed out.
  Vector3 given(const Vector3& tail) const noexcept { return times_power(tail, -p_.exponent); }

  // `more`: how far the point of the hull may be from x.
  bool in_first(const Vector3& x, double more) const noexcept {
    return is_in_box(view_.edges, view_.half, x, error_ + more);
  }
  bool in_second(const Vector3& x, double more) const noexcept {
    if (view_.box) return is_in_box(Edges(p_.b), view_.half1, x, error_);
    return Place(x, p_.b.unit_axis).inside(view_.r, view_.h, hull_, error_ + more);
  }

  bool try_point(const Vector3& seen) noexcept {
    const Vector3 tail = times_power(view_.edges.world(seen), p_.exponent), x = given(tail);
    const double off = view_.box ? 0 : Place(x - delta_, p_.b.unit_axis).off(hull_);
    if (!in_first(x, off) || !in_second(x - delta_, off)) return false;
    hand_out(Proof::point, head_, tail, Hull::space, hull_, answer_);
    return true;
  }

  // Points of each core near these, no farther apart than the contact distance.
  bool try_points(const Vector3& near0, const Vector3& near1) noexcept {
    if (flat_) return false;
    const Vector3 seen1 = shrunk_.nearest_to(near1),
                  seen0 = clamped(near0 == near1 ? seen1 : near0, shrunk_.half);
    const Vector3 tail0 = times_power(view_.edges.world(seen0), p_.exponent),
                  tail1 = times_power(view_.edges.world(seen1 - view_.d), p_.exponent);
    const Vector3 x0 = given(tail0), x1 = given(tail1), apart = delta_ + x1 - x0;
    const double off = view_.box ? 0 : Place(x1, p_.b.unit_axis).off(hull_);
    if (!in_first(x0, 0) || !in_second(x1, off) || !(length(apart) + off + 2 * error_ <= p_.contact))
      return false;
    hand_out(Proof::points, tail0, tail1, Hull::space, hull_, answer_);
    return true;
  }

  const ShapePair& p_;
  Answer& answer_;
  const Vector3 &head_, delta_;
  BoxView view_, shrunk_;
  double reach_, error_;
  Hull hull_ = Hull::space;
  bool flat_ = false;  ///< the box or the other one, which then has no point beyond rounding
};

}  // namespace

Answer decide_shapes(const Prepared& a, const Prepared& b, double clearance) noexcept {
  Answer answer;
  if (a.shape == Shape::half_space && b.shape == Shape::half_space) {
    answer.verdict = Verdict::invalid;
    return answer;
  }
  const bool swapped = shapes_out_of_order(a, b);
  const Prepared &first = swapped ? b : a, &second = swapped ? a : b;
  const double contact = contact_distance_of(a, b, clearance);
  const ShapePair p = is_in_range(first, second, contact) ? ShapePair{first, second, contact, 0}
                                                          : in_unit(first, second, contact);
  if (first.shape == Shape::half_space) {
    decide_half_space(p, first.second_axis, answer);
    if (answer.proof == Proof::point) answer.point_head = second.center;
  } else {
    BoxProof(p, first.center, answer).run();
  }
  if (swapped) {
    if (answer.proof == Proof::direction) answer.direction = -answer.direction;
    if (answer.proof == Proof::points) std::swap(answer.point_head, answer.point_tail);
    std::swap(answer.hull_a, answer.hull_b);
  }
  return answer;
}

}  // namespace cyl
