// SPDX-License-Identifier: MIT
// What a run found, held against the earlier runs beside it: those in the same folder that began before it.
// Shards are passed over, and have no history of their own: the run they are merged to has.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "base/enum_words.hpp"
#include "corpus/store/run_store.hpp"

namespace cyl {

struct RunData;

/// What has become of a group of findings since earlier runs. Only those that asked its method about its
/// family tell; the last of them decides between `known` and `back`, and on `gone`.
enum class GroupStatus {
  fresh,  ///< found here, in no earlier run; told as "new"
  known,  ///< found here and in the last
  back,   ///< found here and in an earlier run, not in the last
  gone,   ///< not found here though asked, but in the last
};
constexpr auto words_of(GroupStatus) noexcept { return std::array{"new", "known", "back", "gone"}; }

struct History {
  std::size_t runs = 0;        ///< earlier ones
  std::size_t unreadable = 0;  ///< stores that cannot be read, and are passed over
  std::vector<std::pair<GroupRecord, GroupStatus>> groups;  ///< by status, then by group

  std::size_t count(GroupStatus status) const;
};

/// Compares the groups of a run with those of earlier runs; what `run.history` holds is not looked at.
History compare_with_earlier(const RunData& run);

/// "against 5 earlier runs: 2 new, 31 known, 1 gone, 0 back"
std::string format_history(const History& history);

}  // namespace cyl
