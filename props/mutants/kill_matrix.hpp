// SPDX-License-Identifier: MIT
// Which part of the harness catches which mutant, and how fast. A mutant is run in a child of its own; so one
// that crashes or hangs is caught by that.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "base/enum_words.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "props/mutants/mutants.hpp"

namespace cyl {

/// What gives the program away, as the mutant has made it, in one line; empty: nothing does. Called in a
/// child, which it may crash, hang or replace (then the exit code says it: 0 survived).
struct Detector {
  std::string name;
  std::function<std::string(const Mutant&)> betrayal;
};

enum class Fate : unsigned char {
  not_run,
  survived,
  killed,   ///< by a detector's word
  crashed,  ///< by a signal
  hung      ///< at a cap below
};
constexpr auto words_of(Fate) noexcept { return std::array{"-", "survived", "killed", "crashed", "hung"}; }

/// Time one detector may spend on one mutant; many times what the longest takes where it finds nothing.
inline constexpr unsigned detector_cpu_cap = 120;   ///< seconds of CPU
inline constexpr unsigned detector_wall_cap = 600;  ///< seconds, for what waits without working

struct Detection {
  Fate fate = Fate::not_run;
  double seconds = 0;  ///< wall time to the kill, or to the end
  std::string what;    ///< gave it away, in one line; may be empty
};

struct KillRow {
  Mutant mutant;                      ///< number 0: the program as it is, which nothing may kill
  std::vector<Detection> detections;  ///< one for each detector
  bool killed() const;
};

/// Asks every detector, each in a child that has called select(mutant.number). Throws std::system_error only
/// where the system refuses a process.
KillRow run_detectors(const Mutant& mutant, std::span<const Detector> detectors,
                      void (*select)(int) noexcept);

/// laws: every law on the cases and on pairs of the families. corpus: laws 30 and on for the cases, and what
/// they state of the truth. differential: laws 30 and on for pairs of all families, near touching ones too.
/// Only what a method promises (Severity::contract) counts. `cases` must outlive them.
std::vector<Detector> law_detectors(std::span<const Case> cases);

}  // namespace cyl
