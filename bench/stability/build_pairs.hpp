// SPDX-License-Identifier: MIT
// The input of the programs that bench/stability/builds.sh compares: the methods, and the pairs as plain
// numbers.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "corpus/pairs/pair_numbers.hpp"
#include "oracles/methods/method.hpp"

namespace cyl {

static_assert(std::is_trivially_copyable_v<MethodAnswer>);

inline constexpr std::size_t doubles_per_pair = 2 * cylinder_number_count;

inline void numbers_of(const Pair& pair, double (&x)[doubles_per_pair]) {
  std::ranges::copy(numbers_of(pair), x);
}

/// Returns ours without `exact`, and those of the texts; each is asked on the indices divisible by its share.
inline std::vector<std::unique_ptr<Method>> built_methods() {
  auto methods = own_methods();
  std::erase_if(methods, [](const auto& method) { return method->claim().decides == DecisionScope::all; });
  for (auto make : {literature_2008_methods, literature_2017_methods})
    for (auto& method : make()) methods.push_back(std::move(method));
  return methods;
}

}  // namespace cyl
