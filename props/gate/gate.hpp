// SPDX-License-Identifier: MIT
// The merge gate. It replays every known case, checks every law, and compares the method with
// the referee on samples of every stratum and class of close contact. It reports how much
// that proves. The same seed and number of pairs give the same failures in the same order on
// any machine, except for hangs. If the time limit stops the gate early, the report lists
// the part that was not tested.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>

#include "corpus/store/case_files.hpp"
#include "oracles/methods/method.hpp"
#include "props/gate/gate_report.hpp"
#include "props/gate/sample.hpp"

namespace cyl {

/// The default number of pairs. Our own methods then take about 40 s on two cores, which is how long people
/// wait for a merge. Each stratum gets 2,336 pairs, which bounds its error rate by 1.3e-3. Each cell of close
/// contacts gets at least 681 pairs, half of them gaps.
inline constexpr std::uint64_t gate_pairs = 500'000;

/// After four hangs, or three crashes of a program, the rest of a batch is skipped.
inline constexpr Caps gate_caps{.call_wall = 4 * call_cpu_cap, .hangs = 4, .program_crashes = 3};

struct GateOptions {
  std::uint64_t seed = 1;
  std::uint64_t pairs = gate_pairs;  ///< to be drawn; all cases are run besides them
  /// The amount of an earlier gate instead, so that both use the same pairs.
  std::optional<GateAmount> amount = {};
  std::optional<std::chrono::milliseconds> cap = {};  ///< wall time, after which nothing more is asked
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();  ///< the start of `cap`
  /// Asked again and again. Once it returns true, the gate asks no further questions and reports.
  std::function<bool()> stopped = [] { return false; };
  bool as_found = false;  ///< the gate neither reruns nor simplifies failures at its end
  Caps caps = gate_caps;  ///< the numbers of hangs and crashes are those in one batch
};

struct GateProgress {
  GatePhase phase;
  std::uint64_t pairs = 0;
  std::size_t failures = 0;  ///< beyond claims
  double share = 0;          ///< the part of this phase that is done
};

/// Returns whether the gate was stopped or the cap on time, if there is one, is over.
bool out_of_time(const GateOptions& options);
/// Returns the reason why pairs were not tested, such as "since the time was over".
const char* why_not(const GateOptions& options);

/// Runs the gate on methods. The pairs depend on the seed and the counts alone, unless the time limit stops
/// the gate. Throws std::system_error if the system refuses a process or memory.
GateReport run_gate(std::span<const std::unique_ptr<Method>> methods, std::span<const Case> cases,
                    const GateOptions& options,
                    const std::function<void(const GateProgress&)>& on_progress = {});

}  // namespace cyl
