// SPDX-License-Identifier: MIT
// Where the project's own files are.
#pragma once

#include <string>

namespace cyl {

/// A file or folder of the source tree that this executable was built in, or of the working directory, e.g.
/// "corpus"; empty: there is none.
std::string in_source_tree(const std::string& name);

}  // namespace cyl
