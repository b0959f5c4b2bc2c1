// SPDX-License-Identifier: MIT
// Findings put together by their cause, with all that a reader needs to see of each cause.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <tuple>
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
  /// What a run saw of the cause: findings of one method that were looked at, and of the pairs that it was
  /// asked in the families the part that this stands for.
  struct RunObservation {
    std::string run, started;
    Observation sight;
  };

  std::string key;
  std::string method, kind;  ///< of the finding that the simplest pair comes from
  std::set<std::string> methods, families;
  Severity severity = Severity::resolution;  ///< the gravest
  std::uint64_t count = 0;                   ///< findings, kept or not
  std::uint64_t pairs = 0;             ///< that one method of it is wrong on, at most: what may be compared
  std::vector<std::int64_t> findings;  ///< ids of those that are kept
  std::optional<Enclosure> margin;     ///< the least and the greatest lower bound
  std::vector<std::string> merged;     ///< keys of the simplified pairs
  nlohmann::json simplest, worst;      ///< in the form of the page's Case
  bool ordinary = true;                ///< the simplest is: is_ordinary()
  bool simplified = false;             ///< the simplest is; else it is as it was found
  bool seen_again = false;             ///< its method, asked alone, failed on the simplest
  bool worst_was_searched = false;     ///< it is no finding
  std::string feature, coordinate;     ///< of the simplest pair, in words
  Mechanism mechanism = Mechanism::unclassified;
  std::string cause;                ///< in words
  std::vector<std::string> labels;  ///< likewise, this and what else may be said
  std::optional<Share> share;
  std::optional<Recurrence> status;  ///< nothing where there is no earlier run
  std::optional<double> chance;      ///< that the status is due to chance, where that was asked
  std::string first_seen, last_seen;
  std::string first_version, last_version;  ///< of its method, then
  std::vector<RunObservation> history;      ///< the runs that looked for it, the earliest first
  std::optional<Suppression> suppressed;
};

/// The findings of one method, kind, severity and family: all, and those looked at, by cause.
struct ExaminedFindings {
  std::uint64_t found = 0, looked_at = 0;
  std::map<std::string, std::uint64_t> by_cause;
};
using ExaminedGroups =
    std::map<std::tuple<std::string, std::string, std::string, std::string>, ExaminedFindings>;

ExaminedGroups examined_groups(const std::vector<GroupRecord>& groups,
                               const std::vector<FindingHead>& findings,
                               const std::vector<CauseRecord>& causes);

/// What earlier triaged runs, and this one, tell of causes.
struct TriagedRun {
  std::string id, started;
  std::vector<MethodRecord> methods;  ///< those that are here
  std::vector<TallyRecord> tallies;
  std::vector<Bucket> buckets;
  ExaminedGroups examined;
  double part = 1;  ///< of its findings that were looked at
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
struct BucketCount {
  std::uint64_t findings = 0;
  std::map<std::string, std::uint64_t> by_method;

  std::uint64_t most() const;  ///< of a method: pairs, since it has one finding a pair
};
std::map<std::string, BucketCount> count_by_bucket(const TriageRecords& records);

/// Makes the buckets, those beyond claims first, then by count; status, first and last seen not yet set. The
/// worst is that of the findings, or what was searched for where it is wrong today, in the same way and by a
/// larger margin. The simplest is one on which its method, asked alone, fails today; where there is none, the
/// first that was found, with what was said then. Asks every method about the simplest and the worst pair of
/// each bucket, and the bucket's own about a sample of the stratum; once `out_of_time()`, the bucket's own
/// about the simplest alone.
std::vector<Bucket> make_buckets(const TriageRecords& records, const GroupedMethods& methods,
                                 const std::function<bool()>& out_of_time);

/// Says of an earlier run's bucket whether what it stored fails today as it did then: nothing where that
/// cannot be told.
using FailsToday = std::function<std::optional<bool>(const Bucket&)>;

/// Sets what the run's buckets are since `earlier` triaged runs, the earliest first: status, chance, nights,
/// first and last seen; and adds the last one's that the run does not have: known where a stored pair fails
/// today, gone where all are right. Who was not asked in the run loses nothing. New ones come first, then
/// what is back, then the others in their order; what is gone comes last.
void compare_with_earlier(TriagedRun& run, const std::vector<TriagedRun>& earlier,
                          const FailsToday& fails_today);

/// Marks what is suppressed, by its key.
void suppress(std::vector<Bucket>& buckets, const std::vector<Suppression>& suppressions,
              std::string_view today);
/// Returns "libccd-mpr.wrong_disjoint" of that key with '/': the name of the files of a bucket's pairs,
/// without ending. What a file's name should not hold is replaced, and told apart by letters.
std::string file_name_of(std::string_view key);

/// "1 new cause, 34 known, 1 gone", those that there are; "35 causes" where there is nothing to compare with.
std::string what_changed(const std::vector<Bucket>& buckets);

/// A line a bucket: findings, margins, what is wrong and the simplest pair.
std::string format_buckets(const std::vector<Bucket>& buckets);

/// Pairs drawn to see which share of a stratum fails.
inline constexpr std::uint64_t share_sample = 64;

}  // namespace cyl
