// SPDX-License-Identifier: MIT
// Asks a method so that no exception and no invalid number leaves the call.
#pragma once

#include "oracles/methods/contained.hpp"

namespace cyl {

/// Asks in this process. An exception, an unknown value of an enum, or a number that is not finite becomes a
/// failure.
MethodAnswer ask_noexcept(Method& method, const Pair& pair, CallMode mode);

/// Returns the answer. An answer with an unknown value of an enum, or a number that is not finite, becomes a
/// failure.
MethodAnswer checked(MethodAnswer answer);

}  // namespace cyl
