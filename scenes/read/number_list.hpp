// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace cyl {

/// Returns the numbers of a text, finite and with blanks between them. Throws std::runtime_error "WHAT is
/// 'TEXT', no numbers".
std::vector<double> parse_numbers(const std::string& text, const std::string& what);

}  // namespace cyl
