// SPDX-License-Identifier: MIT
// The programs and libraries that this user has started as guests on this machine. A run names its guests,
// and may come from a stranger. So a command starts only the guests of a run that are recorded here. The
// record is outside all runs, in $XDG_STATE_HOME/daylight/guests (~/.local/state/daylight/guests).
#pragma once

#include <string>
#include <vector>

#include "oracles/methods/guest.hpp"

namespace cyl {

/// Records guests that were named on a command line. Returns what went wrong, in words, or nothing.
std::string record_guests(const std::vector<Guest>& guests);

/// Returns whether this very file, or this very command in this folder, is recorded. Names and claims do not
/// matter: they start nothing.
bool is_recorded(const Guest& guest);

}  // namespace cyl
