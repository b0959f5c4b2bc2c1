// SPDX-License-Identifier: MIT
// Findings put together by their cause, with all that a reader needs to see of each cause.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/json.hpp"
#include "corpus/store/run_store.hpp"
#include "corpus/store/suppressions.hpp"
#include "corpus/store/triage_store.hpp"
#include "oracles/methods/method.hpp"

namespace cyl {

/// All that is known of a run's findings.
struct Sorted {
  std::string folder;                   ///< of the run
  std::vector<FindingRecord> findings;  ///< by id
  std::vector<GroupRecord> groups;
  std::vector<CauseRecord> causes;    ///< by finding; findings without one are left out of the buckets
  std::vector<SimpleRecord> simples;  ///< by finding
  std::vector<WorstRecord> worsts;    ///< by bucket
};

/// Whether x is the worse of two findings: a refuted verdict before all else, then the larger proved margin.
bool is_worse(const FindingRecord& x, const FindingRecord& y);

/// How many findings a bucket stands for. Those that are not kept are counted by group (method, kind,
/// severity, family) only: a group's are given to buckets as its kept ones are, the rest of a division to the
/// larger parts first.
std::map<std::string, std::uint64_t> count_by_bucket(const Sorted& sorted);

/// An array of objects in the form of the page's Bucket, those beyond claims first, then by count; standing,
/// first and last seen not yet set. The worst is that of the findings, or what was searched for where it is
/// wrong today, in the same way and by a larger margin. Asks every method about the simplest and the worst
/// pair of each bucket, and the bucket's own about a sample of the stratum.
nlohmann::json make_buckets(const Sorted& sorted, std::span<const std::unique_ptr<Method>> methods);

/// Sets standing, first_seen and last_seen of the buckets of run `id`, and adds what is gone, by what earlier
/// triaged runs had, the earliest first. `asked`: the methods of the run, without which nothing is gone.
void hold_against(nlohmann::json& buckets, const std::string& id, const std::vector<std::string>& asked,
                  const std::vector<nlohmann::json>& earlier);

/// Marks what is suppressed.
void suppress(nlohmann::json& buckets, const std::vector<Suppression>& suppressions, std::string_view today);

/// Pairs drawn to see which share of a stratum fails.
inline constexpr std::uint64_t share_sample = 64;

}  // namespace cyl
