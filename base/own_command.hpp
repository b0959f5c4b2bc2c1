// SPDX-License-Identifier: MIT
// What a user types to run this program, for the commands that are shown.
#pragma once

#include <string>

namespace cyl {

/// As the launcher was called, which tells it in DAYLIGHT_COMMAND; else "daylight". A word of a shell.
std::string own_command();

}  // namespace cyl
