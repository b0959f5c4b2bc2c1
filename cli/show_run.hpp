// SPDX-License-Identifier: MIT
// The output at the end of a run, of one machine or merged.
#pragma once

#include <filesystem>
#include <string>

namespace cyl {

/// Points runs/latest at a run in runs/; a run elsewhere has no such link.
void point_latest_at(const std::filesystem::path& run);

/// Writes the page. Prints the table of all methods if wanted, the summary, and the finding to look at
/// first.
void show_run(const std::string& folder, bool table);

}  // namespace cyl
