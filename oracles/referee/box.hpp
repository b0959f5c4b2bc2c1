// SPDX-License-Identifier: MIT
// The referee for a bounded solid and a box. The search for nearest points offers a direction or points in
// double, which the filter checks. Exact arithmetic decides the rest (box_sign.hpp).
#pragma once

#include <optional>

#include "oracles/referee/certificate_check.hpp"
#include "oracles/referee/referee.hpp"

namespace cyl {

/// The verdict with its certificate, if doubles prove it. Cost: 2 us, 20 us for flat solids that meet.
std::optional<Truth> prove_box_in_double(const Pair& pair, const Filter& filter);
/// Without a certificate. Cost: 2 us.
std::optional<Verdict> box_verdict_in_double(const Pair& pair, const Filter& filter);
/// The same in two doubles. Cost: 20 us.
std::optional<Verdict> box_verdict_in_twins(const Pair& pair, const TwinFilter& filter);

/// The verdict with its certificate, in rationals. Its kinds are those of other pairs. `undecided` only for a
/// box and a rounded cylinder, at the cap on bits.
Truth judge_box_exactly(const Pair& pair, int bits_cap);
/// Without a certificate.
Truth box_verdict_exactly(const Pair& pair);

}  // namespace cyl
