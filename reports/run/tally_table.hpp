// SPDX-License-Identifier: MIT
// The counts of a run, by method and family, as the terminal and the page show them.
#pragma once

#include <string>
#include <vector>

#include "corpus/store/run_store.hpp"

namespace cyl {

struct MethodTally {
  std::string method;
  Counts total;
  std::vector<TallyRecord> families;  ///< in the order of the run; those never asked are absent
};

/// Sums the tallies of a run by method: the methods in the order of the run, then what the cases state, then
/// the referee.
std::vector<MethodTally> tally_methods(const std::vector<TallyRecord>& tallies);

/// A text table: for each method its totals, then the families in which it was wrong beyond its claim or
/// failed. Findings within claims are only in the totals and on the page.
std::string format_tallies(const std::vector<MethodTally>& tallies);

}  // namespace cyl
