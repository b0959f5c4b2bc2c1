// SPDX-License-Identifier: MIT
// The summary at the end of a run, in some ten lines.
#pragma once

#include <string>

#include "reports/run/run_data.hpp"

namespace cyl {

/// Returns the finding to look at first: beyond a claim before within, a wrong verdict before other kinds,
/// then by margin. Returns nullptr if there is none.
const FindingRecord* worst_finding(const RunData& run);

/// Returns lines, each with its end. They have the counts of pairs and methods, the changes since earlier
/// runs, and the methods that are wrong or failed. The results of our methods come last.
std::string format_summary(const RunData& run);

}  // namespace cyl
