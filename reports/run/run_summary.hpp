// SPDX-License-Identifier: MIT
// What a person wants to know at the end of a run, in some ten lines.
#pragma once

#include <string>

#include "reports/run/run_data.hpp"

namespace cyl {

/// Returns the finding to look at first: beyond a claim before within, a wrong verdict before anything else,
/// then by margin; nullptr where there is none.
const FindingRecord* worst_finding(const RunData& run);

/// Returns lines, each with its end: what was judged, what is new, who is wrong beyond its claim and how
/// often, who crashed, hung or threw, how ours fared, the faults that were planted.
std::string format_summary(const RunData& run);

}  // namespace cyl
