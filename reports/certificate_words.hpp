// SPDX-License-Identifier: MIT
// A certificate as a sentence that a person can check.
#pragma once

#include <string>
#include <string_view>

namespace cyl {

/// "The plane with normal (1, 0, 0) separates them ..." from the JSON object of format_truth.
std::string certificate_in_words(std::string_view truth_json);

}  // namespace cyl
