// SPDX-License-Identifier: MIT
#include "scenes/scene.hpp"

#include <algorithm>
#include <stdexcept>

#include "base/usage_error.hpp"
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

std::vector<std::size_t> rigid_bodies(const Scene& scene, bool each_link) {
  std::vector<std::size_t> first(scene.links.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    const Link& link = scene.links[i];
    const bool joined = !each_link && link.parent && link.motion == Motion::fixed && !link.held;
    first[i] = joined ? first[*link.parent] : i;
  }
  return first;
}

// A rigid body without shapes and what it carries are one: every body with shapes is adjacent to the nearest
// such above it, and those that meet in one without shapes are adjacent to each other.
std::vector<LinkPair> adjacent_bodies(const Scene& scene, const std::vector<std::size_t>& rigid) {
  const std::size_t count = scene.links.size();
  std::vector<bool> solid(count);
  for (std::size_t i = 0; i < count; ++i)
    if (scene.links[i].shapes > 0) solid[rigid[i]] = true;
  std::vector<std::size_t> hub(count);  // of a body without shapes: where its group begins
  std::vector<std::vector<std::size_t>> members(count);
  std::vector<LinkPair> pairs;
  for (std::size_t i = 0; i < count; ++i) {
    hub[i] = i;
    const Link& link = scene.links[i];
    if (rigid[i] != i || !link.parent || link.stands) continue;
    const std::size_t parent = rigid[*link.parent];
    if (solid[i] && solid[parent]) pairs.emplace_back(parent, i);
    if (!solid[i] && !solid[parent]) hub[i] = hub[parent];
    if (solid[i] && !solid[parent]) members[hub[parent]].push_back(i);
    if (!solid[i] && solid[parent]) members[i].push_back(parent);
  }
  for (const auto& group : members)
    for (std::size_t i = 0; i < group.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) pairs.emplace_back(group[j], group[i]);
  return sorted(std::move(pairs));
}

bool is_free(const Link& link) { return link.motion != Motion::fixed && !link.follow; }

Pose motion_of(const Link& link, double value) {
  Pose moved = link.origin;
  if (link.motion == Motion::turn) moved.rotate(Eigen::AngleAxisd(value, link.axis));
  if (link.motion == Motion::slide) moved.translate(value * link.axis);
  return moved;
}

}  // namespace

PairRule::PairRule(const Scene& scene, bool all, bool each_link)
    : all_(all),
      rigid_(rigid_bodies(scene, each_link)),
      adjacent_(adjacent_bodies(scene, rigid_)),
      disabled_(sorted(scene.disabled)) {}

PairRule::Reason PairRule::reason(const Body& a, const Body& b) const {
  const LinkPair bodies = ordered(rigid_[a.link], rigid_[b.link]);
  if (bodies.first == bodies.second) return Reason::same_body;
  if (all_) return Reason::checked;
  if ((a.type & b.affinity) == 0 && (b.type & a.affinity) == 0) return Reason::disabled;
  if (std::binary_search(adjacent_.begin(), adjacent_.end(), bodies)) return Reason::adjacent;
  if (std::binary_search(disabled_.begin(), disabled_.end(), ordered(a.link, b.link)))
    return Reason::disabled;
  return Reason::checked;
}

void let_follow(const Scene& scene, std::vector<double>& joints) {
  // As often as one may mimic another that mimics: each round settles at least the next of a chain.
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
    if (found == scene.links.end()) throw UsageError("'" + name + "' is no joint that moves by itself");
    joints[static_cast<std::size_t>(found - scene.links.begin())] = value;
  }
  let_follow(scene, joints);
  return joints;
}

bool moves(const Scene& scene) { return std::any_of(scene.links.begin(), scene.links.end(), is_free); }

std::vector<Pose> pose_links(const Scene& scene, std::span<const double> joints) {
  std::vector<Pose> poses(scene.links.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Link& link = scene.links[i];
    poses[i] = motion_of(link, joints[i]);
    if (link.parent) poses[i] = poses[*link.parent] * poses[i];
  }
  return poses;
}

void place(const Scene& scene, std::span<const Pose> poses, std::vector<Cylinder>& placed) {
  placed.resize(scene.bodies.size());
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const Cylinder& c = scene.bodies[i].solid;
    const Pose& pose = poses[scene.bodies[i].link];
    placed[i] = {pose * c.center, pose.linear() * c.axis, c.radius, c.height, c.rounding};
  }
}

std::vector<Cylinder> place(const Scene& scene, std::span<const double> joints) {
  std::vector<Cylinder> placed;
  place(scene, pose_links(scene, joints), placed);
  return placed;
}

}  // namespace cyl
