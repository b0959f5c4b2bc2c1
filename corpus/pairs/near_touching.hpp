// SPDX-License-Identifier: MIT
// Pairs at a prescribed signed distance, one kind for every pair of features that can touch. Built from the
// contact outwards: nothing is solved, so no solver's error can hide in them.
#pragma once

#include <array>
#include <cstdint>

#include "corpus/pairs/random_stream.hpp"
#include "corpus/pairs/stratum.hpp"
#include "solver/solid.hpp"

namespace cyl {

/// The features that meet. Which solid has which is random.
enum class ContactKind : unsigned char {
  side_side,       ///< two generators cross
  side_rim,        ///< a rim meets a generator
  rim_rim,         ///< two rims meet in one point
  cap_rim,         ///< a rim point stands on a cap
  cap_side,        ///< a generator lies on a cap
  cap_cap,         ///< two caps face each other
  parallel_sides,  ///< two generators face each other
  needle_needle,   ///< side_side of needles, radius 2.5e-5 to 4e-2 of the height
  disk_disk        ///< rim_rim of disks, height 2.5e-5 to 4e-2 of the radius
};

/// The feature of each kind, in their order.
inline constexpr std::array features_of_kinds{
    ContactFeature::side_side, ContactFeature::side_rim,  ContactFeature::rim_rim,
    ContactFeature::cap_rim,   ContactFeature::cap_side,  ContactFeature::cap_cap,
    ContactFeature::side_side, ContactFeature::side_side, ContactFeature::rim_rim};
constexpr bool is_slender(ContactKind kind) { return kind >= ContactKind::needle_needle; }

struct Contact {
  Pair pair;
  double distance;  ///< signed; rounding keeps within 5e-16 of the size on every pair tried
};

/// The contact at `index`: margins run through the decades 1e-2, 1e-3, .. 1e-15 (from 1e-6 for needles and
/// disks), each with a gap (even index) and then a penetration (odd index).
Contact draw_contact(ContactKind kind, RandomStream& stream, std::uint64_t index);
/// A contact at a signed margin: any gap, a penetration up to 1e-2, or up to 1e-6 for needles and disks.
Contact draw_contact_at(ContactKind kind, RandomStream& stream, double margin);

}  // namespace cyl
