// SPDX-License-Identifier: MIT
// Whether a failure is the library's own, or hangs on the last bit of what our adapter computes for it.
#pragma once

#include <optional>
#include <string_view>

#include "oracles/trial/trial.hpp"

namespace cyl {

/// Asks once more, contained, with the sums of our support function in another order, and returns whether the
/// method does not fail so. Nothing if its library asks no support function of ours.
std::optional<bool> hangs_on_our_sums(std::string_view method, FindingKind kind, const Pair& pair);

}  // namespace cyl
