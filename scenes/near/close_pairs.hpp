// SPDX-License-Identifier: MIT
// Finds all close pairs of many cylinders that stand still, by a tree of boxes and then the model hierarchy.
// The referee can check the answers, with the solver's certificate of each.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "scenes/near/model_hierarchy.hpp"
#include "scenes/near/verification.hpp"

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

/// The most pairs whose boxes meet: so many, or twice the number of solids if that is more. A pair takes some
/// 40 bytes. Solids that repeat one another have a pair for each two of them.
inline constexpr std::size_t candidates_cap = 5'000'000;

/// Returns the pairs of valid cylinders within the clearance. Throws InputError if the boxes of more pairs
/// meet than candidates_cap allows. Cost: about n log n, as long as few boxes overlap.
ClosePairs find_close_pairs(std::span<const Solid> cylinders, double clearance);

/// The solver's certificates of what was answered, as the referee checks them.
struct CertificateCheck {
  std::size_t checked = 0;    ///< certificates that the solver gave
  std::size_t failed = 0;     ///< of these, that do not prove what was answered
  std::size_t undecided = 0;  ///< pairs without a certificate of the solver
  /// Checks with the referee whether the solver's certificate proves the answer.
  void add(const Pair& pair, double clearance, bool said_within);
};

/// The result of a check of every candidate.
struct ClosePairsCheck {
  Verification referee;
  CertificateCheck certificates;
  double referee_ms = 0, certificates_ms = 0;  ///< CPU time
};

/// Puts the answer about every pair whose boxes meet before the referee, and then its certificate. Cost: some
/// 2 us a pair, more near touching.
ClosePairsCheck check_close_pairs(std::span<const Solid> cylinders, double clearance,
                                  const ClosePairs& answered);

}  // namespace cyl
