// SPDX-License-Identifier: MIT
// The signed distance of cores if one is a box or a half-space. Derivation: boxes.md, section 7.
#include <cmath>
#include <utility>

#include "solver/detail/certify.hpp"
#include "solver/detail/shapes.hpp"

namespace cyl {
namespace {

// How far apart overlapping cores are moved to find where they touch, of the reach.
constexpr double parted_tol = 0x1p-46;

class BoxDistance {
 public:
  explicit BoxDistance(const ShapePair& p) noexcept
      : delta_(p.b.center - p.a.center),
        view_(p.a, p.b),
        reach_(core_size(p.a) + core_size(p.b) + length(delta_)) {}

  Distance run() noexcept {
    Distance out;
    out.error = box_error * reach_;
    const bool round = !view_.box && view_.r > 0;
    const bool meet = separating_axis(view_) < 0 && (!round || clip(view_).meets);
    if (!meet) {
      const NearestPoints found = nearest_points(view_, -1);
      out.iterations = found.steps;
      const double most = std::sqrt(found.square);
      Vector3 directions[direction_cap];
      const int count = find_directions(view_, found.on1, found.on1 - found.on0, directions);
      for (int i = 0; i < count; ++i) consider(directions[i]);
      if (!(best_ >= most - out.error)) consider(best_direction(view_, found.on1 - found.on0));
      // If it is as good, the way between the points belongs to them.
      if (const Vector3 way = (found.on1 - found.on0) / most; view_.gap(way) > best_ - 0.25 * out.error) {
        best_ = view_.gap(way);
        direction_ = way;
      }
      if (best_ > 0) {
        out.value = best_;
        out.error += larger(0, most - best_);
        hand_out(found, view_.d, out);
        return out;
      }
    }
    look_along_axes();
    if (round) look_at_circles();
    out.least = !round;
    const double depth = larger(0, -best_);
    out.value = 0 - depth;
    BoxView moved = view_;
    moved.d += (depth + parted_tol * reach_) * direction_;
    hand_out(nearest_points(moved, -1), moved.d, out);
    return out;
  }

 private:
  void consider(const Vector3& way) noexcept {
    const double size = length(way);
    if (!(size > 0x1p-400)) return;
    const Vector3 d = way * ((dot(way, view_.d) < 0 ? -1 : 1) / size);
    const double gap = view_.gap(d);
    if (!(gap > best_)) return;
    best_ = gap;
    direction_ = d;
  }

  void look_along_axes() noexcept {
    for (int i = 0; i < (view_.box ? box_axes : cylinder_axes); ++i) consider(axis_of(view_, i));
  }

  // The depth is least at a direction square to an edge or to the axis (section 7).
  void look_at_circles() noexcept {
    constexpr int samples = 96, search_cap = 50;
    for (int i = 0; i < 4; ++i) {
      Vector3 pole = view_.e[0], u(0, 0, 0);
      if (i < 3) pole = Vector3(i == 0, i == 1, i == 2);
      u[std::fabs(pole[0]) < 0.6 ? 0 : 1] = 1;
      u = pole.cross(u);
      u /= length(u);
      const Vector3 v = pole.cross(u);
      const auto at = [&](double angle) { return Vector3(std::cos(angle) * u + std::sin(angle) * v); };
      const auto gap = [&](double angle) { return view_.gap(at(angle)); };
      constexpr double step = 6.283185307179586 / samples;
      double before = gap(-step), here = gap(0);
      for (int k = 0; k < samples; ++k) {
        const double after = gap((k + 1) * step);
        if (here >= before && here >= after) {
          consider(at(golden_section(gap, (k - 1) * step, (k + 1) * step, search_cap)));
        }
        before = here, here = after;
      }
    }
  }

  void hand_out(const NearestPoints& found, const Vector3& center, Distance& out) const noexcept {
    out.direction = view_.edges.world(direction_);
    out.direction /= length(out.direction);
    out.on_a = view_.edges.world(found.on0);
    out.on_b = view_.edges.world(found.on1 - center);
  }

  Vector3 delta_, direction_{1, 0, 0};
  BoxView view_;
  double reach_, best_ = -0x1p1000;
};

Distance distance_from_plane(const ShapePair& p) noexcept {
  const AbovePlane above = above_plane(p.a, p.b, p.contact);
  const Vector3 delta = p.b.center - p.a.center;
  Distance out;
  out.value = above.gap;
  out.error = box_error * (core_size(p.b) + length_bound(delta));
  out.direction = p.a.unit_axis;
  out.least = !(out.value > 0);
  out.on_b = farthest_of(p.b, Vector3(-out.direction));
  out.on_a = delta + out.on_b - out.value * out.direction;
  return out;
}

}  // namespace

Distance distance_of_shapes(const Prepared& a, const Prepared& b, double contact) noexcept {
  const bool swapped = shapes_out_of_order(a, b);
  const bool plane = (a.shape == Shape::half_space) | (b.shape == Shape::half_space);
  Distance out = ask_in_order(a, b, plane ? contact : 0, swapped, [](const ShapePair& p) {
    Distance found = p.a.shape == Shape::half_space ? distance_from_plane(p) : BoxDistance(p).run();
    found.verdict = found.value > 0 ? Verdict::disjoint : Verdict::intersecting;
    if (p.exponent != 0) bring_to_scene(found, p.exponent);
    return found;
  });
  if (swapped) {
    out.direction = -out.direction;
    std::swap(out.on_a, out.on_b);
  }
  return out;
}

}  // namespace cyl
