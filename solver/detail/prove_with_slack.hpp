// SPDX-License-Identifier: MIT
#pragma once

#include "solver/detail/slice_point.hpp"

namespace cyl {

// The last word where rounding in double spoiled the search or its certificate: the search once more in
// numbers of twice the digits, for the pair grown by proof_slack_tol of the reach, whose directions separate
// the pair itself with as much room; then for the pair shrunk by as much, whose points lie that far inside
// (derivation.md, section 8). What is undecided after that has no gap and no common ball beyond that length.
// Axes not parallel. Cost: some 20 us.
void prove_with_slack(ProofTask& question, const Axes& axes) noexcept;

}  // namespace cyl
