// SPDX-License-Identifier: MIT
// The plots of a run's page as files, for a paper or a README.
#pragma once

#include <string>
#include <vector>

namespace cyl {

/// Writes OUT/*.svg, and beside each a .png where rsvg-convert is there, from report_json() of the run, with
/// the script that reports/web/ is built to (chart.mjs) in Node. Gives the files it wrote, sorted. Throws
/// std::runtime_error that says what is missing or failed.
std::vector<std::string> draw_charts(const std::string& run_folder, const std::string& out,
                                     const std::string& script);

}  // namespace cyl
