// SPDX-License-Identifier: MIT
// Take a point of one body that is deep in the other. If no motion within a box of the joints moves it as far
// as it is deep, the bodies overlap all over the box. Else the box is cut in two. The referee confirms that
// the one body has the point, and how deep it is in the other.
#include "scenes/study/overlap_proof.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "oracles/referee/referee.hpp"
#include "scenes/study/joint_path.hpp"
#include "scenes/study/verification.hpp"
#include "solver/distance.hpp"

namespace cyl {
namespace {

/// Boxes looked at for one pair, points of the line between the middles of the bodies, and rounds of a
/// search.
constexpr std::size_t overlap_box_cap = 1000, points_cap = 9, rounds_cap = 20;

/// Whether the bodies overlap all over the box in whose middle they are placed; nothing if they may be apart.
std::optional<bool> overlap(const Pair& placed, const JointPath& path, std::size_t& widest) {
  const Distance d = distance(placed.a, placed.b);
  if (d.value > 0) return std::nullopt;
  double best = -INFINITY;
  Travel travel;
  Pair deep;  // a solid and the point that is deep in it; the other has the point too
  const Solid* other = nullptr;
  // Returns how deep the point is in both bodies, less its travel. This is concave.
  const auto look = [&](const Vector3& at) {
    const Solid point{.center = at};
    const double of_a = distance(placed.a, point).value, of_b = distance(placed.b, point).value;
    const Travel far = path.travel_of(at);
    const double left = -std::min(of_a, of_b) - far.length, of_both = std::max(of_a, of_b);
    if (of_both <= 0 && left > best) {
      best = left;
      travel = far;
      deep = {of_a < of_b ? placed.a : placed.b, point};
      other = of_a < of_b ? &placed.b : &placed.a;
    }
    return -of_both - far.length;
  };
  Vector3 top = (placed.a.center + d.on_a + placed.b.center + d.on_b) / 2;
  double most = look(top);
  const auto climb = [&](const Vector3& at) {
    const double found = look(at);
    if (!(found > most)) return false;
    most = found;
    top = at;
    return true;
  };
  for (std::size_t k = 0; k < points_cap; ++k)
    climb(placed.a.center + static_cast<double>(k) / (points_cap - 1) * (placed.b.center - placed.a.center));
  double step = -d.value;
  for (std::size_t round = 0; round < rounds_cap && best <= 0; ++round) {
    bool better = false;
    for (int k = 0; k < 27; ++k) better |= climb(top + step * Vector3(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1));
    if (!better) step /= 2;
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
