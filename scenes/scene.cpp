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

// A link without shapes and what it carries are one: every link with shapes is adjacent to the nearest such
// above it, and those that meet in a link without shapes are adjacent to each other.
std::vector<LinkPair> adjacent_links(const Scene& scene) {
  std::vector<std::size_t> hub(scene.links.size());  // of a link without shapes: where its group begins
  std::vector<std::vector<std::size_t>> members(scene.links.size());
  std::vector<LinkPair> pairs;
  for (std::size_t i = 0; i < scene.links.size(); ++i) {
    hub[i] = i;
    const Link& link = scene.links[i];
    if (!link.parent) continue;
    const bool solid = link.shapes > 0, solid_parent = scene.links[*link.parent].shapes > 0;
    if (solid && solid_parent) pairs.emplace_back(*link.parent, i);
    if (!solid && !solid_parent) hub[i] = hub[*link.parent];
    if (solid && !solid_parent) members[hub[*link.parent]].push_back(i);
    if (!solid && solid_parent) members[i].push_back(*link.parent);
  }
  for (const auto& group : members)
    for (std::size_t i = 0; i < group.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) pairs.emplace_back(group[j], group[i]);
  return sorted(std::move(pairs));
}

void follow(const Scene& scene, std::vector<double>& joints) {
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

bool is_free(const Link& link) { return link.motion != Motion::fixed && !link.follow; }

Pose motion_of(const Link& link, double value) {
  Pose moved = link.origin;
  if (link.motion == Motion::turn) moved.rotate(Eigen::AngleAxisd(value, link.axis));
  if (link.motion == Motion::slide) moved.translate(value * link.axis);
  return moved;
}

}  // namespace

PairRule::PairRule(const Scene& scene, bool all)
    : all_(all), adjacent_(adjacent_links(scene)), disabled_(sorted(scene.disabled)) {}

PairRule::Reason PairRule::reason(const Body& a, const Body& b) const {
  if (a.link == b.link) return Reason::same_link;
  if (all_) return Reason::checked;
  if ((a.type & b.affinity) == 0 && (b.type & a.affinity) == 0) return Reason::disabled;
  const LinkPair links = ordered(a.link, b.link);
  if (std::binary_search(adjacent_.begin(), adjacent_.end(), links)) return Reason::adjacent;
  if (std::binary_search(disabled_.begin(), disabled_.end(), links)) return Reason::disabled;
  return Reason::checked;
}

std::vector<double> draw_joints(const Scene& scene, std::uint64_t seed, std::uint64_t index) {
  RandomStream stream("scene", seed, index);
  std::vector<double> joints(scene.links.size(), 0.0);
  for (std::size_t i = 0; i < joints.size(); ++i)
    if (is_free(scene.links[i])) joints[i] = stream.between(scene.links[i].low, scene.links[i].high);
  follow(scene, joints);
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
  follow(scene, joints);
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
