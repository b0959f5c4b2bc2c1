// SPDX-License-Identifier: MIT
// The page of a run: one HTML file, nothing beside it and nothing from the network.
#pragma once

#include <string>

namespace cyl {

/// Findings on the page of one method, kind and severity, the worst first; the store has the others.
inline constexpr std::size_t shown_per_group_cap = 6;
/// Findings on the page in all: with them a page stays below a few megabytes, whatever the run.
inline constexpr std::size_t shown_cap = 300;

/// Writes FOLDER/report.html from the store of the run in FOLDER, all at once: a reader sees the old page or
/// the new one; with the kill matrix in that file, where there is one. Throws std::runtime_error where it
/// cannot.
void write_page(const std::string& run_folder, const std::string& kill_matrix = {});

/// `text` with & < > " ' as character references, safe as content and as a quoted attribute; control
/// characters but newline and tab become U+FFFD, and those that reorder text are written as \u202e is.
std::string escape_html(std::string_view text);

}  // namespace cyl
