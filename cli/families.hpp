// SPDX-License-Identifier: MIT
// The families that an option names, and the cases asked beside them.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "corpus/pairs/families.hpp"
#include "corpus/pairs/pair_io.hpp"

namespace cyl {

/// Returns whether pairs of such kinds of solids are wanted.
using PairFilter = std::function<bool(const Pair&)>;

/// Returns the families of a campaign that `spec` names by the rule of select_names(). If `spec` is empty,
/// returns all whose pairs are wanted.
std::vector<Family> families_named(std::string_view spec, const PairFilter& is_wanted);

/// Returns the cases of `folder` that are wanted; none if `folder` is empty. Throws as read_case_folder().
std::vector<Case> cases_in(const std::string& folder, const PairFilter& is_wanted);

}  // namespace cyl
