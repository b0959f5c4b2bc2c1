// SPDX-License-Identifier: MIT
#include "corpus/store/representatives.hpp"

#include <algorithm>
#include <cmath>

namespace cyl {

// The first rule keeps by place in the group, the second by the running maximum of the binade. In a piece
// both are smaller than in the whole, so it admits a superset. Every finding that raised the whole's maximum
// is in that. This holds for stretches, and for shards, whose pieces lie between each other. Let S be a
// group's findings in index order, S_i those of shard i, and U the union of all that the shards keep. A
// finding among the first ten of S is among the first ten of its S_i. A finding that exceeds all before it in
// S exceeds those before it in S_i. So U holds both. U is part of S and holds the first ten of S, so these
// are the first ten of U. U holds every finding that raised the maximum of S, so the maximum before any place
// is the same in U and in S. So U, filtered in index order, keeps the same findings as S.
bool Representatives::admit(const FindingRecord& f) {
  GroupRecord& group = groups_.try_emplace(f, GroupRecord{f}).first->second;
  const double margin = f.margin ? f.margin->lo : 0;
  const int binade =
      margin > 0 ? std::min(std::ilogb(margin), -(GroupRecord::no_binade + 1)) : GroupRecord::no_binade;
  const bool worse = binade > group.binade;
  if (worse) group.binade = binade;
  return ++group.count <= representatives_cap || worse;
}

void Representatives::add(const GroupRecord& g) {
  const FindingGroup& key = g;  // without the counts
  GroupRecord& group = groups_.try_emplace(key, GroupRecord{key}).first->second;
  group.count += g.count;
  group.binade = std::max(group.binade, g.binade);
}

std::vector<GroupRecord> Representatives::groups() const {
  std::vector<GroupRecord> all;
  for (const auto& [key, group] : groups_) all.push_back(group);
  return all;
}

}  // namespace cyl
