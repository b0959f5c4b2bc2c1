// SPDX-License-Identifier: MIT
#include "scenes/study/reach.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <tuple>

#include "corpus/pairs/pair_numbers.hpp"
#include "scenes/study/joint_path.hpp"
#include "scenes/study/model_hierarchy.hpp"

// A box around all places of a body in the frame of a link becomes one in the frame of the parent in two
// steps. First the joint moves it. A joint that slides shifts it along the axis. A joint may turn by up to
// d to either side of the middle of its range. Then each point comes at most min(d, 2) times its distance
// from the axis away from its place in the middle. It also stays in a ring about the axis. Then the joint's
// origin turns the box: its half edges become |R| times them.
//
// Rounding: joint_path.cpp bounds how far place() puts a point from its place, by all lengths of the path.
// The box costs fewer operations, which are rounded by parts of these lengths and of its own. So the box is
// made wider by that bound, of both together.

namespace cyl {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The values that a joint takes, of one that mimics too.
Range range_of(const Scene& scene, const Link& link) {
  if (!link.follow) return {link.low, link.high};
  const Range leader = range_of(scene, scene.links[link.follow->link]);
  const double m = link.follow->multiplier, o = link.follow->offset;
  const auto [low, high] = std::minmax({m * leader.low + o, m * leader.high + o});
  const double error = range_error * (std::fabs(low) + std::fabs(high) + 2 * std::fabs(o));
  return {low - error, high + error};
}

struct MiddleBox {
  Vector3 middle, half;
  void move(const Pose& pose) {
    middle = pose * middle;
    half = pose.linear().cwiseAbs() * half;
  }
};

/// Turns a box about an axis through the origin.
MiddleBox turned(const MiddleBox& box, const Vector3& axis, const Range& range) {
  const double angle = range.low + (range.high - range.low) / 2, along = axis.dot(box.middle),
               from_axis = (box.middle - along * axis).norm() + box.half.norm();
  MiddleBox arc = box, ring{along * axis, axis.cwiseAbs() * axis.cwiseAbs().dot(box.half)};
  arc.move(Pose(Eigen::AngleAxisd(angle, axis)));
  arc.half += Vector3::Constant(std::min((range.high - range.low) / 2, 2.0) * from_axis);
  for (int i = 0; i < 3; ++i) ring.half[i] += from_axis * std::sqrt(std::max(0.0, 1 - axis[i] * axis[i]));
  const Vector3 low = (arc.middle - arc.half).cwiseMax(ring.middle - ring.half),
                high = (arc.middle + arc.half).cwiseMin(ring.middle + ring.half);
  return {(low + high) / 2, (high - low) / 2};
}

}  // namespace

Box reach_of(const Scene& scene, const Body& body) {
  const Vector3 everywhere = Vector3::Constant(infinity);
  if (is_half_space(body.solid)) return {-everywhere, everywhere};
  // No model of a solid reaches farther from its centre: of a box because a + b <= sqrt(2 a^2 + 2 b^2).
  const Solid& c = body.solid;
  const double core = is_box(c) ? std::hypot(c.edges[0], c.edges[1], c.edges[2]) / std::numbers::sqrt2
                                : c.height / 2 + c.radius;
  MiddleBox box{c.center, Vector3::Constant((core + c.rounding) * (1 + 4 * model_margin))};
  double length = 0, links = 1;
  for (std::size_t i = body.link;; i = *scene.links[i].parent) {
    const Link& link = scene.links[i];
    if (!drawn_in_full(scene, i)) return {-everywhere, everywhere};
    const Range range = link.motion == Motion::fixed ? Range{} : range_of(scene, link);
    if (link.motion == Motion::turn) box = turned(box, link.axis, range);
    if (link.motion == Motion::slide) {
      box.middle += (range.low + (range.high - range.low) / 2) * link.axis;
      box.half += (range.high - range.low) / 2 * link.axis.cwiseAbs();
    }
    length += box.middle.norm() + box.half.norm() + link.origin.translation().norm();
    box.move(link.origin);
    ++links;
    if (!link.parent) break;
  }
  box.half += Vector3::Constant(motion_error * links * links * length);
  return {box.middle - box.half, box.middle + box.half};
}

double gap_between(const Box& a, const Box& b) {
  return (b.low - a.high).cwiseMax(a.low - b.high).maxCoeff();
}

std::vector<std::pair<std::size_t, std::size_t>> near_pairs(
    std::span<const Box> boxes, double clearance, std::size_t most,
    const std::function<bool(std::size_t, std::size_t)>& wanted) {
  std::vector<std::size_t> order(boxes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return boxes[i].low.x(); });
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < order.size() && pairs.size() <= most; ++i) {
    const Box& first = boxes[order[i]];
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      const Box& next = boxes[order[j]];
      if (next.low.x() - first.high.x() > clearance) break;
      if (gap_between(first, next) > clearance) continue;
      const auto [a, b] = std::minmax(order[i], order[j]);
      if (wanted(a, b)) pairs.emplace_back(a, b);
    }
  }
  std::ranges::sort(pairs, {}, [](const auto& pair) { return std::tie(pair.second, pair.first); });
  return pairs;
}

}  // namespace cyl
