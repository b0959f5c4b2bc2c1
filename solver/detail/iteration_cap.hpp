// SPDX-License-Identifier: MIT
#pragma once

namespace cyl {

/// Steps inside an edge before `undecided`. Exact arithmetic never reaches it (derivation.md, section 5), nor
/// has any pair.
inline constexpr int iteration_cap = 200;

}  // namespace cyl
