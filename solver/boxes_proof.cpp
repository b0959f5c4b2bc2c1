// SPDX-License-Identifier: MIT
// The verdict on pairs with a box or a half-space, with its proof. Every certificate is checked in the
// scene's frame, with the bound of boxes.md, section 6.
#include <cmath>

#include "solver/detail/certify.hpp"
#include "solver/detail/shapes.hpp"

namespace cyl {
namespace {

bool is_in_box(const Edges& edges, const Vector3& half, const Vector3& x, double error) noexcept {
  const Vector3 at = edges.seen(x);
  return (std::fabs(at[0]) + error < half[0]) & (std::fabs(at[1]) + error < half[1]) &
         (std::fabs(at[2]) + error < half[2]);
}

double reach_of(const ShapePair& p) noexcept {
  return core_size(p.a) + core_size(p.b) + length(p.b.center - p.a.center) + p.contact;
}

// Projections from box to solid and back in search of a common point. Most that have one need one or two.
constexpr int quick_steps = 4;

// Most pairs. Returns whether there is a proof, or can be none. The directions and
// points are those of intersect(). They have to serve by `quick_error`, which also bounds the rounding of
// what is seen from the first box (boxes.md, section 6).
bool prove_quickly(const ShapePair& p, const BoxView& v, double reach, const Vector3& head,
                   Answer& answer) noexcept {
  const double error = quick_error * reach + underflow_error;
  const int normal = separating_normal(v, p.contact + error);
  if (normal >= 0) {
    const Vector3 n = normal < 3 ? v.edges.e[normal] : v.box ? Edges(p.b).e[normal - 3] : p.b.unit_axis;
    hand_out(std::copysign(1.0, dot(n, p.b.center - p.a.center)) * n, answer);
    return true;
  }
  const Vector3 inner = v.half - Vector3(error, error, error);
  if (!(smaller(smaller(inner[0], inner[1]), inner[2]) > 0)) return false;
  Vector3 at = clamped(v.d, inner);
  for (int i = 0; i < quick_steps; ++i) {
    if (holds(v, at, error)) {
      Vector3 tail;
      if (!brought_to_scene(v.edges.world(at), p.exponent, tail)) return false;
      hand_out(Proof::point, head, tail, Hull::space, Hull::space, answer);
      return true;
    }
    if (p.contact > 0) return false;
    if (const int axis = i == 0 ? separating_product(v) : -1; axis >= 0) {
      const Vector3 found = axis_of(v, axis), way = std::copysign(1.0, dot(found, v.d)) * found;
      const double gap = v.gap(way);
      if (!((gap > 0) & (gap * gap > error * error * dot(way, way)))) return false;
      hand_out(v.edges.world(way * power_of_two(-exponent_of(max_abs(way)))), answer);
      return true;
    }
    // Nothing can be proved if a normal leaves so little in common that the smaller cores are apart.
    if (i == 0 && separating_normal(v, 0) < 0 && separating_normal(v, -2 * box_slack_tol * reach) >= 0)
      return v.box;
    at = clamped(v.nearest_to(at, error), inner);
  }
  return false;
}

class BoxProof {
 public:
  BoxProof(const ShapePair& p, const BoxView& view, const Vector3& head, Answer& answer) noexcept
      : p_(p),
        answer_(answer),
        head_(head),
        delta_(p.b.center - p.a.center),
        view_(view),
        shrunk_(view_),
        reach_(reach_of(p)),
        error_(box_error * reach_ + underflow_error) {
    const double by = box_slack_tol * reach_;
    // Twice, so that what is left of a solid that is not flat has room for `error_`.
    hull_ = view_.box ? Hull::space : hull_of(view_.r, view_.h, 2 * reach_);
    for (int i = 0; i < 3; ++i) {
      shrunk_.half[i] -= by;
      shrunk_.half1[i] -= by;
      flat_ |= shrunk_.half[i] < 0 || (view_.box && shrunk_.half1[i] < 0);
    }
    shrunk_.r = on_line(hull_) ? 0 : view_.r - by;
    shrunk_.h = in_plane(hull_) ? 0 : view_.h - by;
  }

  void run() noexcept { p_.contact > 0 ? (void)prove_near() : (void)prove_cores(); }

