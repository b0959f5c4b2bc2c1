// SPDX-License-Identifier: MIT
// Draws the samples of a gate, round by round, and counts the answers, cell by cell.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "corpus/pairs/size_range.hpp"
#include "oracles/methods/method.hpp"
#include "props/gate/gate_report.hpp"

namespace cyl {

/// Returns all cells, empty, by feature and then by decade.
std::vector<GateCell> empty_cells();
/// Returns the cells of close contacts, empty.
std::vector<CloseGateCell> empty_close_cells();
/// The number of pairs of one stratum in one round.
inline constexpr std::uint64_t pairs_per_stratum = 4;

/// The pairs of one round, each with its stratum and origin. Close contacts come with how they were built.
struct SampleRound {
  std::vector<Pair> pairs;
  std::vector<std::string> origins;
  std::vector<Stratum> strata;         ///< empty for rounded solids
  std::vector<CloseContact> contacts;  ///< of close contacts only
};
/// Draw rounds: pure functions of their arguments.
SampleRound draw_strata(std::uint64_t seed, std::uint64_t round);
SampleRound draw_close_contacts(std::uint64_t seed, std::uint64_t round);
SampleRound draw_rounded_solids(std::uint64_t seed, std::uint64_t round);
/// The number of pairs of each family, and of each two kinds, in one round of rounded solids. The round also
/// has the pairs of a round of close contacts, with capsules instead of cylinders.
inline constexpr std::uint64_t pairs_per_kinds = 16;

/// Draw the pairs on which a gate checks every law, as pure functions too.
/// The pairs of a round, at most: so many draws of so many pairs. The kind of each draw is random, and an
/// origin names it: "grid", "family random", "stratum side-rim 1e-09" or
/// "close near-parallel 1e-03..1e-08 1e-05".
inline constexpr std::uint64_t draws_per_round = 4, pairs_per_draw = 16;

/// The grid, the families before the close contacts, and the strata.
SampleRound draw_law_pairs(std::uint64_t seed, std::uint64_t round);
/// The cells of close contacts, and their families.
SampleRound draw_close_law_pairs(std::uint64_t seed, std::uint64_t round);
/// The families of other solids than cylinders.
SampleRound draw_rounded_law_pairs(std::uint64_t seed, std::uint64_t round);

/// The solids that the methods together support.
struct DrawnSolids {
  bool cylinders = true;      ///< some method supports them
  std::uint64_t rounded = 0;  ///< pairs in a round of rounded solids that some guest supports
  SizeRange sizes = {};       ///< what all support
};
DrawnSolids solids_of(std::span<const std::unique_ptr<Method>> methods);

/// The number of pairs, in rounds. A round of laws has up to 64 pairs. A round of strata has 4 pairs of each
/// stratum, and a round of close contacts has close_round pairs.
struct GateAmount {
  std::optional<std::uint64_t> cases_under_laws;  ///< all, if not given
  std::uint64_t law_rounds = 0, sample_rounds = 0;
  std::uint64_t close_law_rounds = 0, close_rounds = 0;  ///< 0 if an older report does not have it
  std::uint64_t rounded_law_rounds = 0, rounded_rounds = 0;
};

/// Returns an amount with this many pairs in all: equal parts for the strata together, close contacts,
/// and rounded solids if some guest supports them. Each has whole rounds, and at least one.
GateAmount amount_of(std::uint64_t pairs, const DrawnSolids& solids = {});

/// Scales the pairs into the range. Drops those that do not fit or that no method supports.
void keep_supported(SampleRound& round, std::span<const std::unique_ptr<Method>> methods,
                    const SizeRange& sizes);

/// The answers of one method to the pairs of a round, and whether each verdict is refuted.
struct RoundAnswers {
  std::vector<MethodAnswer> answers;
  std::span<const std::optional<Verdict>> truths;
  std::vector<bool> wrong, wrong_beyond;  ///< at all; beyond its claim
};

/// Counts a round into the method's cells.
void count_cells(GateMethod& method, const SampleRound& round, const RoundAnswers& said);

}  // namespace cyl
