// SPDX-License-Identifier: MIT
// Searches for pairs on which methods break laws, by RapidCheck. It draws pairs of a kind, and shrinks a
// failing pair if possible.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "props/laws/examine.hpp"

namespace cyl {

/// A law broken on a pair that was drawn.
struct LawFailure {
  std::size_t method = 0;
  const Law* law = nullptr;
  Violation violation;
  Pair pair;
  std::string from;            ///< the kind of pairs it was drawn from
  std::optional<Pair> shrunk;  ///< as far as RapidCheck could shrink it, if that was wanted
};

struct SearchRound {
  std::vector<LawFailure> failures;            ///< in the order found
  std::vector<AnswerCounts> counts;            ///< by method
  std::map<std::string, std::uint64_t> drawn;  ///< pairs by kind: RapidCheck's classification
  std::vector<Pair> pairs;                     ///< all that were drawn, in their order
};

/// Whether a contract break of this law by this method is news, so that it is worth shrinking; asked again
/// while it is shrunk.
using WorthShrinking = std::function<bool(const LawFailure&)>;

/// The number of pairs of one draw, at most.
inline constexpr int pairs_per_draw = 16;

/// The source of drawn pairs. The pairs that a seed draws from `kinds` never change, because a gate's base
/// names its pairs by seeds. New families go to `close_contacts`.
enum class PairSource : unsigned char {
  kinds,           ///< the grid, the families of version 0.1.0, the strata
  close_contacts,  ///< of every cell, and the families since
  rounded          ///< the families of rounded solids
};

/// Draws pairs of one kind `draws` times, and checks the methods with all wanted laws. The drawn pairs depend
/// on the seed and `draws` only. The first new failure is shrunk. A pure function of its arguments except for
/// hangs.
SearchRound find_violations(std::span<const std::unique_ptr<Method>> methods, const LawFilter& wanted,
                            const WorthShrinking& is_worth_shrinking, PairSource source, std::uint64_t seed,
                            int draws, Asker& asker);

/// Likewise, in workers that are started for it.
SearchRound find_violations(std::span<const std::unique_ptr<Method>> methods, const LawFilter& wanted,
                            const WorthShrinking& is_worth_shrinking, PairSource source, std::uint64_t seed,
                            int draws, const Caps& caps);

}  // namespace cyl
