// SPDX-License-Identifier: MIT
// A hierarchy of models that stand in for a solid, cheapest first: a ball and a capsule around it, a capsule
// inside it, rounded solids all, about which the solver is asked as about the solid itself. Each level says
// whether two solids are within a clearance of each other, or that a later level has to be asked.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "base/enum_words.hpp"
#include "solver/decide.hpp"

namespace cyl {

enum class Level : unsigned char {
  sphere,    ///< the ball around the solid: says apart
  outer,     ///< the capsule around it: says apart
  inner,     ///< the capsule inside it: says within
  cylinder,  ///< yes or no, of the solids themselves
  distance,  ///< the distance with its error bound
  certified  ///< a proof
};
constexpr auto words_of(Level) noexcept {
  return std::array{"sphere", "outer capsule", "inner capsule", "cylinder", "distance", "certified"};
}
inline constexpr std::size_t level_count = enum_words<Level>.size();
constexpr std::size_t index_of(Level level) noexcept { return static_cast<std::size_t>(level); }

enum class Proximity : unsigned char {
  apart,   ///< farther from each other than the clearance
  within,  ///< not farther (touching is within a clearance of 0)
  unclear  ///< this level cannot tell
};

/// How much wider, or narrower, than needed a model is, as a multiple of the solid's radius, height and
/// rounding: the yes or no about models is right from a margin of 1e-13 on, so that it is right about solids.
inline constexpr double model_margin = 0x1p-42;

/// A solid with its models.
struct ProxyModels {
  Prepared solid, ball, outer;
  Prepared inner;  ///< invalid where nothing is inside: of a segment, a disk, a point
};
ProxyModels make_models(const Cylinder& c) noexcept;
std::vector<ProxyModels> models_of(std::span<const Cylinder> placed);

/// Returns what one level says of valid solids; `apart` and `within` are never wrong beyond 1e-13 of the size
/// (`cylinder`), within its own error bound (`distance`), or at all (the others).
Proximity proximity(Level level, const ProxyModels& a, const ProxyModels& b, double clearance) noexcept;
/// Returns whether the pair is within the clearance where this level's model is accepted in the cylinders'
/// place: capsules and balls are then taken for what they are.
bool accepted(Level level, const ProxyModels& a, const ProxyModels& b, double clearance) noexcept;

/// Levels asked one after the other; the last is accepted.
struct Cascade {
  std::array<bool, 3> first{};  ///< sphere, outer, inner
  Level last = Level::cylinder;
  bool operator==(const Cascade&) const = default;
};
bool within(const Cascade& cascade, const ProxyModels& a, const ProxyModels& b, double clearance) noexcept;

}  // namespace cyl
