// SPDX-License-Identifier: MIT
// What the harness is worth: the kill matrix of the mutants, for the page.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace cyl {

/// From the rows that `daylight mutants matrix --json FILE` wrote: how many planted faults there are, how
/// many were caught and argued equivalent, and every one of them with who caught it. null where the file does
/// not exist; throws std::runtime_error naming the file where it is something else.
nlohmann::ordered_json kill_data(const std::string& file);

}  // namespace cyl
