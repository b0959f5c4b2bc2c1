// SPDX-License-Identifier: MIT
#include "scenes/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "base/usage_error.hpp"
#include "corpus/pairs/pair_numbers.hpp"
#include "corpus/pairs/random_stream.hpp"

namespace cyl {
namespace {

using LinkPair = std::pair<std::size_t, std::size_t>;

LinkPair ordered(std::size_t a, std::size_t b) { return {std::min(a, b), std::max(a, b)}; }

std::vector<LinkPair> sorted(std::vector<LinkPair> pairs) {
  for (LinkPair& p : pairs) p = ordered(p.first, p.second);
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

/// Returns the first link of the rigid body of each link, or the link itself unless fixed joints join.
std::vector<std::size_t> rigid_bodies(const Scene& scene, bool fixed_joins = true) {
  std::vector<std::size_t> first(scene.links.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    const Link& link = scene.links[i];
    const bool joined = fixed_joins && link.parent && link.motion == Motion::fixed && !link.held;
    first[i] = joined ? first[*link.parent] : i;
  }
  return first;
}

std::vector<LinkPair> adjacent_links(const Scene& scene, const std::vector<std::size_t>& group) {
  std::vector<bool> solid(scene.links.size());
  for (std::size_t i = 0; i < solid.size(); ++i)
    if (scene.links[i].shapes > 0) solid[group[i]] = true;
  std::vector<LinkPair> pairs;
  for (std::size_t i = 0; i < solid.size(); ++i) {
    for (std::size_t at = i; scene.links[at].parent && !scene.links[at].stands;) {
      at = *scene.links[at].parent;
      if (group[at] == group[i] || !solid[group[at]]) continue;
      pairs.emplace_back(group[at], group[i]);
      break;
    }
  }
  return sorted(std::move(pairs));
}

bool is_free(const Link& link) { return link.motion != Motion::fixed && !link.follow; }

Pose motion_of(const Link& link, double value) {
  Pose moved = link.origin;
  if (link.motion == Motion::turn) moved.rotate(Eigen::AngleAxisd(value, link.axis));
  if (link.motion == Motion::slide) moved.translate(value * link.axis);
  return moved;
}

std::array<double, 4> turned(const Pose& pose, const std::array<double, 4>& q) {
  const Eigen::Quaterniond r = Eigen::Quaterniond(pose.linear()) * Eigen::Quaterniond(q[0], q[1], q[2], q[3]);
  return {r.w(), r.x(), r.y(), r.z()};
}

Solid placed_at(const Pose& pose, const Solid& c) {
  Solid placed = c;
  placed.center = pose * c.center;
  if (is_box(c))
    placed.quaternion = turned(pose, c.quaternion);
  else
    placed.axis = pose.linear() * c.axis;
  return placed;
}

}  // namespace

PairRule::PairRule(const Scene& scene)
    : rigid_(rigid_bodies(scene)),
      group_(rigid_bodies(scene, scene.welds)),
      adjacent_(adjacent_links(scene, group_)),
      disabled_(sorted(scene.disabled)) {
  for (std::size_t i = 0; i < scene.links.size(); ++i) {
    const Link& link = scene.links[i];
    floating_.push_back(link.floats ? i : link.parent ? floating_[*link.parent] : 0);
  }
}

PairRule::Reason PairRule::reason(const Body& a, const Body& b) const {
  if (is_half_space(a.solid) && is_half_space(b.solid)) return Reason::disabled;
  if (std::ranges::find(a.paired, b.name) != a.paired.end()) return Reason::checked;
  if (rigid_[a.link] == rigid_[b.link]) return Reason::same_body;
  if (!may_collide(a, b)) return Reason::disabled;
  if (std::binary_search(adjacent_.begin(), adjacent_.end(), ordered(group_[a.link], group_[b.link])))
    return Reason::adjacent;
  if (std::binary_search(disabled_.begin(), disabled_.end(), ordered(a.link, b.link)))
    return Reason::disabled;
  return floating_[a.link] == floating_[b.link] ? Reason::checked : Reason::floating;
}

bool may_collide(const Body& a, const Body& b) {
  return (a.type & b.affinity) != 0 || (b.type & a.affinity) != 0;
}

bool carries_directly(const Scene& scene, std::size_t a, std::size_t b) {
  const auto is_carried_by = [&](std::size_t link, std::size_t by) {
    std::size_t at = link;
    while (scene.links[at].parent && !scene.links[at].stands) {
      at = *scene.links[at].parent;
      if (at == by) return true;
      if (!scene.links[at].split) return false;
    }
    return false;
  };
  return is_carried_by(a, b) || is_carried_by(b, a);
}

void turn_leaders_round(Scene& scene) {
  constexpr std::size_t turns_cap = 64;
  constexpr std::size_t follow_cap = 100;  // let_follow() looks at all links once for each joint of a chain
  std::vector<std::size_t> turns(scene.links.size(), 1);
  for (Link& link : scene.links) {
    if (!link.follow || link.motion == Motion::fixed) continue;
    double multiplier = 1, offset = 0;
    std::size_t leader = 0, steps = 0;
    for (const Link* at = &link; at->follow; at = &scene.links[leader]) {
      if (++steps > follow_cap)
        throw std::runtime_error("joints mimic each other in a circle, or in a chain of more than " +
                                 std::to_string(follow_cap));
      offset += multiplier * at->follow->offset;
      multiplier *= at->follow->multiplier;
      leader = at->follow->link;
    }
    Link& leading = scene.links[leader];
    if (!leading.endless || multiplier == 0) continue;
    std::size_t round = 1;  // turns of the leader after which this link has made whole turns
    const auto repeats = [&] {
      const double turned = multiplier * static_cast<double>(round);
      return turned == std::round(turned);
    };
    while (round <= turns_cap && !repeats()) ++round;
    const std::size_t common = std::lcm(turns[leader], round);
    link.in_part = link.motion == Motion::slide || common > turns_cap;
    if (!link.in_part) {
      turns[leader] = common;
      continue;
    }
    // The drawn values cover at least the link's own limits, or one full turn.
    const double low = link.motion == Motion::slide ? link.low - offset : -std::numbers::pi,
                 high = link.motion == Motion::slide ? link.high - offset : std::numbers::pi;
    leading.low = std::min({leading.low, low / multiplier, high / multiplier});
    leading.high = std::max({leading.high, low / multiplier, high / multiplier});
  }
  for (std::size_t i = 0; i < turns.size(); ++i) {
    if (!scene.links[i].endless) continue;
    const double half = static_cast<double>(turns[i]) * std::numbers::pi;
    scene.links[i].low = std::min(scene.links[i].low, -half);
    scene.links[i].high = std::max(scene.links[i].high, half);
  }
}

bool drawn_in_full(const Scene& scene, std::size_t link) {
  while (!scene.links[link].held && !scene.links[link].in_part && scene.links[link].follow)
    link = scene.links[link].follow->link;
  return !scene.links[link].held && !scene.links[link].in_part;
}

void let_follow(const Scene& scene, std::vector<double>& joints) {
  // A joint may mimic one that mimics another. Each round settles at least the next joint of a chain.
  for (std::size_t round = 0; round <= scene.links.size(); ++round) {
    bool changed = false;
    for (std::size_t i = 0; i < scene.links.size(); ++i) {
      if (!scene.links[i].follow) continue;
      const Follow& f = *scene.links[i].follow;
      const double value = f.multiplier * joints[f.link] + f.offset;
      changed |= value != joints[i];
      joints[i] = value;
    }
    if (!changed) return;
  }
  throw std::runtime_error("joints mimic each other in a circle");
}

std::vector<double> draw_joints(const Scene& scene, std::uint64_t seed, std::uint64_t index) {
  RandomStream stream("scene", seed, index);
  std::vector<double> joints(scene.links.size(), 0.0);
  for (std::size_t i = 0; i < joints.size(); ++i)
    if (is_free(scene.links[i])) joints[i] = stream.between(scene.links[i].low, scene.links[i].high);
  let_follow(scene, joints);
  return joints;
}

std::vector<double> joints_at(const Scene& scene, std::span<const std::pair<std::string, double>> values) {
  std::vector<double> joints(scene.links.size(), 0.0);
  for (std::size_t i = 0; i < joints.size(); ++i)
    if (is_free(scene.links[i])) joints[i] = std::max(scene.links[i].low, std::min(0.0, scene.links[i].high));
  for (const auto& [name, value] : values) {
    const auto found =
        std::find_if(scene.links.begin(), scene.links.end(),
                     [&, &joint = name](const Link& l) { return l.joint == joint && is_free(l); });
    if (found == scene.links.end()) throw UsageError("'" + name + "' is not a joint that moves by itself");
    if (!found->endless && !(value >= found->low && value <= found->high))
      throw UsageError(
          fmt::format("'{}' moves from {} to {}, but not to {}", name, found->low, found->high, value));
    joints[static_cast<std::size_t>(found - scene.links.begin())] = value;
  }
  let_follow(scene, joints);
  return joints;
}

bool moves(const Scene& scene) { return std::any_of(scene.links.begin(), scene.links.end(), is_free); }

Solid box_at(const Pose& pose, const Vector3& edges) {
  return {.center = pose.translation(),
          .shape = Shape::box,
          .edges = {edges.x(), edges.y(), edges.z()},
          .quaternion = turned(pose, {1, 0, 0, 0})};
}

std::vector<Pose> pose_links(const Scene& scene, std::span<const double> joints) {
  std::vector<Pose> poses(scene.links.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Link& link = scene.links[i];
    poses[i] = motion_of(link, joints[i]);
    if (link.parent) poses[i] = poses[*link.parent] * poses[i];
  }
  return poses;
}

Solid inner_at(const Body& body, const Solid& placed) {
  if (!body.inner) return placed;
  Solid inner = *body.inner;
  inner.center = placed.center;
  inner.axis = placed.axis;
  return inner;
}

void place(const Scene& scene, std::span<const Pose> poses, std::vector<Solid>& placed) {
  placed.resize(scene.bodies.size());
  for (std::size_t i = 0; i < placed.size(); ++i)
    placed[i] = placed_at(poses[scene.bodies[i].link], scene.bodies[i].solid);
}

std::vector<Solid> place(const Scene& scene, std::span<const double> joints) {
  std::vector<Solid> placed;
  place(scene, pose_links(scene, joints), placed);
  return placed;
}

Pair place_pair(const Scene& scene, std::span<const double> joints, std::size_t a, std::size_t b) {
  const auto placed = [&](const Body& body) {
    std::vector<std::size_t> chain{body.link};
    while (scene.links[chain.back()].parent) chain.push_back(*scene.links[chain.back()].parent);
    Pose pose = motion_of(scene.links[chain.back()], joints[chain.back()]);
    for (chain.pop_back(); !chain.empty(); chain.pop_back())
      pose = pose * motion_of(scene.links[chain.back()], joints[chain.back()]);
    return placed_at(pose, body.solid);
  };
  return {placed(scene.bodies[a]), placed(scene.bodies[b])};
}

}  // namespace cyl
