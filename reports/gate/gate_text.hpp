// SPDX-License-Identifier: MIT
// The gate's result for people: what came of each method, what broke and how to see it again, and last, in
// one line a method, what was proved.
#pragma once

#include <cstddef>
#include <string>

#include "props/gate/gate.hpp"

namespace cyl {

/// Further buckets of one law and kind of failure that are told; then how many more.
inline constexpr std::size_t also_cap = 5;
/// Breaks told in one line each (within claims, or known), of all methods together; then how many more.
inline constexpr std::size_t brief_cap = 20;

/// What was not asked is told before the methods. Beside the pairs and what is quoted of methods, no line is
/// wider than 120 columns.
std::string gate_text(const GateReport& report);

/// The last line of one method: what its independent pairs prove. Nothing of it comes from kept cases or
/// from laws.
std::string proved_in_words(const GateMethod& method);

}  // namespace cyl
