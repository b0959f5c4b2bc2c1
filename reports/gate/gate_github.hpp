// SPDX-License-Identifier: MIT
// The gate's result as workflow commands of GitHub Actions: lines of standard output that become annotations
// of the case or the law.
#pragma once

#include <cstddef>
#include <string>

#include "props/gate/gate.hpp"

namespace cyl {

/// Annotations of one kind; the service itself drops those of a step beyond ten.
inline constexpr std::size_t annotations_cap = 10;

/// One ::error for each method, law and kind of failure that fails the gate, in the order of the report, at
/// most annotations_cap; then a ::notice saying how many more there are, and a ::warning for each line of
/// what was not asked. Empty where nothing fails the gate and all was asked.
std::string gate_github(const GateReport& report);

}  // namespace cyl
