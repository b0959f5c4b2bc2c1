// SPDX-License-Identifier: MIT
// The command that runs this program, for the commands that the program prints.
#pragma once

#include <string>

namespace cyl {

/// Returns the launcher's name from DAYLIGHT_COMMAND, else "daylight", quoted for a shell.
std::string own_command();

}  // namespace cyl
