// SPDX-License-Identifier: MIT
// The summary at the end of a run, in some ten lines.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "reports/run/run_data.hpp"

namespace cyl {

/// Returns the positions of the findings in the order of all outputs. Findings beyond a claim come first.
/// Then ordinary sizes come first (is_ordinary()), then libraries, wrong verdicts, and large margins.
std::vector<std::size_t> worst_first(const RunData& run);

/// Returns lines, each with its end. They have the counts of pairs and methods, the changes since earlier
/// runs, and the methods that are wrong or failed. The results of our methods come last.
std::string format_summary(const RunData& run);

}  // namespace cyl
