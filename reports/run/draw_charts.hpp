// SPDX-License-Identifier: MIT
// The plots of a run's page as files, for a paper or a README.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "reports/run/run_data.hpp"

namespace cyl {

/// Writes OUT/*.svg, and a .png beside each if rsvg-convert is installed. It passes report_json() of the run
/// to the script chart.mjs, which is built from reports/web/, in Node. Returns the sorted files that it
/// wrote. Throws std::runtime_error with the missing program or the failure. `on_picture` is called after
/// each picture with the number drawn and the number of all.
std::vector<std::string> draw_charts(const RunData& run, const std::string& out, const std::string& script,
                                     const std::function<void(std::size_t, std::size_t)>& on_picture);

}  // namespace cyl
