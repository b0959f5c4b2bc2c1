// SPDX-License-Identifier: MIT
// Failed assertions inside a worker. A new worker costs 10 to 25 ms; to return from an assertion costs
// nothing.
#pragma once

#include "oracles/methods/contained.hpp"

namespace cyl {

/// Failed assertions from which one worker recovers: each leaves behind what the call had allocated.
inline constexpr int recovery_cap = 64;

/// Asks as ask_noexcept() does. If the library's state does not outlive a call (Method::recovers), an
/// assertion of it that fails is an answer: a crash, with the text that the death of the process would have
/// had. Every other abort ends the process, as do assertions beyond `recovery_cap`. The text is taken from
/// standard error, which must be a file that can be cut: it is empty afterwards.
MethodAnswer ask_recovering(Method& method, const Pair& pair, CallMode mode);

/// Returns "SIGABRT, after printing: ...", as long as a reason can be: `how`, and the last words in a file.
std::string with_last_words(const std::string& how, int output);

}  // namespace cyl
