// SPDX-License-Identifier: MIT
// What an option like --json FILE asks for.
#pragma once

#include <string>

namespace cyl {

/// Writes over what is there. Throws std::runtime_error that names the file where it cannot.
void write_file(const std::string& name, const std::string& text);

/// Puts a file in the place of what has that name, at once: whoever reads sees the former or the new one.
/// Follows no symbolic link. Throws std::runtime_error that names the file if it cannot.
void replace_file(const std::string& name, const std::string& text);

}  // namespace cyl
