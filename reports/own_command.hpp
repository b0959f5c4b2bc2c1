// SPDX-License-Identifier: MIT
// What a user types to run this program, for the commands that are shown.
#pragma once

#include <string>

namespace cyl {

/// "./daylight", the launcher, for a program of a build folder; "daylight" where it is installed.
std::string own_command();

}  // namespace cyl
