// SPDX-License-Identifier: MIT
// Finds the files of this project.
#pragma once

#include <string>

namespace cyl {

/// Returns a file or folder of the source tree, such as "corpus". It looks in the tree that this executable
/// was built in, then in PREFIX/share/daylight of an installation, then in the working directory. Empty if
/// there is none.
std::string in_source_tree(const std::string& name);

}  // namespace cyl
