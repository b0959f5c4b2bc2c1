// SPDX-License-Identifier: MIT
// The families that an option names, and the cases asked beside them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "corpus/pairs/families.hpp"
#include "corpus/pairs/pair_io.hpp"

namespace cyl {

/// Returns the families of a campaign that `spec` names by the rule of select_names(); "": all, but those of
/// rounded solids only if asked for.
std::vector<Family> families_named(std::string_view spec, bool rounded);

/// Returns the cases of `folder` ("": none), those of rounded solids only if `rounded`. Throws as
/// read_case_folder().
std::vector<Case> cases_in(const std::string& folder, bool rounded);

}  // namespace cyl
