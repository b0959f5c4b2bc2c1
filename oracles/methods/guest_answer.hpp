// SPDX-License-Identifier: MIT
// Turns a guest's line into the answer of a method.
#pragma once

#include "corpus/pairs/method_answer.hpp"
#include "oracles/methods/guest_protocol.hpp"

namespace cyl {

/// With `depth_at_most`, a depth is an upper bound.
/// Returns the answer; of a point and a direction, the one that goes with the verdict.
MethodAnswer method_answer(const GuestAnswer& said, bool depth_at_most);

}  // namespace cyl
