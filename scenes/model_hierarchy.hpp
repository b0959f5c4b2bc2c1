// SPDX-License-Identifier: MIT
// Models of a cylinder, cheapest first. Each answers whether two are within a clearance of each other, or
// that a better model has to look closer.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "base/enum_words.hpp"
#include "solver/capsule.hpp"
#include "solver/decide.hpp"

namespace cyl {

enum class Rung : unsigned char {
  sphere,    ///< the ball around the cylinder: tells apart
  outer,     ///< the capsule around it: tells apart
  inner,     ///< the capsule inside it: tells within
  cylinder,  ///< yes or no, of cylinders grown by half the clearance: tells apart, and within where there is
             ///< none
  distance,  ///< the distance with its error bound
  certified  ///< a proof
};
constexpr auto words_of(Rung) noexcept {
  return std::array{"sphere", "outer capsule", "inner capsule", "cylinder", "distance", "certified"};
}
inline constexpr std::size_t rung_count = 6;
inline constexpr std::array<Rung, rung_count> all_rungs{Rung::sphere,   Rung::outer,    Rung::inner,
                                                        Rung::cylinder, Rung::distance, Rung::certified};

enum class Look : unsigned char {
  apart,   ///< farther from each other than the clearance
  within,  ///< not farther (touching is within a clearance of 0)
  closer   ///< look closer
};

/// A cylinder with its models, for one clearance.
struct Models {
  Prepared solid, grown;  ///< grown by half the clearance in all directions, and more at the rims
  seeds::Capsule outer, inner;
  double ball;   ///< radius of the sphere around it
  double slack;  ///< its share in seeds::proxy_distance_error
};
Models make_models(const Cylinder& c, double clearance) noexcept;
std::vector<Models> models_of(std::span<const Cylinder> placed, double clearance);

/// The answer of one rung; `apart` and `within` are never wrong beyond 1e-13 of the size (`cylinder`), within
/// its own error bound (`distance`), or at all (the others).
Look look(Rung rung, const Models& a, const Models& b, double clearance) noexcept;
/// Whether the model alone, trusted, takes the pair for within: capsules and balls for what they are.
bool trusted(Rung rung, const Models& a, const Models& b, double clearance) noexcept;

/// Rungs asked one after the other; the last is trusted.
struct Plan {
  std::array<bool, 3> first{};  ///< sphere, outer, inner
  Rung last = Rung::cylinder;
};
bool within(const Plan& plan, const Models& a, const Models& b, double clearance) noexcept;

}  // namespace cyl
