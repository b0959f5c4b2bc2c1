// SPDX-License-Identifier: MIT
// Faults that a new version of a guest has and the version of an earlier run had not. No chance is left: both
// versions were asked about the same pairs.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "reports/triage/causes.hpp"

namespace cyl {

struct TriageContext;

/// A method of a guest that changed, and what it gets wrong beyond its claim on pairs that it had right.
struct ChangedGuest {
  std::string method, version, earlier_version, earlier_run;
  std::uint64_t asked = 0;  ///< pairs of the earlier run
  std::uint64_t wrong = 0;  ///< of them, at least
  /// Pairs of families in which it is right on all failures that the earlier run keeps.
  std::uint64_t wrong_elsewhere = 0;
  std::uint64_t skipped = 0;                    ///< pairs of families too large to be drawn again
  std::map<std::string, NewFault> newly_wrong;  ///< by the key of the cause
};

/// Compares each guest of the run with the last earlier run that asked another version of the guest. Asks
/// about the pairs that the earlier run drew for it. Seed and index give them again. Stops when that part of
/// the budget is used up.
std::vector<ChangedGuest> ask_earlier_pairs(const TriageContext& context,
                                            const std::vector<TriagedRun>& earlier, double part);

/// "mine 1.1 is wrong beyond its claim on 7 of the 9 pairs of night-1 that were asked again, on which
/// version 1.0 was right".
std::string in_words(const ChangedGuest& guest);

}  // namespace cyl
