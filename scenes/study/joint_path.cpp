// SPDX-License-Identifier: MIT
#include "scenes/study/joint_path.hpp"

#include <algorithm>
#include <span>

#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/support.hpp"

// This derives how far the bodies can come towards each other. The joints between them are in order from a
// to b. Let s be any place of this path. The joints before s move a, and the others move b, both seen from
// the link at s. Let x be a point of b, and M1 .. Mn the motions of b's joints from s outwards. Let q be
// their values in the middle of the box, and q' other values in it. The joints go from q to q' one by one,
// the outermost first. Then the i-th joint adds this to the place of x:
//
//   M1(q') .. M[i-1](q') (Mi(q') - Mi(q)) M[i+1](q) .. Mn(q) x.
//
// The last factors put x at its place in the middle of the box. There let the i-th joint turn about the unit
// axis w by at most d. Let y be x seen from the axis, square to it. Then (R(d) - I) y = 2 sin(d/2) w x
// R(d/2) y, which is no longer than min(d, 2) |y|. Along a direction n it is 2 sin(d/2) (n x w).R(d/2) y.
// This is at most min(d, 2) |n x w| |y|, and at most min(d, 2) (|(n x w).y| + d/2 |n x w| |y|). The joints
// nearer to s tilt n. If they move it by f, then f |y| is added in the outer brackets, and f to the first
// |n x w|. The joint itself moves n by another min(d, 2) (|n x w| + f). So if n is along parallel axes,
// nothing moves along it. A joint that slides by d adds d min(1, |n.w| + f).
//
// A solid is the segment of its axis, grown by a disk square to it and by a ball. Its support along n is
// that of the foremost end of the segment, plus those of disk and ball. That of the ball never changes. That
// of the disk is r |n - (n.u) u|, with the solid's axis u. It changes by at most r |u' - u|, at most min(d,
// 2) r |u x w|. Another bound uses the points of the disk. Their |y| exceeds that of the end by at most r,
// and their (n x w).y by at most r |v - (v.u) u|, v = n x w. If an end lies behind the foremost one by h,
// then h of its advance does not count.
//
// So sums over a's joints, for both ends, bound how much farther a reaches towards b. The sums over b's
// joints do the same. Anywhere in the box, the gap along n, turned with the link at s, is at least that in
// the middle less both sums. Any s is right, and the one with the least sums is taken.
//
// A box is the hull of its corners, without a disk. The support of a half-space is bounded along its normal
// alone, so s is its own place: only the other solid moves.
//
// Rounding: a joint's matrix is within 32 u of a rotation, u = 2^-53, with the product that it goes into. If
// the parts of the path are L long together, k links put a point within 32 k u L of its place. For two
// bodies this is 64 k u L. The normal of a half-space is as far off, for which this doubles. A box is turned
// by a quaternion made of such a matrix. If the matrix is within e of a rotation, the rotation of the
// quaternion is within 6 e of the matrix. So a corner is within 224 k u L of its place. For two boxes this is
// 448 k u L, and twice as much counts for how far an end lies behind. Reach and moment of each of m joints
// add as much twice, times min(d, 2) and 2: 1024 k m u L. Their own rounding is less than 64 u of sums of at
// most 2 m L. The gap proved in the middle was added to a rounding, which costs u L. Together this is less
// than 2048 (k + 1) (m + 1) u L. The error of |n x w|, below 64 (k + 1) u, grows from joint to joint, so it
// is added to |n x w|.

