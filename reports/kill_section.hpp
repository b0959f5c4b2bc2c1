// SPDX-License-Identifier: MIT
// What the harness is worth: the kill matrix of the mutants, as a section of the page.
#pragma once

#include <string>

namespace cyl {

/// HTML from the rows that `daylight mutants matrix --json FILE` wrote: how many planted faults were caught,
/// by part of the program and by detector, and every one of them. Empty where the file does not exist; throws
/// std::runtime_error naming the file where it is something else.
std::string kill_section(const std::string& file);

}  // namespace cyl
