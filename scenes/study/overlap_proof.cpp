// SPDX-License-Identifier: MIT
// Take a point of one body that is deep in the other. If no motion within a box of the joints moves it as far
// as it is deep, the bodies overlap all over the box. Else the box is cut in two. The referee confirms that
// the one body has the point, and how deep it is in the other.
#include "scenes/study/overlap_proof.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "oracles/referee/referee.hpp"
#include "scenes/study/joint_path.hpp"
#include "scenes/study/verification.hpp"
#include "solver/distance.hpp"

namespace cyl {
namespace {

/// Boxes looked at for one pair, and points of a line.
constexpr std::size_t overlap_box_cap = 1000, points_cap = 9;

/// Whether the bodies overlap all over the box in whose middle they are placed; nothing if they may be apart.
/// It tries points of the lines between the middles of the bodies and their deepest points.
std::optional<bool> overlap(const Pair& placed, const JointPath& path, std::size_t& widest) {
  const Distance d = distance(placed.a, placed.b);
  const Vector3 &a = placed.a.center, &b = placed.b.center;
  const std::array<Vector3, 4> ends{a, b, a + d.on_a, b + d.on_b};
  double best = -INFINITY;
  Travel travel;
  Pair deep;  // a solid and the point that is deep in it; the other has the point too
  const Solid* other = nullptr;
  for (std::size_t k = 0; k < ends.size() * ends.size() * points_cap && d.value <= 0; ++k) {
    const std::size_t from = k / points_cap / ends.size(), to = k / points_cap % ends.size();
    if (from >= to) continue;
    const double part = static_cast<double>(k % points_cap) / (points_cap - 1);
    const Solid point{.center = ends[from] + part * (ends[to] - ends[from])};
    const double of_a = distance(placed.a, point).value, of_b = distance(placed.b, point).value;
    const Travel far = path.travel_of(point.center);
    const double left = -std::min(of_a, of_b) - far.length;
    if (std::max(of_a, of_b) > 0 || left <= best) continue;
    best = left;
    travel = far;
    deep = {of_a < of_b ? placed.a : placed.b, point};
    other = of_a < of_b ? &placed.b : &placed.a;
  }
  if (!other) return std::nullopt;
  widest = static_cast<std::size_t>(std::ranges::max_element(travel.shares) - travel.shares.begin());
  return best > 0 && enclose_distance(deep, judge(deep)).hi < -travel.length &&
         referee_within({*other, deep.b}, 0) == true;
}

}  // namespace

bool overlap_always(const Scene& scene, std::size_t a, std::size_t b) {
  const Body &one = scene.bodies[a], &other = scene.bodies[b];
  JointPath path(scene, a, b);
  if (one.box || other.box || path.held()) return false;
  if (path.limits().empty()) return true;
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
