// SPDX-License-Identifier: MIT
// The alarm of the night. While a campaign runs, faults are planted in a copy of the program, one after the
// other, and that copy is led through the campaign's own pairs. One that is not found within its usual number
// of pairs shows that the harness sleeps, whatever else was found or not. What a planted fault betrays is no
// finding of the run, whose findings, counts and their order are the same with alarms and without.
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

/// From the rows of a kill matrix: the faults that the detector `fuzz` soon finds beyond the claim of a
/// method. Only those of which every method that may betray them is among `methods`. Throws
/// std::runtime_error where the file cannot be read.
std::vector<KnownFault> known_faults(const std::string& kill_matrix,
                                     std::span<const std::unique_ptr<Method>> methods);

/// Pairs after which a fault that was not found is given up: ten times as many as the kill matrix looks at,
/// some seconds of work, and a hundred times as many as the slowest of known_faults() took there.
inline constexpr std::uint64_t alarm_pairs_cap = 1 << 17;
/// CPU time of one planted fault, several times what those pairs take: beyond it the program hangs.
inline constexpr std::chrono::seconds alarm_cpu_cap{60};
/// Chance that a fault which is found as ever rings all the same. A night of eight hours plants some twenty:
/// of five hundred nights one rings for nothing.
inline constexpr double false_alarm_cap = 1e-4;

/// The index of a run, counted from its first drawn pair, at which its k-th fault (from 0) is planted: drawn
/// from [2^k, 2^(k + 1)) batch_size. So a short run has some, a long one few more, and the longer has those
/// of the shorter.
std::uint64_t alarm_moment(std::uint64_t seed, unsigned k);

/// What earlier runs tell of a fault.
struct PastAlarms {
  std::uint64_t found = 0;  ///< how often it was
  std::uint64_t most = 0;   ///< pairs that it took
};
/// Pairs within which a fault is usually found: as many as it ever took, times a factor that makes a false
/// alarm rarer than false_alarm_cap: 140 after two nights, 14 after five, 7 after ten. alarm_pairs_cap is
/// above all. What is below a `round` of the families' turns, the luck of the start decides.
std::uint64_t usual_pairs(const PastAlarms& past, std::uint64_t round);

/// The worker's part: asks and judges the pairs [first, first + cap) until a method is wrong beyond its
/// claim. That finding, if any, is all that the record holds.
BatchRecord run_until_found(const Subjects& subjects, std::uint64_t seed, std::uint64_t first,
                            std::uint64_t cap);

struct AlarmOptions {
  std::string program;             ///< daylight-mutants; empty: no alarms
  std::vector<KnownFault> faults;  ///< to draw from, each once at most
};

/// The alarms of a run under way, in processes of their own, one at a time.
class Alarms {
 public:
  /// Earlier runs are those beside `run_folder` of the same families and weights that began before it, shards
  /// apart. All three must outlive it.
  Alarms(const AlarmOptions& options, const Subjects& subjects, std::uint64_t seed, RunStore& store,
         const std::string& run_folder);
  /// Stores what has ended, starts what is due where the run has done all below `next`. Whether nothing that
  /// is due remains. Does not wait.
  bool advance(std::uint64_t next);

 private:
  void store_what_ended();
  void launch();

  const AlarmOptions& options_;
  const Subjects& subjects_;
  const std::uint64_t seed_;
  RunStore& store_;
  const std::string run_folder_;
  std::vector<KnownFault> order_;  ///< as they are drawn
  unsigned next_ = 0;              ///< the first that is not done
  AlarmRecord at_;                 ///< that of flight_
  std::optional<BatchProcess> flight_;
};

/// Whether it shows that the harness sleeps.
bool rings(const AlarmRecord& alarm);
/// Each that rings, in words; empty where none does.
std::string describe_rings(std::span<const AlarmRecord> alarms);
/// "alarm: 7 planted faults found, each within its usual time", or which were not; empty where none was
/// planted.
std::string format_alarms(std::span<const AlarmRecord> alarms);

}  // namespace cyl
