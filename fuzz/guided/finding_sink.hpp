// SPDX-License-Identifier: MIT
// Keeps pairs on which a method fails, so that the process can continue. A campaign then asks every method
// about them: what a target sees in microseconds is where to look, and no finding.
//
//   DAYLIGHT_FUZZ_OUT=FOLDER   findings/ and undecided/ (a record of each cause, and of each stratum),
//                              broken (a line for each failure that no campaign sees); processes may share
//                              it
//   DAYLIGHT_FUZZ_ABORT=1      aborts at the first failure
#pragma once

#include <set>
#include <string>
#include <string_view>

#include "fuzz/guided/counters.hpp"
#include "solver/solid.hpp"

namespace cyl {

class FindingSink {
 public:
  /// Reads the environment.
  FindingSink();
  /// Keeps a pair on which a method fails if it is the first of its cause. Prints it then, and returns the
  /// name of its record.
  std::string add_finding(const Pair& pair, std::string_view method, std::string_view failure,
                          std::string_view what);
  /// Keeps a pair on which a law is broken, or a proof contradicts another.
  void add_broken(const Pair& pair, std::string_view method, std::string_view law, std::string_view what);
  /// Keeps a pair that is undecided within the target's time, if it is the first of its stratum.
  void add_undecided(const Pair& pair, const Stratum& stratum);
  std::size_t findings() const { return findings_; }

 private:
  bool keep_first(const std::string& name, const Pair& pair);

  std::string out_;
  bool abort_;
  std::set<std::string> known_;  // "findings/abcdefghijkl"
  std::size_t findings_ = 0;
};

}  // namespace cyl
