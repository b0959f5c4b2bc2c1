// SPDX-License-Identifier: MIT
// One method asked about pairs made up on purpose: contained, many at a time, each answer held against what
// is proved of its pair.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "oracles/methods/contained.hpp"
#include "oracles/methods/method.hpp"
#include "oracles/referee/referee.hpp"
#include "oracles/trial/compare.hpp"

namespace cyl {

struct Probe {
  Pair pair;
  Truth truth;
  Enclosure distance;  ///< signed; meaningful where the truth is decided; as wide as the finding left it
  MethodAnswer answer;
  std::optional<Finding> finding;

  bool decided() const { return truth.verdict != Verdict::undecided && truth.verdict != Verdict::invalid; }
  bool fails(FindingKind kind) const { return finding && finding->kind == kind; }
  /// Answered, decided, and nothing is wrong with it.
  bool right() const {
    return decided() && !finding && answer.status == Status::answered && answer.verdict != Verdict::undecided;
  }
};

/// Shorter than a campaign's: hundreds of pairs may be asked around one that hangs.
inline constexpr Caps probe_caps{
    .call_cpu = std::chrono::milliseconds(200), .call_wall = std::chrono::milliseconds(4000), .hangs = 8};

/// In the order of the pairs. Throws std::system_error only where the system refuses a process or memory.
std::vector<Probe> probe(const std::unique_ptr<Method>& method, std::span<const Pair> pairs,
                         const Caps& caps = probe_caps);
/// Of one pair, with the caps of a campaign, and the distance narrow.
Probe probe_one(const std::unique_ptr<Method>& method, const Pair& pair);

/// Encloses the distance until it is known to a thousandth of itself, as far as it can be.
void narrow_distance(Probe& probe);

/// The method of that name. Throws UsageError where there is none.
const std::unique_ptr<Method>& find_method(std::span<const std::unique_ptr<Method>> methods,
                                           std::string_view name);

/// "3.1e-07 apart", "overlapping by 0.05", "touching".
std::string distance_in_words(const Probe& probe);

}  // namespace cyl
