// SPDX-License-Identifier: MIT
// Stores the findings of a fuzz target, so that the process can continue: one finding a bucket, one undecided
// pair a stratum.
//
//   DAYLIGHT_FUZZ_OUT=FOLDER   findings.jsonl (a line of a case file each), findings/ and undecided/
//                              (records, inputs of the target, named by their letters), visited
//                              (visited.hpp); processes may share it
//   DAYLIGHT_FUZZ_ABORT=1      prints "DEDUP_TOKEN: letters" and aborts at the first finding, for services
//                              that run targets (also by the macro of that name)
// Without a folder, the first finding of each bucket is printed, and undecided pairs are skipped.
#pragma once

#include <set>
#include <string>
#include <string_view>

#include "fuzz/guided/counters.hpp"
#include "solver/cylinder.hpp"

namespace cyl {

class FindingSink {
 public:
  /// Reads the environment. `target` is the source of its findings.
  explicit FindingSink(std::string_view target);
  /// Keeps a finding if it is the first of its bucket.
  void add_finding(const Pair& pair, std::string_view method, std::string_view failure,
                   std::string_view what);
  /// Stores a pair that is undecided within the target's time, if it is the first of its stratum.
  void add_undecided(const Pair& pair, const Stratum& stratum);
  std::size_t findings() const { return findings_; }

 private:
  bool keep_first(const std::string& name, const Pair& pair);

  std::string target_, out_;
  bool abort_;
  std::set<std::string> known_;  // "findings/abcdefghijkl"
  std::size_t findings_ = 0;
};

}  // namespace cyl
