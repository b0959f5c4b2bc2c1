// SPDX-License-Identifier: MIT
// The worst pair of a cause: from the findings that have it fuzz/worst/worst.hpp looks for a larger margin of
// the same cause.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fuzz/worst/worst.hpp"
#include "oracles/trial/compare.hpp"
#include "oracles/trial/mechanism.hpp"

namespace cyl {

/// One cause, and where to begin.
struct CauseSought {
  std::string key;                                 ///< as cause_key() gives it
  Mechanism mechanism = Mechanism::unclassified;   ///< of the first start
  std::size_t method = 0;                          ///< that is asked
  FindingKind kind = FindingKind::wrong_disjoint;  ///< a refuted verdict
  std::vector<Pair> starts;                        ///< on which it fails of this cause, the worst first
};

/// Returns the domain of the search. If the cause is about size or position, it extends from the least to the
/// largest of the starts, because beyond them every method is wrong by any margin. Else it has ordinary
/// pairs.
Domain domain_of(Mechanism mechanism, std::span<const Pair> starts);

/// Returns the pair with the largest margin beyond the method's claim that is wrong in the same way
/// by the same cause, or nothing. `options.domain` is not used. Deterministic if the limit on shapes
/// ends it. Cost: that of worst_of(), and some milliseconds for each pair that would be the worst so
/// far.
std::optional<WrongPair> worst_of_cause(const GroupedMethods& methods, const CauseSought& cause,
                                        WorstOptions options, const Caps& caps);

}  // namespace cyl
