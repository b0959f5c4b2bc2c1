// SPDX-License-Identifier: MIT
// A campaign checks itself. While it runs, it plants faults in a copy of the program, one after the
// other, and runs that copy on its own pairs. The faults are those that the kill matrix finds within
// 1,000 pairs. If one is not found within self_check_pairs_cap, the self-check fails. A finding of a
// planted fault is not a finding of the run. Findings and counts are the same with and without
// self-checks.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/process/child.hpp"
#include "fuzz/campaign/batch.hpp"

namespace cyl {

/// A fault that campaigns find.
struct KnownFault {
  int number = 0;          ///< of the mutant
  std::string what, asks;  ///< in words; names of the methods that may betray it, as select_methods() takes
};

/// Pairs after which the search for a fault ends, some seconds of work. It is ten times as many as the kill
/// matrix examines, and a hundred times as many as the slowest of faults_soon_found() took there.
inline constexpr std::uint64_t self_check_pairs_cap = 1 << 17;
/// CPU time of one planted fault, several times what those pairs take: beyond it the program hangs.
inline constexpr std::chrono::seconds self_check_cpu_cap{60};
/// Returns the index of a run, counted from its first drawn pair, at which its k-th fault (from 0) is
/// planted. The index is drawn from [2^k, 2^(k + 1)) self_check_octave. So a short run has some faults, a
/// long one few more, and the longer run has all those of the shorter.
inline constexpr std::uint64_t self_check_octave = 512;
std::uint64_t self_check_start(std::uint64_t seed, unsigned k);

/// Does the planted program's part: asks and judges the pairs [first, first + cap) until a method is wrong
/// beyond its claim. That finding, if any, is all that the record holds.
BatchRecord run_until_found(const Workload& workload, std::uint64_t seed, std::uint64_t first,
                            std::uint64_t cap);

struct SelfCheckOptions {
  std::string program;             ///< daylight-mutants; if empty, no self-checks
  std::vector<KnownFault> faults;  ///< to draw from, each once at most
};

/// The self-checks of a run under way, in processes of their own, one at a time.
class SelfChecks {
 public:
  /// Options, workload and store must outlive it.
  SelfChecks(const SelfCheckOptions& options, const Workload& workload, std::uint64_t seed, RunStore& store);
  /// Stores ended checks, and starts the due ones if the run has done all below `next`. Returns whether no
  /// due check remains. Does not wait.
  bool advance(std::uint64_t next);

 private:
  void store_what_ended();
  BatchRecord take() const;
  void launch();

  const SelfCheckOptions& options_;
  const Workload& workload_;
  const std::uint64_t seed_;
  RunStore& store_;
  std::vector<KnownFault> order_;  ///< as they are drawn
  unsigned next_ = 0;              ///< the first that is not done
  SelfCheckRecord at_;             ///< that of process_
  std::optional<Child> process_;
  bool over_cap_ = false;
};

}  // namespace cyl
