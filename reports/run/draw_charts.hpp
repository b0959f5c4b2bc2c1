// SPDX-License-Identifier: MIT
// The plots of a run's page as files, for a paper or a README.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "reports/run/run_data.hpp"

namespace cyl {

/// Writes OUT/*.svg, and beside each a .png where rsvg-convert is there, from report_json() of the run, with
/// the script that reports/web/ is built to (chart.mjs) in Node. Returns the files it wrote, sorted. Throws
/// std::runtime_error that says what is missing or failed.
/// `on_picture` is called after each picture with how many are drawn, of how many.
std::vector<std::string> draw_charts(const RunData& run, const std::string& out, const std::string& script,
                                     const std::function<void(std::size_t, std::size_t)>& on_picture);

}  // namespace cyl
