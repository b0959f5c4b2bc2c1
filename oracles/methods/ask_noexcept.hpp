// SPDX-License-Identifier: MIT
// What a method answers, whatever it does short of ending the process.
#pragma once

#include "oracles/methods/contained.hpp"

namespace cyl {

/// Asks in this process, and turns what a method throws, and numbers that are none, into failures.
MethodAnswer ask_noexcept(Method& method, const Pair& pair, CallMode mode);

/// Returns the answer, as a failure where it is not one of a method's: of no known kind, or not finite.
MethodAnswer checked(MethodAnswer answer);

}  // namespace cyl
