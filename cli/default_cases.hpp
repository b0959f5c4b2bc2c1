// SPDX-License-Identifier: MIT
// Where the case files are.
#pragma once

#include <string>

namespace cyl {

/// corpus/ of the source tree that this executable was built in, or of the working directory; empty: there is
/// none.
std::string default_cases();

}  // namespace cyl
