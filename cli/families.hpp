// SPDX-License-Identifier: MIT
// The families that an option names.
#pragma once

#include <string_view>
#include <vector>

#include "corpus/pairs/families.hpp"

namespace cyl {

/// Returns the families of a campaign that `spec` names by the rule of select_names(); "": all, but those of
/// rounded solids only if asked for.
std::vector<Family> families_named(std::string_view spec, bool rounded);

}  // namespace cyl
