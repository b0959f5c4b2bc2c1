// SPDX-License-Identifier: MIT
// The page of a run: one HTML file, nothing beside it and nothing from the network. It is
// reports/web/page_template.html with the data in it.
#pragma once

#include <string>
#include <string_view>

namespace cyl {

/// Returns the page that shows a run (report_json). The page holds the JSON compressed (zlib, RFC 1950) and
/// in base64, so that no text in it can end the element that holds it.
std::string fill_template(std::string_view json);

}  // namespace cyl
