// SPDX-License-Identifier: MIT
// Which methods share an algorithm, as far as their errors tell: those that are wrong on the same pairs in
// the same way are one group. The pairs never change, so that the groups depend on the build alone and not on
// what a run happened to find.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "oracles/methods/method.hpp"

namespace cyl {

/// Returns "fcl" of "fcl-libccd-tol1e-10".
std::string_view library_of(std::string_view method);

/// Returns whether two names differ in a setting alone, by the rule <library>[-<way>][-<setting>]: one begins
/// with the other and '-', or both with the same library and way.
bool differ_in_setting(std::string_view x, std::string_view y);

/// Returns for each method the first one of its shared-algorithm group. A group holds methods that differ in
/// a setting, those of one library of which one is hardly ever wrong where the other is right, and those of
/// different libraries that are moreover wrong about equally often. A guest is grouped by its name alone, and
/// changes no group of others. Cost: every method but guests is asked, contained, about 400 pairs near
/// touching; about a second with those of all_methods().
std::vector<std::size_t> algorithm_groups(std::span<const std::unique_ptr<Method>> methods);

}  // namespace cyl
