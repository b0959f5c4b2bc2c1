// SPDX-License-Identifier: MIT
// The results of triage, in one SQLite file of plain records beside that of the run. A triage that is
// killed continues from there. The size is bounded: two rows for each kept finding.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "base/safe_text.hpp"
#include "corpus/pairs/finding.hpp"
#include "oracles/trial/mechanism.hpp"

namespace cyl {

class SqliteFile;

/// The cause of a finding, as far as probes revealed it.
struct CauseRecord {
  std::int64_t finding = 0;  ///< its id in the run
  std::string cause;
  Mechanism mechanism = Mechanism::unclassified;
  Lines labels;  ///< others that apply

  static constexpr const char* table = "cause";
  static auto columns(auto& c) { return std::tie(c.finding, c.cause, c.mechanism, c.labels); }
};

/// A finding simplified.
struct SimpleRecord {
  std::int64_t finding = 0;
  std::string pair;    ///< one JSON line of corpus/pair_io
  bool ended = false;  ///< by itself: not to be simplified again

  static constexpr const char* table = "simple";
  static auto columns(auto& s) { return std::tie(s.finding, s.pair, s.ended); }
};

/// FOLDER/triage.sqlite. Several processes may write to it at once. Every call throws std::runtime_error that
/// names the file if it cannot be read or written.
class TriageStore {
 public:
  /// Creates the file if it does not exist. `asked`: the build and its methods except guests. Results of
  /// other methods are dropped, because causes depend on them.
  TriageStore(const std::string& folder, const std::string& asked);
  /// Sets the version of a guest. Causes that another version gave are dropped.
  void expect(const std::string& guest, const std::string& version, std::span<const std::int64_t> findings);
  TriageStore(TriageStore&&) noexcept;
  ~TriageStore();

  std::vector<CauseRecord> causes() const;    ///< by finding
  std::vector<SimpleRecord> simples() const;  ///< by finding
  void add(std::span<const CauseRecord> causes);
  void add(const SimpleRecord& simple);
  /// Sets the causes, as JSON. `part`: of the findings, looked at so far.
  void set_summary(const std::string& json, double part);

 private:
  std::unique_ptr<SqliteFile> file_;
};

/// Returns the causes that a triage of the run in `folder` left, as JSON; empty if there was none.
std::string stored_summary(const std::string& folder);
/// Returns the part of the findings that it had examined, or 1 if it is not recorded.
double stored_part(const std::string& folder);

}  // namespace cyl
