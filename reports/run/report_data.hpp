// SPDX-License-Identifier: MIT
// The page of a run, and what it is given: JSON, as reports/schemas/report_data.json describes it.
#pragma once

#include <string>

#include "reports/run/run_data.hpp"

namespace cyl {

/// Returns the data of the page: the run, its charts (an object with maps and speed), and the causes of
/// triage (causes_json() of triage.hpp).
/// 1. A finding without a pair is only counted.
/// 2. The result is one line of valid UTF-8.
/// 3. Distances are enclosed again. Nearest points are the solver's and approximate.
/// 4. Throws std::runtime_error that names a file that cannot be read or has other content.
/// Cost: some 0.1 ms a pair.
std::string report_json(const RunData& run);

/// Writes RUN/report.html atomically, so that a reader sees the old page or the new one. Throws
/// std::runtime_error if it cannot.
void write_page(const RunData& run);

}  // namespace cyl
