// SPDX-License-Identifier: MIT
// Take a point of one body that is deep in the other. If no motion within a box of the joints moves it as far
// as it is deep, the bodies overlap all over the box. Else the box is cut in two. The referee confirms that
// the one body has the point, and the other too without all that lies within that motion of its surface.
#include "scenes/study/overlap_proof.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "corpus/pairs/support.hpp"
#include "scenes/study/verification.hpp"
#include "scenes/study/joint_path.hpp"

namespace cyl {
namespace {

/// Boxes looked at for one pair, and points of the line between the middles of the bodies.
constexpr std::size_t overlap_box_cap = 1000, points_cap = 17;

/// Returns how deep a point is in a cylinder or box, about; negative if it is outside.
double depth_in(const Solid& c, const Vector3& point) {
  const Vector3 from = point - c.center;
  Vector3 beyond;  // by which the point exceeds the core: along each edge, or the radius and half the height
  if (is_box(c)) {
    const auto edges = edge_directions<double>(c.quaternion);
    for (std::size_t k = 0; k < 3; ++k)
      beyond[static_cast<int>(k)] =
          std::fabs(from.dot(Vector3(edges[k].x, edges[k].y, edges[k].z))) - c.edges[k] / 2;
  } else {
    const Vector3 unit = c.axis.normalized();
    beyond = {from.cross(unit).norm() - c.radius, std::fabs(from.dot(unit)) - c.height / 2, -INFINITY};
  }
  const double outside = beyond.cwiseMax(0).norm();
  return c.rounding - (outside > 0 ? outside : beyond.maxCoeff());
}

/// Returns all points of a solid that have everything within a length of them in the solid.
Solid shrunk(Solid c, double by) {
  const double of_core = std::max(0.0, by - c.rounding);
  c.rounding = std::max(0.0, c.rounding - by);
  c.radius -= of_core;
  c.height -= 2 * of_core;
  for (double& edge : c.edges) edge -= 2 * of_core;
  if (is_box(c)) c.radius = c.height = 0;
  if (!is_box(c)) c.edges = {};
  return c;
}

/// Whether the bodies overlap all over the box in whose middle they are placed; nothing if they may be apart.
std::optional<bool> overlap(const Pair& placed, const JointPath& path, std::size_t& widest) {
  double best = -INFINITY;
  Vector3 point;
  bool in_a = false;
  for (std::size_t k = 0; k < points_cap; ++k) {
    const double part = static_cast<double>(k) / (points_cap - 1);
    const Vector3 p = placed.a.center + part * (placed.b.center - placed.a.center);
    const double a = depth_in(placed.a, p), b = depth_in(placed.b, p),
                 left = std::max(a, b) - path.travel_of(p).length;
    if (std::min(a, b) < 0 || left <= best) continue;
    best = left;
    point = p;
    in_a = a > b;
  }
  if (best == -INFINITY) return std::nullopt;
  const Travel travel = path.travel_of(point);
  widest = static_cast<std::size_t>(std::ranges::max_element(travel.shares) - travel.shares.begin());
  if (!(best > 0)) return false;
  const Solid mark{.center = point};
  const Solid inside = shrunk(in_a ? placed.a : placed.b, travel.length);
  return referee_within({inside, mark}, 0) == true &&
         referee_within({in_a ? placed.b : placed.a, mark}, 0) == true;
}

}  // namespace

bool overlap_always(const Scene& scene, std::size_t a, std::size_t b) {
  const Body &one = scene.bodies[a], &other = scene.bodies[b];
  JointPath path(scene, a, b);
  if (one.box || other.box || path.held()) return false;
  if (path.limits().empty()) return true;
  if (has_half_space({one.solid, other.solid})) return false;
  std::vector<JointBox> left{path.limits()};
  for (std::size_t boxes = 0; !left.empty(); ++boxes) {
    JointBox box = std::move(left.back());
    left.pop_back();
    Pair placed = path.place_middle(box);
    placed.a.rounding -= one.excess;  // what a solid reaches beyond its shapes
    placed.b.rounding -= other.excess;
    std::size_t widest = 0;
    const std::optional<bool> said = overlap(placed, path, widest);
    if (said == true) continue;
    if (!said || boxes + left.size() >= overlap_box_cap) return false;
    JointBox upper = box;
    upper[widest].low = box[widest].high = box[widest].low + (box[widest].high - box[widest].low) / 2;
    left.push_back(std::move(box));
    left.push_back(std::move(upper));
  }
  return true;
}

}  // namespace cyl
