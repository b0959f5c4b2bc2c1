// SPDX-License-Identifier: MIT
// Our own code with one fault, chosen at run time, to test that the gate sees it. The faults are in
// planted_faults.jsonl. plant_faults.py writes them into copies of the sources. The sources themselves, and
// so the program `daylight`, have no fault.
#pragma once

#include <span>

namespace cyl {

struct PlantedFault {
  int law;           ///< the number of a law that it breaks
  const char* file;  ///< that holds it
  const char* what;  ///< the fault in words
};

/// All faults. Number n, from 1, is the n-th.
std::span<const PlantedFault> planted_faults();

/// The number of the fault that is present from here on. 0: none.
extern int planted_fault;

[[gnu::always_inline]] inline bool is_planted(int number) noexcept {
  // Without the hint gcc 12 fails with an internal error if many of these select between masks of lanes.
  return __builtin_expect(planted_fault == number, 0);
}

}  // namespace cyl
