// SPDX-License-Identifier: MIT
// What a person is shown at the end of a run, of one machine or merged.
#pragma once

#include <filesystem>
#include <string>

namespace cyl {

/// Points runs/latest at a run in runs/; a run elsewhere has no such link.
void point_latest_at(const std::filesystem::path& run);

/// Writes the page; prints the summary and the finding to look at first; before them, if asked for, the table
/// of all methods.
void show_run(const std::string& folder, bool table);

}  // namespace cyl
