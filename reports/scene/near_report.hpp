// SPDX-License-Identifier: MIT
// The close pairs of many cylinders that stand still, as text, JSON and CSV.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scenes/near/close_pairs.hpp"
#include "scenes/near/nearest_pairs.hpp"

namespace cyl {

/// The question and its results.
struct NearStudy {
  std::string file;       ///< the source of the cylinders; or
  std::string generated;  ///< "rods" or "pipes", of the seed
  std::uint64_t seed = 1;
  double clearance = 0;
  std::vector<Solid> cylinders;
  std::vector<std::string> names;  ///< of a file's cylinders; empty if generated
  ClosePairs pairs;
  std::optional<ClosePairsCheck> check;
  std::vector<NearPair> nearest;
};

/// Returns the counts, the check, and the first `listed` of the nearest pairs, for people.
std::string near_text(const NearStudy& study, std::size_t listed);
/// Returns all of it as reports/schemas/close_pairs.json describes it. Doubles come back to the bit.
std::string near_json(const NearStudy& study);
/// Returns the nearest pairs, a line each, with a head.
std::string near_csv(const NearStudy& study);

}  // namespace cyl
