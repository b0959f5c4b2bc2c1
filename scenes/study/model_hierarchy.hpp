// SPDX-License-Identifier: MIT
// A hierarchy of models that replace a solid, cheapest first: a ball and a capsule around it, and a capsule
// inside it. A box around it is only compared with them. All are rounded solids, which the solver answers
// like the solid itself. A half-space is a model of itself. Each level decides whether two solids are within
// a clearance, or leaves that to a later level.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "base/enum_words.hpp"
#include "solver/distance.hpp"

namespace cyl {

enum class Level : unsigned char {
  sphere,     ///< the ball around the solid: decides apart
  outer,      ///< the capsule around it: decides apart
  inner,      ///< the capsule inside it: decides within
  cylinder,   ///< yes or no, of the solids themselves
  distance,   ///< the distance with its error bound
  certified,  ///< a proof
  box         ///< the box around the solid: decides apart, in no cascade
};
constexpr auto words_of(Level) noexcept {
  return std::array{"sphere", "outer capsule", "inner capsule", "cylinder", "distance", "certified", "box"};
}
inline constexpr std::size_t level_count = enum_words<Level>.size();
constexpr std::size_t index_of(Level level) noexcept { return static_cast<std::size_t>(level); }

enum class Proximity : unsigned char {
  apart,   ///< farther from each other than the clearance
  within,  ///< not farther (touching is within a clearance of 0)
  unclear  ///< this level cannot decide
};

/// How much wider or narrower than necessary a model is, as a multiple of the sum of the solid's lengths. The
/// verdict about models is right from a margin of 1e-13 on, so that it is right about the solids.
inline constexpr double model_margin = 0x1p-42;

/// A solid with its models.
struct ProxyModels {
  Prepared solid, ball, outer;
  Prepared inner;  ///< invalid if nothing is inside: for a segment, a disk, a point
  Prepared box;    ///< along the axis or the edges
};
ProxyModels make_models(const Solid& c) noexcept;
std::vector<ProxyModels> models_of(std::span<const Solid> placed);

/// Returns the answer of one level for valid solids. `apart` and `within` are never wrong beyond 1e-13 of the
/// size (`cylinder`), beyond its own error bound (`distance`), or at all (the others).
Proximity proximity(Level level, const ProxyModels& a, const ProxyModels& b, double clearance) noexcept;
/// Returns what a distance shows, with its error.
Proximity proximity_of(const Distance& d, double clearance) noexcept;
/// Returns whether the pair is within the clearance if this level's model replaces the cylinders. Capsules
/// and balls are then exact.
bool accepted(Level level, const ProxyModels& a, const ProxyModels& b, double clearance) noexcept;

/// Levels asked one after the other; the last is accepted.
struct Cascade {
  std::array<bool, 3> first{};  ///< sphere, outer, inner
  Level last = Level::cylinder;
  bool operator==(const Cascade&) const = default;
};
bool within(const Cascade& cascade, const ProxyModels& a, const ProxyModels& b, double clearance) noexcept;

}  // namespace cyl
