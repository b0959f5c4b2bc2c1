// SPDX-License-Identifier: MIT
// Which part of the harness catches which mutant, and how fast. A mutant is run in a child of its own; so one
// that crashes or hangs is caught by that.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/enum_words.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "props/mutants/mutants.hpp"

namespace cyl {

/// The evidence that a detector found in the mutated program.
struct Evidence {
  std::string failure_message;  ///< one line; empty if the fault was not detected
  /// The index in the family, if a method was wrong on a pair of a campaign.
  std::optional<std::uint64_t> family_index;

  Evidence(std::string message = {}, std::optional<std::uint64_t> index = {})
      : failure_message(std::move(message)), family_index(index) {}
};

struct Detector {
  std::string name;
  /// Called in a child, which it may crash, hang or replace. A replaced child reports by its exit code: 0
  /// means survived.
  std::function<Evidence(const Mutant&)> detect;
};

/// Time limit of one detector for one mutant, many times the longest run without a detection.
inline constexpr unsigned detector_cpu_cap = 120;   ///< seconds of CPU
inline constexpr unsigned detector_wall_cap = 600;  ///< seconds, for what waits without working

struct Detection {
  enum class Outcome : unsigned char {
    not_run,
    survived,
    killed,   ///< by a detector's word
    crashed,  ///< by a signal
    hung      ///< at a cap above
  };
  Outcome outcome = Outcome::not_run;
  double seconds = 0;  ///< wall time to the kill, or to the end
  Evidence evidence = {};
};
constexpr auto words_of(Detection::Outcome) noexcept {
  return std::array{"-", "survived", "killed", "crashed", "hung"};
}

struct KillRow {
  Mutant mutant;                      ///< number 0: the program as it is, which nothing may kill
  std::vector<Detection> detections;  ///< one for each detector
  bool killed() const;
};

/// Asks every detector, each in a child that has called select(mutant.number). Throws std::system_error if
/// the system refuses a process.
KillRow run_detectors(const Mutant& mutant, std::span<const Detector> detectors,
                      void (*select)(int) noexcept);

/// Returns three detectors. Only violations of a claim (Severity::contract) count. `cases` must outlive them.
/// * laws: every law on the cases and on pairs of the families.
/// * corpus: laws 30 and up on the cases, and their stated truths.
/// * differential: laws 30 and up on pairs of all families, near touching ones too.
std::vector<Detector> law_detectors(std::span<const Case> cases);

}  // namespace cyl
