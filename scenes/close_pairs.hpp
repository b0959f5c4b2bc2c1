// SPDX-License-Identifier: MIT
// All close pairs of many cylinders that stand still: a tree of boxes, then the model hierarchy. What was
// answered may be put before the referee, with the solver's certificate of each answer.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "scenes/scene_study.hpp"

namespace cyl {

/// The levels that save more than they cost in a crowd of close pairs (a capsule costs more than the
/// cylinder).
inline constexpr std::array<Level, 4> crowd_levels{Level::sphere, Level::cylinder, Level::distance,
                                                   Level::certified};

/// Indices of two cylinders, the lower one first.
using PairOfBodies = std::pair<std::uint32_t, std::uint32_t>;

struct ClosePairs {
  std::size_t bodies = 0;
  std::vector<PairOfBodies> candidates;  ///< pairs whose boxes overlap, in no order
  std::array<std::size_t, level_count> decided{};
  std::size_t undecided = 0;                           ///< by no level: taken for within
  std::vector<PairOfBodies> within;                    ///< sorted
  double prepare_ms = 0, tree_ms = 0, cascade_ms = 0;  ///< CPU time
};

/// Returns the pairs of valid cylinders within the clearance. Cost: about n log n, as long as few boxes
/// overlap.
ClosePairs find_close_pairs(std::span<const Cylinder> cylinders, double clearance);

/// The solver's certificates of what was answered, as the referee checks them.
struct CertificateCheck {
  std::size_t checked = 0;    ///< certificates that the solver gave
  std::size_t failed = 0;     ///< of these, that do not prove what was answered
  std::size_t undecided = 0;  ///< pairs of which the solver has none
  /// Asks the solver for a certificate and the referee whether it proves what was said.
  void add(const Pair& pair, double clearance, bool said_within);
};

/// What a check of every candidate found.
struct ClosePairsCheck {
  Verification referee;
  CertificateCheck certificates;
  double referee_ms = 0, certificates_ms = 0;  ///< CPU time
};

/// Puts the answer about every pair whose boxes meet before the referee, and then its certificate. Cost: some
/// 2 us a pair, more near touching.
ClosePairsCheck check_close_pairs(std::span<const Cylinder> cylinders, double clearance,
                                  const ClosePairs& answered);

}  // namespace cyl
