// SPDX-License-Identifier: MIT
// Finds out whether a failure is the library's own, or depends on the last bit of our adapter's sums.
#pragma once

#include <optional>
#include <string_view>

#include "oracles/trial/trial.hpp"

namespace cyl {

/// Asks once more, contained, with the sums of our support function in another order. Returns whether this
/// failure is then absent. Returns nothing if the library does not call our support function.
std::optional<bool> depends_on_last_bit(std::string_view method, FindingKind kind, const Pair& pair);

}  // namespace cyl
