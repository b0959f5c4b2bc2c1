// SPDX-License-Identifier: MIT
// A family whose pairs come from answers. The points, normal and depth that distance() returns for a pair
// make the next pair. User code does the same when it moves solids into contact, out of it, or onto their
// nearest points. There rounding errors meet: gaps of some units in the last place, axes along the normal,
// rims through the witness.
#pragma once

#include <cstdint>
#include <optional>

#include "base/enum_words.hpp"
#include "corpus/pairs/families.hpp"

namespace cyl {

/// The part of an answer that is fed back.
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

/// Returns the pair changed by the answer of distance(), or nothing if the result is not a valid pair.
std::optional<Pair> fed_back(Feedback what, const Pair& pair);

/// The family `derived`: pairs drawn near touching, one to three times fed back.
const Family& derived_family();

}  // namespace cyl
