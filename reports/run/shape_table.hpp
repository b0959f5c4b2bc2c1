// SPDX-License-Identifier: MIT
// The methods that are wrong about some shapes, as text.
#pragma once

#include <string>

#include "reports/run/run_data.hpp"

namespace cyl {

/// Returns a line for each method and pair of shapes with an answer wrong beyond the claim at ordinary sizes.
/// It has the numbers of answers and of wrong ones, and the end of the widest decade of margins with a wrong
/// one. The text is empty if there is none.
std::string format_shapes(const RunData& run);

}  // namespace cyl
