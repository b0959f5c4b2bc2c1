// SPDX-License-Identifier: MIT
// Many cylinders that stand still, and their close pairs, as people read them and as a page is drawn.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scenes/close_pairs.hpp"
#include "scenes/nearest_pairs.hpp"

namespace cyl {

/// The most cylinders of which a page is written, and of which JSON holds the numbers: 26 MB of
/// 200,000 rods, which a browser reads in seconds.
inline constexpr std::size_t crowd_page_cap = 200'000;

/// The nearest pairs that are written: as many as somebody may look through.
inline constexpr std::size_t nearest_cap = 1000;

/// A search among so many cylinders, to tell how its time grows.
struct GrowthRow {
  std::size_t cylinders = 0, candidates = 0, within = 0;
  double prepare_ms = 0, tree_ms = 0, cascade_ms = 0;  ///< CPU time
};
GrowthRow growth_row(const ClosePairs& pairs);

/// What was asked, and what was found.
struct Crowd {
  std::string file;       ///< where the cylinders come from; or
  std::string generated;  ///< "rods" or "pipes", of the seed
  std::uint64_t seed = 1;
  double clearance = 0;
  std::vector<Cylinder> cylinders;
  std::vector<std::string> names;  ///< of a file's cylinders; empty where generated
  ClosePairs pairs;
  std::vector<GrowthRow> growth;  ///< fewest first; empty of a file, whose first ones are no sample
  std::optional<ClosePairsCheck> check;
  std::vector<NearPair> nearest;
};

/// Returns a line for people; `crowd_head` names its columns.
std::string crowd_head();
std::string crowd_line(const ClosePairs& pairs);
/// Returns what the referee said of the answers and of their certificates, a line each.
std::string crowd_check_text(const ClosePairsCheck& check);

/// Returns all of it as reports/schemas/close_pairs.json describes it; a page is drawn from it alone. Doubles
/// come back to the bit. Of more cylinders than `crowd_page_cap` their numbers and names are left out.
std::string crowd_json(const Crowd& crowd);

}  // namespace cyl
