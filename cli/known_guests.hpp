// SPDX-License-Identifier: MIT
// Which programs and libraries this user has started as guests on this machine. A run names the guests that
// it asked, and a run may come from a stranger: of those guests a command starts only the ones recorded here.
// The record is outside all runs, in $XDG_STATE_HOME/daylight/guests (~/.local/state/daylight/guests).
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
