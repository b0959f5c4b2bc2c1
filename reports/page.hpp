// SPDX-License-Identifier: MIT
// The page of a run: one HTML file, nothing beside it and nothing from the network. It is the template that
// reports/page/ is built to (reports/report_template.html, inside this program) with the data of the run in
// it.
#pragma once

#include <string>
#include <string_view>

namespace cyl {

/// Writes FOLDER/report.html from report_json(), all at once: a reader sees the old page or the new one.
/// Throws std::runtime_error where it cannot.
void write_page(const std::string& run_folder, const std::string& kill_matrix = {});

/// The template with that JSON in it, written so that no text of it can end the element that holds it.
std::string fill_template(std::string_view json);

}  // namespace cyl
