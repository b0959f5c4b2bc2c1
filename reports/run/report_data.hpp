// SPDX-License-Identifier: MIT
// The page of a run, and what it is given: JSON, interface Report of reports/web/run/data.ts.
#pragma once

#include <string>

#include "reports/run/run_data.hpp"

namespace cyl {

/// Returns what the page shows: the run, what its charts hold (an object with maps, honesty, speed, cost,
/// paths, backward, builds), what triage left (buckets_json() of triage.hpp), and the kill matrix in the file
/// of that name, if any. A finding whose record holds no pair is counted, not told. One line of valid UTF-8.
/// Distances are enclosed anew, nearest points are the solver's and approximate. Cost: some 0.1 ms a pair.
/// Throws std::runtime_error that names the file where one cannot be read or holds something else.
std::string report_json(const RunData& run, const std::string& kill_matrix = {});

/// Writes RUN/report.html, all at once: a reader sees the old page or the new one. Throws std::runtime_error
/// where it cannot.
void write_page(const RunData& run, const std::string& kill_matrix = {});

}  // namespace cyl
