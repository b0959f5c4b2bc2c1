// SPDX-License-Identifier: MIT
// How this thread's processor rounds and treats small numbers: what a library may leave changed.
#pragma once

#include <string>

namespace cyl {

struct ControlWords {
  unsigned vector = 0;  ///< MXCSR without its sticky bits
  unsigned short x87 = 0;
  bool operator==(const ControlWords&) const = default;
};

#if defined(__x86_64__)
inline constexpr unsigned sticky_bits = 0x3f;  ///< of MXCSR: what has happened, no mode

inline ControlWords read_control_words() noexcept {
  ControlWords words;
  words.vector = __builtin_ia32_stmxcsr() & ~sticky_bits;
  __asm__ volatile("fnstcw %0" : "=m"(words.x87));
  return words;
}
inline void write_control_words(const ControlWords& words) noexcept {
  __builtin_ia32_ldmxcsr(words.vector);
  __asm__ volatile("fldcw %0" : : "m"(words.x87));
}
#else
inline ControlWords read_control_words() noexcept { return {}; }
inline void write_control_words(const ControlWords&) noexcept {}
#endif

/// Returns what was left changed: "left the rounding mode changed, flushes small numbers to zero".
inline std::string describe_change(const ControlWords& before, const ControlWords& after) {
  constexpr unsigned rounding = 0x6000, to_zero = 0x8000, inputs_to_zero = 0x40;  // of MXCSR
  const unsigned changed = before.vector ^ after.vector;
  std::string text;
  const auto add = [&](bool is_so, const char* what) {
    if (is_so) text += (text.empty() ? "left " : ", ") + std::string(what);
  };
  add((changed & rounding) != 0, "the rounding mode changed");
  add((changed & to_zero) != 0, "small results becoming 0");
  add((changed & inputs_to_zero) != 0, "small operands taken as 0");
  add((changed & ~(rounding | to_zero | inputs_to_zero)) != 0, "floating-point traps changed");
  add(before.x87 != after.x87, "the x87 control word changed");
  return text;
}

}  // namespace cyl
