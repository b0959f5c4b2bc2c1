// SPDX-License-Identifier: MIT
// The plots of a run's page as files, for a paper or a README.
#pragma once

#include <string>
#include <vector>

#include "reports/run/run_data.hpp"

namespace cyl {

/// Writes OUT/*.svg. It passes report_json() of the run to the script chart.mjs, which is built from
/// reports/web/, in Node. Returns the sorted files that it wrote. Throws std::runtime_error with the missing
/// program or the failure.
std::vector<std::string> draw_charts(const RunData& run, const std::string& out, const std::string& script);

}  // namespace cyl
