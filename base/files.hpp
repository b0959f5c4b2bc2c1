// SPDX-License-Identifier: MIT
// Whole files, such as those that options like --json FILE name.
#pragma once

#include <string>

namespace cyl {

/// Returns the bytes of a file, or nothing if it cannot be read.
std::string read_file(const std::string& name);

/// Overwrites an existing file. Throws std::runtime_error that names the file if it cannot.
void write_file(const std::string& name, const std::string& text);

/// Replaces the file of that name atomically, so a reader sees the old or the new file. Does not follow a
/// symbolic link. Throws std::runtime_error that names the file if it cannot.
void replace_file(const std::string& name, const std::string& text);

}  // namespace cyl
