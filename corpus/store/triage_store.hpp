// SPDX-License-Identifier: MIT
// What triage has found out of a run's findings, in one SQLite file beside the run's own, so that a triage
// that is killed goes on where it was. It knows plain records only. Bounded: two rows a finding
// that is kept, one a bucket.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <tuple>
#include <vector>

namespace cyl {

class SqliteFile;

/// Why a finding is wrong, as far as probes told.
struct CauseRecord {
  std::int64_t finding = 0;  ///< its id in the run
  std::string bucket;
  std::string mechanism;  ///< its word
  std::string labels;     ///< others that apply, one a line

  static constexpr const char* table = "cause";
  static auto columns(auto& c) { return std::tie(c.finding, c.bucket, c.mechanism, c.labels); }
};

/// A finding simplified.
struct SimpleRecord {
  std::int64_t finding = 0;
  std::string pair;  ///< one JSON line of corpus/pair_io
  std::string key;   ///< the bucket key of the pair: method, kind, feature, coordinate
  std::uint64_t questions = 0;
  bool ended = false;  ///< by itself: not to be simplified again

  static constexpr const char* table = "simple";
  static auto columns(auto& s) { return std::tie(s.finding, s.pair, s.key, s.questions, s.ended); }
};

/// What a search for a worse pair than a bucket's findings came to.
struct WorstRecord {
  std::string bucket;
  std::string method, kind;  ///< that is wrong on it, and in which way
  std::string pair;          ///< one JSON line of corpus/pair_io; empty: none worse was found
  bool ended = false;        ///< by itself: not to be searched again

  static constexpr const char* table = "worst";
  static auto columns(auto& w) { return std::tie(w.bucket, w.method, w.kind, w.pair, w.ended); }
};

/// FOLDER/triage.sqlite. May be written by several processes at once. Every call throws std::runtime_error
/// that names the file where it cannot be read or written.
class TriageStore {
 public:
  /// Creates the file where there is none. `asked`: the build, and whom it asks, guests apart. What was found
  /// out of others is dropped: causes are told by asking.
  TriageStore(const std::string& folder, const std::string& asked);
  /// The version of a guest. What another one told of these findings of it, and its buckets' worst, is
  /// dropped.
  void expect(const std::string& guest, const std::string& version, std::span<const std::int64_t> findings);
  TriageStore(TriageStore&&) noexcept;
  ~TriageStore();

  std::vector<CauseRecord> causes() const;    ///< by finding
  std::vector<SimpleRecord> simples() const;  ///< by finding
  std::vector<WorstRecord> worsts() const;    ///< by bucket
  void add(std::span<const CauseRecord> causes);
  void add(const SimpleRecord& simple);
  void add(const WorstRecord& worst);
  /// The buckets as JSON; empty: none yet.
  std::string buckets() const;
  /// `part`: of the findings, looked at so far.
  void set_buckets(const std::string& json, double part);

 private:
  std::unique_ptr<SqliteFile> file_;
};

/// The buckets that a triage of the run in `folder` left, as JSON; empty where there was none.
std::string stored_buckets(const std::string& folder);
/// The causes that it told.
std::vector<CauseRecord> stored_causes(const std::string& folder);
/// The part of the findings that it had looked at; 1 where it did not say.
double stored_part(const std::string& folder);

}  // namespace cyl
