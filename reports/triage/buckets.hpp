// SPDX-License-Identifier: MIT
// Findings put together by their cause, with all that a reader needs to see of each cause.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "base/enum_words.hpp"
#include "base/json.hpp"
#include "corpus/store/run_store.hpp"
#include "corpus/store/suppressions.hpp"
#include "corpus/store/triage_store.hpp"
#include "oracles/methods/method.hpp"
#include "oracles/trial/compare.hpp"
#include "oracles/trial/mechanism.hpp"
#include "reports/triage/recurrence.hpp"

namespace cyl {

/// A cause: findings of which it is the same, and what is shown of them.
struct Bucket {
  /// How often a method fails in the same way on pairs drawn from the stratum.
  struct Share {
    std::uint64_t wrong = 0, asked = 0;
  };

  std::string key;
  std::string method, kind;  ///< of the finding that the simplest pair comes from
  std::set<std::string> methods, families;
  Severity severity = Severity::resolution;  ///< the gravest
  std::uint64_t count = 0;                   ///< findings, kept or not
  std::vector<std::int64_t> findings;        ///< ids of those that are kept
  std::optional<Enclosure> margin;           ///< from the least to the greatest proved one
  std::vector<std::string> merged;           ///< keys of the simplified pairs
  nlohmann::json simplest, worst;            ///< in the form of the page's Case
  bool worst_was_searched = false;           ///< it is no finding
  std::string feature, coordinate;           ///< of the simplest pair, in words
  Mechanism mechanism = Mechanism::unclassified;
  std::string cause;                ///< in words
  std::vector<std::string> labels;  ///< likewise, this and what else may be said
  std::optional<Share> share;
  std::optional<Recurrence> status;  ///< nothing where there is no earlier run
  std::string first_seen, last_seen;
  std::optional<Suppression> suppressed;
};

/// In the form of the page's Bucket, in which it is stored too.
nlohmann::json to_json(const Bucket& bucket);
nlohmann::json to_json(const std::vector<Bucket>& buckets);
/// Reads what to_json() wrote, but for the suppression. Throws nlohmann::json::exception where it is not
/// that.
Bucket bucket_from_json(const nlohmann::json& stored);

/// All that is known of a run's findings.
struct TriageRecords {
  std::string folder;                   ///< of the run
  std::vector<FindingRecord> findings;  ///< by id
  std::vector<GroupRecord> groups;
  std::vector<CauseRecord> causes;    ///< by finding; findings without one are left out of the buckets
  std::vector<SimpleRecord> simples;  ///< by finding
  std::vector<WorstRecord> worsts;    ///< by bucket
};

/// Whether x is the worse of two findings: a refuted verdict before all else, then the larger proved margin.
bool is_worse(const FindingRecord& x, const FindingRecord& y);
/// The proved margin of a finding; -1 where there is none.
double least_margin(const FindingRecord& finding);

/// Returns how many findings a bucket stands for. Those that are not kept are counted by group (method, kind,
/// severity, family) only: a group's are given to buckets as its kept ones are, the rest of a division to the
/// larger parts first.
std::map<std::string, std::uint64_t> count_by_bucket(const TriageRecords& records);

/// Makes the buckets, those beyond claims first, then by count; status, first and last seen not yet set. The
/// worst is that of the findings, or what was searched for where it is wrong today, in the same way and by a
/// larger margin. Asks every method about the simplest and the worst pair of each bucket, and the bucket's
/// own about a sample of the stratum.
std::vector<Bucket> make_buckets(const TriageRecords& records,
                                 std::span<const std::unique_ptr<Method>> methods);

/// Sets status, first_seen and last_seen of the buckets of run `id`, and adds what is gone, by what earlier
/// triaged runs had, the earliest first. `asked`: the methods of the run, without which nothing is gone.
void compare_with_earlier(std::vector<Bucket>& buckets, const std::string& id,
                          const std::vector<std::string>& asked,
                          const std::vector<std::vector<Bucket>>& earlier);

/// Marks what is suppressed.
void suppress(std::vector<Bucket>& buckets, const std::vector<Suppression>& suppressions,
              std::string_view today);

/// A line a bucket: findings, margins, what is wrong and the simplest pair.
std::string format_buckets(const std::vector<Bucket>& buckets);

/// Pairs drawn to see which share of a stratum fails.
inline constexpr std::uint64_t share_sample = 64;

}  // namespace cyl