 private:
  bool prove_cores() noexcept {
    const int axis = separating_axis(view_);
    if (axis >= 0) {
      if (try_direction(axis_of(view_, axis))) return true;
    } else {
      if (separating_axis(shrunk_) < 0 && try_common_point()) return true;
      if (view_.box || view_.r == 0 || clip(view_).meets) return false;  // no direction separates
    }
    const NearestPoints found = nearest_points(view_, -1);
    return found.square > error_ * error_ && try_directions(found.on1, found.on1 - found.on0);
  }

  bool prove_near() noexcept {
    if (!view_.box && view_.r == 0) {
      const SegmentPoint found = nearest_on_segment(view_, p_.contact);
      if (!found.near && try_direction(found.way)) return true;
      if ((found.near && flat_) || is_hopeless(found.way)) return false;
      const Vector3 on1 = view_.d + found.t * view_.e[0];
      if (try_points(on1, on1)) return true;
      const SegmentPoint again = nearest_on_segment(shrunk_, -1);
      const Vector3 nearest = view_.d + again.t * view_.e[0];
      if (try_points(nearest, nearest) || try_common_point()) return true;
      const SegmentPoint all = nearest_on_segment(view_, -1);
      return try_directions(view_.d + all.t * view_.e[0], all.way);
    }
    const NearestPoints found = nearest_points(view_, p_.contact);
    if (found.apart ? try_direction(found.on1 - found.on0) : try_points(found.on0, found.on1)) return true;
    if ((flat_ && found.square <= square(p_.contact)) || is_hopeless(found.on1 - found.on0)) return false;
    if (separating_axis(shrunk_) < 0 && try_common_point()) return true;
    const NearestPoints all = nearest_points(view_, -1);
    return try_points(all.on0, all.on1) || try_directions(all.on1, all.on1 - all.on0);
  }

  // Whether nothing can be proved, because two points have the distance `contact` but for rounding, and the
  // way between them separates as much.
  bool is_hopeless(const Vector3& way) const noexcept {
    const double size = length(way), below = p_.contact - error_;
    return (below > 0) & (size <= p_.contact + 0.5 * error_) & (view_.gap(way) > below * size);
  }

  bool try_common_point() noexcept {
    Vector3 at;
    return !flat_ && find_common_point(shrunk_, at) && try_point(at);
  }

  bool try_directions(const Vector3& on1, const Vector3& way) noexcept {
    Vector3 found[direction_cap];
    const int count = find_directions(view_, on1, way, found);
    for (int i = 0; i < count; ++i)
      if (try_direction(found[i])) return true;
    // A gap is at most the way between the points. Only a gap that decide() promises is worth the search.
    constexpr int worth_tol = 4;  // of the error
    return length(way) > p_.contact + worth_tol * error_ && try_direction(best_direction(view_, way));
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
  const BoxView& view_;
  BoxView shrunk_;
  double reach_, error_;
  Hull hull_ = Hull::space;
  bool flat_ = false;  ///< the box or the other one, which then has no point beyond rounding
};

// Not inlined, to keep the common path small.
[[gnu::noinline]] void prove_in_full(const ShapePair& p, const BoxView& view, const Vector3& head,
                                     Answer& answer) noexcept {
  BoxProof(p, view, head, answer).run();
}

}  // namespace

Answer decide_shapes(const Prepared& a, const Prepared& b, double clearance) noexcept {
  const bool swapped = shapes_out_of_order(a, b);
  const Prepared* const solids[] = {&a, &b};
  const Prepared &first = *solids[swapped], &second = *solids[!swapped];
  if (first.shape == Shape::half_space) return decide_half_space(first, second, clearance, swapped);
  return second.shape == Shape::cylinder && second.radius == 0
             ? decide_thin_and_box(first, second, clearance, swapped)
             : decide_box(first, second, clearance, swapped);
}

Answer decide_box(const Prepared& box, const Prepared& c, double clearance, bool swapped) noexcept {
  Answer answer;
  ask_in_order(box, c, clearance, false, [&](const ShapePair& p) {
    const BoxView view(p.a, p.b);
    if ((!view.box && view.r == 0) || !prove_quickly(p, view, reach_of(p), box.center, answer))
      prove_in_full(p, view, box.center, answer);
  });
  return in_order(swapped, answer);
}

}  // namespace cyl
