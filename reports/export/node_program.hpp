// SPDX-License-Identifier: MIT
// Lists the files and packages that a Node.js program needs, so that it runs in an empty folder.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cyl {

struct NodeProgram {
  std::vector<std::string> files;     ///< it and the files that it imports, relative to its folder
  std::vector<std::string> packages;  ///< "name@version": those that it imports, of package.json beside it
};

/// Returns what a program (.mjs, .cjs or .js) imports by the name of a package, or by a path to a file in its
/// folder or below. Another file imports nothing.
NodeProgram node_program(const std::filesystem::path& file);

}  // namespace cyl
