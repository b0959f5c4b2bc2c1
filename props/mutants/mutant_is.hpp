// SPDX-License-Identifier: MIT
// The switch in mutated sources. Always inlined: kernels for several instruction sets have it in them.
#pragma once

namespace cyl {

extern int selected_mutant;

[[gnu::always_inline]] inline bool mutant_is(int number) noexcept {
  // Without the hint gcc 12 fails with an internal error if many of these select between masks of lanes.
  return __builtin_expect(selected_mutant == number, 0);
}

}  // namespace cyl