namespace cyl {
namespace {

double length_of_solid(const Solid& c) {
  return c.center.norm() + c.height / 2 + c.radius + c.rounding + edges_of(c) / 2;
}

bool moves_itself(const Link& link) { return link.motion != Motion::fixed && !link.follow; }

/// Returns the links from the given one to the root.
std::vector<std::size_t> ancestors(const Scene& scene, std::size_t link) {
  std::vector<std::size_t> chain{link};
  while (scene.links[chain.back()].parent) chain.push_back(*scene.links[chain.back()].parent);
  return chain;
}

}  // namespace

JointPath::JointPath(const Scene& scene, std::size_t a, std::size_t b) : scene_(scene) {
  std::vector<std::size_t> of_a = ancestors(scene, scene.bodies[a].link),
                           of_b = ancestors(scene, scene.bodies[b].link);
  while (!of_a.empty() && !of_b.empty() && of_a.back() == of_b.back()) {
    of_a.pop_back();
    of_b.pop_back();
  }
  own_.links.emplace_back();
  of_.push_back(scene.links.size());
  add_chain(of_b);
  own_.bodies = {scene.bodies[a], scene.bodies[b]};
  own_.bodies[1].link = own_.links.size() - 1;
  std::vector<Move> of_b_moves = std::move(moves_);
  moves_.clear();
  add_chain(of_a);
  own_.bodies[0].link = of_a.empty() ? 0 : own_.links.size() - 1;
  std::reverse(moves_.begin(), moves_.end());
  moves_.insert(moves_.end(), of_b_moves.begin(), of_b_moves.end());

  double length = length_of_solid(scene.bodies[a].solid) + length_of_solid(scene.bodies[b].solid);
  const JointBox all = limits();
  for (std::size_t i = 1; i < own_.links.size(); ++i) {
    length += own_.links[i].origin.translation().norm();
    if (own_.links[i].motion != Motion::slide) continue;
    const Value value = value_of(of_[i], all);
    length += std::fabs(value.middle) + value.half;
  }
  const auto count = [](std::size_t n) { return static_cast<double>(n + 1); };
  axis_error_ = motion_error * count(own_.links.size());
  slack_ = motion_error * count(own_.links.size()) * count(moves_.size()) * length;
  values_.assign(own_.links.size(), 0);
}

/// Appends links. The last of them is on link 0.
void JointPath::add_chain(const std::vector<std::size_t>& links) {
  for (std::size_t i = links.size(); i-- > 0;) {
    Link link = scene_.links[links[i]];
    link.parent = i + 1 == links.size() ? 0 : own_.links.size() - 1;
    held_ |= !drawn_in_full(scene_, links[i]);
    if (link.motion != Motion::fixed) {
      std::size_t leader = links[i];
      while (scene_.links[leader].follow) leader = scene_.links[leader].follow->link;
      const Link& free = scene_.links[leader];
      if (moves_itself(free) && free.low < free.high && std::ranges::find(free_, leader) == free_.end())
        free_.push_back(leader);
      Move& move = moves_.emplace_back();
      move.link = own_.links.size();
      move.turns = link.motion == Motion::turn;
    }
    own_.links.push_back(std::move(link));
    of_.push_back(links[i]);
  }
}

JointBox JointPath::limits() const {
  JointBox box;
  for (const std::size_t link : free_) box.push_back({scene_.links[link].low, scene_.links[link].high});
  return box;
}

JointPath::Value JointPath::value_of(std::size_t link, const JointBox& box) const {
  const Link& l = scene_.links[link];
  if (l.motion == Motion::fixed) return {};
  Value value;
  double greatest = 0;
  if (l.follow) {
    value = value_of(l.follow->link, box);
    value.middle = l.follow->multiplier * value.middle + l.follow->offset;
    value.half *= std::fabs(l.follow->multiplier);
    greatest = std::fabs(value.middle) + 2 * std::fabs(l.follow->offset) + value.half;
  } else if (const auto found = std::ranges::find(free_, link); found != free_.end()) {
    value.variable = static_cast<std::size_t>(found - free_.begin());
    const Range& range = box[value.variable];
    value.middle = range.low + (range.high - range.low) / 2;
    value.half = std::max(range.high - value.middle, value.middle - range.low);
    greatest = std::max(std::fabs(range.low), std::fabs(range.high));
  } else {
    value.middle = l.low;
  }
  value.half += range_error * greatest;
  return value;
}

const Pair& JointPath::place_middle(const JointBox& box) {
  for (Move& move : moves_) {
    const Value value = value_of(of_[move.link], box);
    values_[move.link] = value.middle;
    move.half = value.half;
    move.variable = value.variable;
  }
  const std::vector<Pose> poses = pose_links(own_, values_);
  place(own_, poses, solids_);
  placed_ = {solids_[0], solids_[1]};
  a_ = side_of(placed_.a);
  b_ = side_of(placed_.b);
  for (Move& move : moves_) {
    move.at = poses[move.link].translation();
    move.axis = poses[move.link].linear() * own_.links[move.link].axis;
    move.a = see(move, a_);
    move.b = see(move, b_);
  }
  return placed_;
}

JointPath::Side JointPath::side_of(const Solid& solid) {
  Side side;
  side.still = is_half_space(solid);
  if (is_box(solid)) {
    side.count = side.ends.size();
    const auto edges = edge_directions<double>(solid.quaternion);
    for (std::size_t i = 0; i < side.count; ++i) {
      side.ends[i] = solid.center;
      for (std::size_t k = 0; k < edges.size(); ++k)
        side.ends[i] +=
            ((i >> k & 1) != 0 ? 0.5 : -0.5) * solid.edges[k] * Vector3(edges[k].x, edges[k].y, edges[k].z);
    }
    return side;
  }
  side.unit = solid.axis.normalized();
  side.radius = solid.radius;
  const Vector3 half = solid.height / 2 * side.unit;
  side.ends[0] = solid.center - half;
  side.ends[1] = solid.center + half;
  return side;
}

JointPath::Seen JointPath::see(const Move& move, const Side& side) {
  Seen seen;
  for (std::size_t i = 0; i < side.count; ++i)
    seen.reach[i] = (side.ends[i] - move.at).cross(move.axis).norm();
  seen.tilt = side.radius * side.unit.cross(move.axis).norm();
  return seen;
}

JointPath::Step JointPath::step_of(const Move& move, const Side& side, const Seen& seen, const Vector3& n,
                                   double tilted) const {
  Step step;
  if (!move.turns) {
    step.ends.fill(move.half * std::min(1.0, std::fabs(n.dot(move.axis)) + tilted));
    return step;
  }
  const Vector3 v = n.cross(move.axis);
  const double chord = std::min(move.half, 2.0), across = v.norm() + axis_error_, r = side.radius,
               most = std::min(1.0, across + tilted), bend = across * move.half / 2 + tilted;
  step.tilt = chord * most;
  for (std::size_t i = 0; i < side.count; ++i) {
    const double moment = std::fabs(v.dot(side.ends[i] - move.at));
    step.ends[i] = chord * std::min(most * seen.reach[i], moment + bend * seen.reach[i]);
  }
  const double beside = (v - v.dot(side.unit) * side.unit).norm();
  step.disk = chord * std::min({seen.tilt, most * r, r * (beside + bend)});
  return step;
}

double JointPath::advance(bool of_b, std::size_t s, const Vector3& n, std::vector<double>& parts) {
  const Side& side = of_b ? b_ : a_;
  std::array<double, ends_cap> sums{};  // how far an end lies behind the foremost, and its advance
  for (std::size_t i = 0; i < side.count; ++i) sums[i] = (of_b ? -1 : 1) * n.dot(side.ends[i] - side.ends[0]);
  const auto own = std::span(sums).first(side.count);
  const double foremost = std::ranges::max(own);
  for (double& sum : own) sum -= foremost;
  double disks = 0, tilted = 0;
  const std::size_t count = of_b ? moves_.size() - s : s;
  for (std::size_t k = 0; k < count; ++k) {
    const Move& move = moves_[of_b ? s + k : s - 1 - k];
    steps_[k] = step_of(move, side, of_b ? move.b : move.a, n, tilted);
    for (std::size_t i = 0; i < side.count; ++i) sums[i] += steps_[k].ends[i];
    disks += steps_[k].disk;
    tilted += steps_[k].tilt;
  }
  const auto most = static_cast<std::size_t>(std::ranges::max_element(own) - own.begin());
  for (std::size_t k = 0; k < count; ++k)
    parts[of_b ? s + k : s - 1 - k] = steps_[k].ends[most] + steps_[k].disk;
  return sums[most] + disks;
}

Travel JointPath::travel(const Vector3& direction) {
  const std::size_t count = moves_.size();
  std::vector<double> best(count), parts(count);
  steps_.resize(count);
  double least = 0;
  const std::size_t first = b_.still ? count : 0, last = a_.still ? 0 : count;
  for (std::size_t s = first; s <= last; ++s) {
    const double sum = advance(false, s, direction, parts) + advance(true, s, direction, parts);
    if (s > first && !(sum < least)) continue;
    least = sum;
    best = parts;
  }
  Travel travel{least + slack_, std::vector<double>(free_.size(), 0.0)};
  for (std::size_t i = 0; i < count; ++i)
    if (!free_.empty()) travel.shares[moves_[i].variable] += best[i];
  return travel;
}

std::pair<double, Vector3> JointPath::gap_along_axes() const {
  std::pair<double, Vector3> best{0, {0, 0, 0}};
  if (has_half_space(placed_)) return best;
  const auto a = terms_of<double>(placed_.a), b = terms_of<double>(placed_.b);
  const Vector3 delta = placed_.b.center - placed_.a.center;
  for (const Move& move : moves_) {
    const Vector3 axis = (delta.dot(move.axis) < 0 ? -1 : 1) * move.axis.normalized();
    const double gap = move.turns ? -support_gap(a, b, lifted<double>(delta), lifted<double>(axis)) : 0;
    if (gap > best.first) best = {gap, axis};
  }
  return best;
}

// The joints move to their values one after the other, from the one body to the other. Each then turns a
// rigid part, in which the point is as far from its axis as in the middle.
Travel JointPath::travel_of(const Vector3& point) const {
  Travel travel{slack_, std::vector<double>(free_.size(), 0.0)};
  for (const Move& move : moves_) {
    const double reach = (point - move.at).cross(move.axis).norm(),
                 far = move.turns ? std::min(move.half, 2.0) * reach : move.half;
    travel.length += far;
    if (!free_.empty()) travel.shares[move.variable] += far;
  }
  return travel;
}

}  // namespace cyl
