// SPDX-License-Identifier: MIT
#pragma once

#include "solver/detail/slice_point.hpp"

namespace cyl {

// The last attempt if rounding in double spoiled the search or its certificate. It searches again in numbers
// of twice the digits, first for the pair grown by proof_slack_tol of the reach. Its directions separate the
// pair itself with as much room. Then it searches for the pair shrunk by as much, whose points lie that far
// inside (derivation.md, section 8). A pair that is still undecided has no gap and no common ball beyond that
// length. Axes are not parallel. Cost: some 20 us.
void prove_with_slack(ProofTask& question, const Axes& axes) noexcept;

}  // namespace cyl
