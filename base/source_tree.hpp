// SPDX-License-Identifier: MIT
// Where the project's own files are.
#pragma once

#include <string>

namespace cyl {

/// A file or folder of the source tree, e.g. "corpus": of the tree that this executable was built in, of
/// PREFIX/share/daylight where it is installed as PREFIX/bin/daylight, or of the working directory; empty:
/// there is none.
std::string in_source_tree(const std::string& name);

}  // namespace cyl
