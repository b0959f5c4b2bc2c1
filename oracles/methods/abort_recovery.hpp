// SPDX-License-Identifier: MIT
// Recovery from failed assertions inside a worker. A new worker costs 10 to 25 ms. A return from an assertion
// costs nothing.
#pragma once

#include "oracles/methods/contained.hpp"

namespace cyl {

/// Failed assertions from which one worker recovers. Each one leaks the memory that the call had allocated.
inline constexpr int recovery_cap = 64;

/// Asks as ask_noexcept() does.
/// 1. If the library keeps no state between calls (Method::recovers), its failed assertion is an answer. The
///    answer is a crash, with the text that the death of the process would have had.
/// 2. Every other abort ends the process, as do assertions beyond `recovery_cap`.
/// 3. The text is taken from standard error. It must be a file that can be truncated, and is empty
///    afterwards.
MethodAnswer ask_recovering(Method& method, const Pair& pair, CallMode mode);

/// Returns "SIGABRT, after printing: ...": `how`, and the last words in the file, cut to the length of a
/// reason.
std::string with_last_words(const std::string& how, int output);

}  // namespace cyl
