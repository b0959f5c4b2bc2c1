// SPDX-License-Identifier: MIT
// The plots of a run's page as files, for a paper or a README.
#pragma once

#include <string>
#include <vector>

#include "reports/run/run_data.hpp"

namespace cyl {

/// Writes OUT/*.svg, and beside each a .png where rsvg-convert is there, from report_json() of the run, with
/// the script that reports/web/ is built to (chart.mjs) in Node. Returns the files it wrote, sorted. Throws
/// std::runtime_error that says what is missing or failed.
std::vector<std::string> draw_charts(const RunData& run, const std::string& out, const std::string& script);

}  // namespace cyl
