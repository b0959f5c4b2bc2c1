// SPDX-License-Identifier: MIT
// Who is wrong about which shapes, as text.
#pragma once

#include <string>

#include "reports/run/run_data.hpp"

namespace cyl {

/// A line for each method and pair of shapes with an answer wrong beyond the claim at ordinary sizes: how
/// many were asked and how many were wrong, and the end of the widest decade of margins with a wrong one.
/// Empty if there is none.
std::string format_shapes(const RunData& run);

}  // namespace cyl
