// SPDX-License-Identifier: MIT
// Groups methods that share an algorithm, as far as their errors show: methods that are wrong on the same
// pairs in the same way are one group. The pairs are fixed. So the groups depend only on the build, and not
// on the findings of a run.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "oracles/methods/method.hpp"

namespace cyl {

/// Returns whether two methods differ in a setting alone, by the rule <library>[-<way>][-<setting>] of names.
/// They do if one name is the other with '-' and more, or if both have the same library and way. A guest has
/// no settings but those of its own library.
bool differ_in_setting(const Method& x, const Method& y);

/// Returns for each method the first method of its shared-algorithm group. A group holds
/// 1. methods that differ in a setting,
/// 2. methods of one library, if one is hardly ever wrong on a pair on which the other is right,
/// 3. methods of different libraries for which 2 holds, and which are wrong about equally often.
/// A guest is grouped by its name alone, and changes no other group. Cost: all methods but guests are asked,
/// contained, about 400 pairs near touching. That is about a second for all_methods(). Methods that are not
/// `asked` are grouped by name alone. That changes no group within a library of methods that are asked.
std::vector<std::size_t> algorithm_groups(
    std::span<const std::unique_ptr<Method>> methods,
    const std::function<bool(const Method&)>& asked = [](const Method&) { return true; });

}  // namespace cyl
