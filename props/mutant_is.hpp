// SPDX-License-Identifier: MIT
// The switch in mutated sources. Always inlined: kernels for several instruction sets have it in them.
#pragma once

namespace cyl {

extern int selected_mutant;

[[gnu::always_inline]] inline bool mutant_is(int number) noexcept { return selected_mutant == number; }

}  // namespace cyl
