// SPDX-License-Identifier: MIT
#include "oracles/trial/hangs_on_sums.hpp"

#include "oracles/methods/other_sums.hpp"

namespace cyl {

std::optional<bool> hangs_on_our_sums(std::string_view method, FindingKind kind, const Pair& pair) {
  for (const auto& m : ccd_methods_of_other_sums())
    if (m->name() == method) return !try_method(m, pair).fails(kind);
  return {};
}

}  // namespace cyl
