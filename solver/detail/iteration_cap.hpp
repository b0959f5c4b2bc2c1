// SPDX-License-Identifier: MIT
#pragma once

namespace cyl {

/// Steps inside an edge before `undecided`. Exact arithmetic never reaches it (derivation.md, section 5).
inline constexpr int iteration_cap = 200;

/// The cap of all searches of decide(): of the search in double, and of two in twice the digits.
inline constexpr int decide_iteration_cap = 3 * iteration_cap;

}  // namespace cyl
