// SPDX-License-Identifier: MIT
// Which of a run's findings are kept with their pair, and how many there were.
#pragma once

#include <map>
#include <vector>

#include "corpus/store/run_store.hpp"

namespace cyl {

/// Which findings are kept. filter(filter(S1) + filter(S2)) == filter(S1 + S2): shards keep what one run
/// keeps.
class Representatives {
 public:
  /// Counts the finding; whether it is to be kept.
  bool admit(const FindingRecord& finding);
  /// Adds findings that were counted elsewhere.
  void add(const GroupRecord& group);
  std::vector<GroupRecord> groups() const;

 private:
  std::map<FindingGroup, GroupRecord> groups_;
};

}  // namespace cyl
