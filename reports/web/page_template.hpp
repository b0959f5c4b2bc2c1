// SPDX-License-Identifier: MIT
// The page of a run or of a scene: one HTML file, nothing beside it and nothing from the network. It is
// page_template.html, which the sources in this folder are built to, with the data in it.
#pragma once

#include <string>
#include <string_view>

namespace cyl {

enum class PageSolver : unsigned char { left_out, included };

/// Returns the page that shows a JSON object: a run (report_json) or a scene (study_json). The page holds it
/// compressed (zlib, RFC 1950) and in base64, so that no text in it can end the element that holds it.
/// Pages that ask the solver also hold it, as a WebAssembly module (wasm/build.sh).
std::string fill_template(std::string_view json, PageSolver solver = PageSolver::left_out);

}  // namespace cyl
