// SPDX-License-Identifier: MIT
// The pages: one HTML file each, nothing beside it and nothing from the network. It is a template that
// reports/web/ is built to (inside this program) with its data in it.
#pragma once

#include <string>
#include <string_view>

namespace cyl {

enum class Template : unsigned char {
  report,  ///< reports/web/report_template.html: a run, its data by report_json()
  scene    ///< reports/web/scene_template.html: a scene, its data by study_json()
};

/// Writes FOLDER/report.html from report_json(), all at once: a reader sees the old page or the new one.
/// Throws std::runtime_error where it cannot.
void write_page(const std::string& run_folder, const std::string& kill_matrix = {});

/// The template with that JSON in it, written so that no text of it can end the element that holds it.
std::string fill_template(Template which, std::string_view json);

}  // namespace cyl
