// SPDX-License-Identifier: MIT
// What the samples of a gate draw, round by round, and count, cell by cell.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "corpus/pairs/strata.hpp"
#include "props/gate/gate_report.hpp"

namespace cyl {

/// Returns all cells, empty: by feature, then by decade; and those of close contacts.
std::vector<GateCell> empty_cells();
std::vector<CloseGateCell> empty_close_cells();
/// The number of pairs of one stratum in one round.
inline constexpr std::uint64_t pairs_per_stratum = 4;

/// The pairs of one round, with where each stands and came from; of close contacts also how they were built.
struct SampleRound {
  std::vector<Pair> pairs;
  std::vector<Stratum> strata;
  std::vector<std::string> origins;
  std::vector<CloseContact> contacts;  ///< empty of strata
};
/// Draw rounds: pure functions of their arguments.
SampleRound draw_strata(std::uint64_t seed, std::uint64_t round);
SampleRound draw_close_contacts(std::uint64_t seed, std::uint64_t round);

/// What one method said to the pairs of a round, and whether it was wrong: refuted, or no answer.
struct RoundAnswers {
  std::vector<MethodAnswer> answers;
  std::span<const std::optional<Verdict>> truths;
  std::vector<bool> wrong, wrong_beyond;  ///< at all; beyond its claim
};

/// Counts a round into the method's cells.
void count_cells(GateMethod& method, const SampleRound& round, const RoundAnswers& said);

}  // namespace cyl
