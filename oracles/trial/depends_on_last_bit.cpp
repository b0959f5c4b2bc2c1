// SPDX-License-Identifier: MIT
#include "oracles/trial/depends_on_last_bit.hpp"

#include "oracles/methods/other_sums.hpp"

namespace cyl {

std::optional<bool> depends_on_last_bit(std::string_view method, FindingKind kind, const Pair& pair) {
  for (const auto& m : ccd_methods_of_other_sums())
    if (m->name() == method) return !try_method(m, pair).fails(kind);
  return {};
}

}  // namespace cyl
