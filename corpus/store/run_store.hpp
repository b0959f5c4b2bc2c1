// SPDX-License-Identifier: MIT
// The progress and findings of a run, in one SQLite file of plain records. A batch is committed whole or not
// at all. So a run that is killed at any moment leaves an exact prefix of its results.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "corpus/pairs/certificate.hpp"
#include "corpus/pairs/finding.hpp"
#include "corpus/store/cell_counts.hpp"

namespace cyl {

class SqliteFile;

/// How many findings of one (method, kind, severity, family) are kept with their pair: the first ones in
/// index order. A later one is kept only if its margin passes one more power of two. So the largest margin is
/// known to within a factor of two. The other findings are only counted. This bounds the file, and ten are
/// enough to see a pattern.
inline constexpr std::uint64_t representatives_cap = 10;

/// How often a method was asked on a family, with the outcomes.
struct Counts {
  std::uint64_t asked = 0;
  std::uint64_t declined = 0;
  std::uint64_t failed = 0;      ///< exception, crash, hang, non-finite number
  std::uint64_t contract = 0;    ///< wrong beyond its own claim
  std::uint64_t resolution = 0;  ///< wrong within its own claim
  std::uint64_t undecided = 0;
  std::uint64_t nanoseconds = 0;       ///< time of the calls; CPU time for foreign code
  std::uint64_t hung_nanoseconds = 0;  ///< CPU time of the calls that hung, which is not in `nanoseconds`

  Counts& operator+=(const Counts& other);
  static auto columns(auto& c) {
    return std::tie(c.asked, c.declined, c.failed, c.contract, c.resolution, c.undecided, c.nanoseconds,
                    c.hung_nanoseconds);
  }
};

/// A method that was asked. It claims to be right if |distance| >= relative * size + absolute.
struct MethodRecord {
  std::string name, version;
  double relative = 0, absolute = 0;
  std::string source;  ///< of the claim
  unsigned share = 1;  ///< asked on one index in `share`, and if another method is wrong
  std::string library = {};
  bool assumed = false;  ///< The library states no such claim.

  bool operator==(const MethodRecord&) const = default;
  static constexpr const char* table = "method";
  static auto columns(auto& m) {
    return std::tie(m.name, m.version, m.relative, m.absolute, m.source, m.share, m.library, m.assumed);
  }
};

struct TallyRecord {
  std::string method, family;
  Counts counts;

  static constexpr const char* table = "tally";
  static auto columns(auto& t) { return std::tie(t.method, t.family, t.counts); }
};

/// The findings that are counted together have these properties in common.
struct FindingGroup {
  std::string method;
  FindingKind kind = FindingKind::wrong_disjoint;
  Severity severity = Severity::contract;
  std::string family;

  auto operator<=>(const FindingGroup&) const = default;
};

/// One thing that is wrong, with all that is needed to see it again.
struct FindingRecord : FindingGroup {
  std::int64_t id = 0;      ///< 1, 2, ... in the order they were found; given by the store
  std::uint64_t index = 0;  ///< of the pair in the run
  std::uint64_t family_index = 0;
  std::optional<Enclosure> margin;  ///< stored as text, infinite allowed
  // The next three fields are stored once for each pair.
  std::string pair;     ///< one JSON line of corpus/pair_io
  std::string answers;  ///< JSON array of [answer, [name of a method that gave it, ..]], each answer once
  std::string truth;    ///< JSON object: verdict and certificate
  std::string reason;   ///< the method's own words on a failure

  static constexpr const char* table = "finding";
  static auto columns(auto& f) {
    return std::tie(f.id, f.index, f.family, f.family_index, f.method, f.kind, f.severity, f.margin, f.pair,
                    f.answers, f.truth, f.reason);
  }
};

/// How many findings of a group there were, kept or not.
struct GroupRecord : FindingGroup {
  std::uint64_t count = 0;
  int binade = no_binade;  ///< the greatest power of two that a margin's lower bound reached

  static constexpr int no_binade = -100000;  ///< below every exponent of a double
  static constexpr const char* table = "finding_group";
  static auto columns(auto& g) { return std::tie(g.method, g.kind, g.severity, g.family, g.count, g.binade); }
};

/// The result of a range of indices [first, next). For a shard, its own part of the range.
struct BatchRecord {
  std::uint64_t first = 0, next = 0;
  std::vector<TallyRecord> tallies;
  std::vector<GroupRecord> groups;      ///< all findings of the batch, counted
  std::vector<FindingRecord> findings;  ///< kept by Representatives, in index order; id unset
  std::vector<CellRecord> cells;        ///< of the failure maps
};

struct Progress {
  std::uint64_t next = 0;          ///< the first index not done
  std::uint64_t milliseconds = 0;  ///< wall time the run has taken, over all its sessions

  static auto columns(auto& p) { return std::tie(p.next, p.milliseconds); }
};

using Config = std::map<std::string, std::string>;

/// The store of one run: FOLDER/run.sqlite. It has a write-ahead log with synchronous=NORMAL, so committed
/// data survives the death of the process. A loss of power may lose the last batches, but not the
/// consistency. Every call throws a std::runtime_error that names the file if it cannot be read or written;
/// it is an InputError if the file is not a valid run.
class RunStore {
 public:
  /// Creates folder and file. Throws if a run exists there.
  static RunStore create(const std::string& folder, const Config& config,
                         const std::vector<MethodRecord>& methods = {});
  /// Throws UsageError if there is no run, and InputError if its findings contradict its counts.
  static RunStore open(const std::string& folder);
  RunStore(RunStore&&) noexcept;
  ~RunStore();

  Config config() const;
  void set(const std::string& key, const std::string& value);  ///< an entry of the configuration
  std::vector<MethodRecord> methods() const;
  Progress progress() const;
  /// Adds a batch and the wall time since the last commit in one transaction. Throws if `batch.first` is not
  /// the next index, because then another process is writing to this run.
  void commit(const BatchRecord& batch, std::uint64_t milliseconds);

  std::vector<TallyRecord> tallies() const;     ///< by first appearance
  std::vector<GroupRecord> groups() const;      ///< by method, kind, severity and family
  std::vector<FindingRecord> findings() const;  ///< by id
  /// By plane, x and y.
  std::vector<CellRecord> cells() const;
  std::optional<FindingRecord> finding(std::int64_t id) const;

 private:
  explicit RunStore(std::unique_ptr<SqliteFile> file);
  std::unique_ptr<SqliteFile> file_;
};

bool holds_run(const std::string& folder);
/// The folders right inside `folder` that hold a run, by name; symbolic links are passed over.
std::vector<std::string> runs_in(const std::string& folder);

}  // namespace cyl
