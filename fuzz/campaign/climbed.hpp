// SPDX-License-Identifier: MIT
// Part of every campaign climbs. It changes a pair that is bad for one of our own calls again and again, and
// keeps what is worse. All methods are asked about every pair of the climb, as in a family. Counts guide it,
// not times, so a pair is a pure function of (seed, index).
#pragma once

#include <cstdint>
#include <span>

#include "corpus/pairs/families.hpp"
#include "corpus/store/run_facts.hpp"
#include "oracles/trial/objective.hpp"

namespace cyl {

/// The goal of a climb: a score of one of our own calls.
struct ClimbGoal {
  Objective objective;
  MethodAnswer (*ask)(const Pair&);
  bool operator==(const ClimbGoal&) const = default;
};

/// Returns how far a valid pair is towards the goal; 0 is not at all. Bounds are relative to size and offset.
/// Costs one call of the scored function.
double height_of(const ClimbGoal& goal, const Pair& pair);

/// The first of the climb_size pairs of a climb are drawn. Each of the others is the best one before it,
/// changed. Pair i of the family is pair i % climb_size of climb i / climb_size.
inline constexpr std::uint64_t climb_starts = 16;

/// Returns what climb number `climb` is for: in turn, with one of eight for the referee, whose calls cost
/// most.
const ClimbGoal& goal_of_climb(std::uint64_t climb);

/// The family `climbed`.
const Family& climbed_family();

/// families(), `climbed` and `derived`: what a campaign draws from.
std::span<const Family> campaign_families();

}  // namespace cyl
