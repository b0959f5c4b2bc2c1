// SPDX-License-Identifier: MIT
// Pairs drawn by stratum: what meets, and the decade of the margin, both by construction. First of cylinders,
// then of solids of any kinds. Every pair is a pure function of (feature, decade, seed, index).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "corpus/pairs/solid_kind.hpp"
#include "corpus/pairs/stratum.hpp"
#include "solver/solid.hpp"

namespace cyl {

/// Margins of decade d are in (10^(-d-1), 10^-d].
inline constexpr int first_decade = 1, last_decade = 15;

/// The strata that are drawn, with axes at any angle: by feature, then by decade.
inline constexpr std::size_t drawn_decade_count = last_decade - first_decade + 1;
constexpr std::size_t number_of(const Stratum& drawn) noexcept {
  return static_cast<std::size_t>(drawn.feature) * drawn_decade_count +
         static_cast<std::size_t>(drawn.decade - first_decade);
}
inline constexpr auto drawn_strata = [] {
  std::array<Stratum, contact_feature_count * drawn_decade_count> all{};
  for (const ContactFeature feature : enum_values<ContactFeature>)
    for (int decade = first_decade; decade <= last_decade; ++decade)
      all[number_of({feature, decade})] = {feature, decade};
  return all;
}();

/// Gaps at even indices, penetrations at odd ones, if the cell has both. Containment leaves no gap.
/// * Decade 1: penetrations by containment only, because others are not known by construction.
/// * Decades 14 and up: the decade is a target, because rounding moves the margin by up to 5e-16.
/// * Last decade: the sign is a target too. Containment gives nothing, because doubles near the outer
///   surface cannot represent so small an inner solid.
/// Returns nothing outside the decades.
std::optional<Pair> draw_in_stratum(ContactFeature feature, int decade, std::uint64_t seed,
                                    std::uint64_t index);

/// Returns the pairs of indices below `per_cell` of every stratum: by feature, then by decade, then by index.
std::vector<Pair> draw_in_all_strata(std::uint64_t per_cell, std::uint64_t seed);

/// The kinds of two solids, in this order. Two cylinders have the strata above, so they are not drawn here.
struct Kinds {
  SolidKind first, second;
  bool operator==(const Kinds&) const = default;
};
inline constexpr auto drawn_kinds = [] {
  constexpr std::size_t count = enum_words<SolidKind>.size();
  std::array<Kinds, count*(count + 1) / 2 - 2> all{};
  std::size_t next = 0;
  for (const SolidKind first : enum_values<SolidKind>)
    for (const SolidKind second : enum_values<SolidKind>)
      if (first <= second &&
          !(first == second && (first == SolidKind::cylinder || first == SolidKind::half_space)))
        all[next++] = {first, second};
  return all;
}();
/// Returns the number of the pair's kinds among drawn_kinds, or their number if there is none.
inline std::size_t number_of_kinds(const Pair& pair) {
  const auto [first, second] = std::minmax({kind_of(pair.a), kind_of(pair.b)});
  return static_cast<std::size_t>(std::ranges::find(drawn_kinds, Kinds{first, second}) - drawn_kinds.begin());
}

/// A pair of these kinds in contact: a vertex, rim or end, an edge, side or segment, or a facet or cap of
/// each. Gaps have the margin by construction, overlaps at most. The stratum follows from the index: the
/// decade takes turns, then gap and overlap, then the part of the first solid and that of the second. The
/// lines of the parts have every angle (put_in_contact). A pure function of its arguments.
Pair draw_in_stratum(const Kinds& kinds, std::uint64_t seed, std::uint64_t index);

}  // namespace cyl
