// SPDX-License-Identifier: MIT
// A campaign checks itself. While it runs, faults are planted in a copy of the program, one after the other,
// and that copy is led through the campaign's own pairs. One that is not found within its usual number of
// pairs shows that the harness finds nothing, whatever else was found or not: the self-check fails. What a
// planted fault shows is no finding of the run, whose findings, counts and their order are the same with
// self-checks and without.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fuzz/campaign/batch.hpp"
#include "fuzz/campaign/batch_process.hpp"

namespace cyl {

/// A fault that campaigns find.
struct KnownFault {
  int number = 0;          ///< of the mutant
  std::string what, asks;  ///< in words; names of the methods that may betray it, as select_methods() takes
};

/// Pairs after which a fault that was not found is given up: ten times as many as the kill matrix looks at,
/// some seconds of work, and a hundred times as many as the slowest of faults_soon_found() took there.
inline constexpr std::uint64_t self_check_pairs_cap = 1 << 17;
/// CPU time of one planted fault, several times what those pairs take: beyond it the program hangs.
inline constexpr std::chrono::seconds self_check_cpu_cap{60};
/// Chance that the self-check fails though its fault is found as ever. A campaign of eight hours plants some
/// twenty: one in five hundred fails for nothing.
inline constexpr double false_alarm_cap = 1e-4;

/// Returns the index of a run, counted from its first drawn pair, at which its k-th fault (from 0) is
/// planted: drawn from [2^k, 2^(k + 1)) batch_size. So a short run has some, a long one few more, and the
/// longer has those of the shorter.
std::uint64_t self_check_start(std::uint64_t seed, unsigned k);

/// How earlier runs fared with a fault.
struct PastSelfChecks {
  std::uint64_t found = 0;  ///< how often it was
  std::uint64_t most = 0;   ///< pairs that it took
};
/// Returns the pairs within which a fault is usually found: as many as it ever took, times a factor that
/// makes a false alarm rarer than false_alarm_cap: 140 after two campaigns, 14 after five, 7 after ten.
/// self_check_pairs_cap is above all. What is below a `round` of the families' turns, the luck of the start
/// decides.
std::uint64_t usual_pairs(const PastSelfChecks& past, std::uint64_t round);

/// Does the planted program's part: asks and judges the pairs [first, first + cap) until a method is wrong
/// beyond its claim. That finding, if any, is all that the record holds.
BatchRecord run_until_found(const Workload& workload, std::uint64_t seed, std::uint64_t first,
                            std::uint64_t cap);

struct SelfCheckOptions {
  std::string program;             ///< daylight-mutants; empty: no self-checks
  std::vector<KnownFault> faults;  ///< to draw from, each once at most
};

/// The self-checks of a run under way, in processes of their own, one at a time.
class SelfChecks {
 public:
  /// Earlier runs are those beside `run_folder` of the same families and weights that began before it, shards
  /// apart. All three must outlive it.
  SelfChecks(const SelfCheckOptions& options, const Workload& workload, std::uint64_t seed, RunStore& store,
             const std::string& run_folder);
  /// Stores what has ended, starts what is due where the run has done all below `next`. Whether nothing that
  /// is due remains. Does not wait.
  bool advance(std::uint64_t next);

 private:
  void store_what_ended();
  void launch();

  const SelfCheckOptions& options_;
  const Workload& workload_;
  const std::uint64_t seed_;
  RunStore& store_;
  const std::string run_folder_;
  std::vector<KnownFault> order_;  ///< as they are drawn
  unsigned next_ = 0;              ///< the first that is not done
  SelfCheckRecord at_;             ///< that of process_
  std::optional<BatchProcess> process_;
};

/// Returns whether the harness did not find the fault within the usual pairs.
bool fails(const SelfCheckRecord& check);
/// Returns each that fails, in words; nothing where none does.
std::string describe_failed_checks(std::span<const SelfCheckRecord> checks);
/// Returns "alarm: 7 planted faults found, each within its usual time", or which were not; empty where none
/// was planted.
std::string format_self_checks(std::span<const SelfCheckRecord> checks);

}  // namespace cyl
