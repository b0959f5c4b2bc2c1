// SPDX-License-Identifier: MIT
// A family whose pairs are answers: what distance() says of a pair, its points, normal and depth, becomes the
// next pair, as a user's code does that moves solids into contact, out of it, or onto each other's points.
// There rounding meets itself: gaps of some units in the last place, axes along the normal, rims through the
// witness.
#pragma once

#include <cstdint>
#include <optional>

#include "base/enum_words.hpp"
#include "corpus/pairs/families.hpp"

namespace cyl {

/// What of an answer is fed back.
enum class Feedback : unsigned char {
  into_contact,        ///< b is moved along the direction until nothing is left of the distance
  to_the_other_side,   ///< likewise, by twice that: a gap becomes a penetration as deep
  onto_the_point,      ///< b's centre becomes a's nearest point
  points_together,     ///< b is moved so that its nearest point is a's
  axis_along_normal,   ///< b's axis becomes the direction
  length_of_distance,  ///< a radius or a height becomes the distance
};
constexpr auto words_of(Feedback) noexcept {
  return std::array{"into_contact",    "to_the_other_side", "onto_the_point",
                    "points_together", "axis_along_normal", "length_of_distance"};
}

/// Returns the pair with what distance() says of it fed back; nothing where that gives no legal pair.
std::optional<Pair> fed_back(Feedback what, const Pair& pair);

/// The family `derived`: pairs drawn near touching, one to three times fed back.
const Family& derived_family();

}  // namespace cyl
