// SPDX-License-Identifier: MIT
// What a person is shown at the end of a run, of one machine or merged.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace cyl {

/// Points runs/latest at a run in runs/; a run elsewhere has no such link.
void point_latest_at(const std::filesystem::path& run);

/// Writes the page; prints the tallies, what is new against earlier runs, how its self-checks went, and the
/// finding to look at first.
void show_run(const std::string& folder, std::uint64_t pairs);

}  // namespace cyl
