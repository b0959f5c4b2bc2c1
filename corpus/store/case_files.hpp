// SPDX-License-Identifier: MIT
// The case files: pairs that are kept, with what is known of them.
#pragma once

#include <string>
#include <vector>

#include "corpus/pairs/pair_io.hpp"

namespace cyl {

/// Every case of the *.jsonl files of a folder (not of its folders), in the order of the file names, then of
/// the lines. Throws InputError "FILE: line 3, column 17: a.radius is negative (-1)" at the first bad
/// line, and naming what cannot be read.
std::vector<Case> read_case_folder(const std::string& folder);

}  // namespace cyl
