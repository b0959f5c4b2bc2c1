// SPDX-License-Identifier: MIT
#include "corpus/store/run_store.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "base/json.hpp"
#include "base/usage_error.hpp"
#include "corpus/store/representatives.hpp"
#include "corpus/store/sqlite_file.hpp"

namespace cyl {
namespace {

/// The version of the tables below, in PRAGMA user_version. A file is refused if its tables differ in a
/// single character, so a change of any needs a new version.
constexpr int store_version = 4;

/// A judged pair takes 2 to 4 KB. SQLite's usual pages of 4096 bytes would be a third empty.
constexpr int page_bytes = 16384;

constexpr const char* tables = R"(
CREATE TABLE run(key TEXT PRIMARY KEY, value TEXT NOT NULL);
CREATE TABLE method(name TEXT PRIMARY KEY, version TEXT NOT NULL, relative TEXT NOT NULL, absolute TEXT NOT NULL,
  source TEXT NOT NULL, share INTEGER NOT NULL, library TEXT NOT NULL, assumed INTEGER NOT NULL);
CREATE TABLE progress(next INTEGER NOT NULL, milliseconds INTEGER NOT NULL);
CREATE TABLE tally(method TEXT NOT NULL, family TEXT NOT NULL, asked INTEGER NOT NULL, declined INTEGER NOT NULL,
  failed INTEGER NOT NULL, contract INTEGER NOT NULL, resolution INTEGER NOT NULL, undecided INTEGER NOT NULL,
  nanoseconds INTEGER NOT NULL, hung_nanoseconds INTEGER NOT NULL, PRIMARY KEY(method, family));
CREATE TABLE finding_group(method TEXT NOT NULL, kind TEXT NOT NULL, severity TEXT NOT NULL, family TEXT NOT NULL,
  count INTEGER NOT NULL, binade INTEGER NOT NULL, PRIMARY KEY(method, kind, severity, family));
CREATE TABLE judged_pair(pair_index INTEGER PRIMARY KEY, pair TEXT NOT NULL, answers TEXT NOT NULL,
  truth TEXT NOT NULL);
CREATE TABLE wrong_answer(id INTEGER PRIMARY KEY, pair_index INTEGER NOT NULL, family TEXT NOT NULL,
  family_index INTEGER NOT NULL, method TEXT NOT NULL, kind TEXT NOT NULL, severity TEXT NOT NULL,
  margin_lo TEXT, margin_hi TEXT, reason TEXT NOT NULL);
CREATE VIEW finding AS SELECT id, pair_index, family, family_index, method, kind, severity, margin_lo, margin_hi,
  pair, answers, truth, reason FROM wrong_answer JOIN judged_pair USING(pair_index);
CREATE TABLE cell(plane TEXT NOT NULL, x INTEGER NOT NULL, y INTEGER NOT NULL, methods TEXT NOT NULL,
  PRIMARY KEY(plane, x, y)) WITHOUT ROWID;
INSERT INTO progress VALUES(0, 0);
)";

std::string file_of(const std::string& folder) { return folder + "/run.sqlite"; }

struct ConfigEntry {
  std::string key;
  Lines value;

  static constexpr const char* table = "run";
  static auto columns(auto& e) { return std::tie(e.key, e.value); }
};

/// The most findings that a store keeps of one group: the first, and one for each power of two that a margin
/// can reach. Doubles have 2098 of them, and infinity counts as one more.
constexpr std::uint64_t kept_cap = representatives_cap + 2099;

/// The findings of a group, as its rows count them.
struct KeptCounts : FindingGroup {
  std::uint64_t stated = 0, kept = 0;
  std::uint64_t with_pair = 0;  ///< kept findings

  static auto columns(auto& k) {
    return std::tie(k.method, k.kind, k.severity, k.family, k.stated, k.kept, k.with_pair);
  }
};

constexpr const char* count_kept = R"(
SELECT method, kind, severity, family, sum(stated), sum(kept), sum(with_pair) FROM (
  SELECT method, kind, severity, family, count AS stated, 0 AS kept, 0 AS with_pair FROM finding_group
  UNION ALL SELECT method, kind, severity, family, 0, 1, judged_pair.pair_index IS NOT NULL
    FROM wrong_answer LEFT JOIN judged_pair USING(pair_index))
GROUP BY method, kind, severity, family)";

/// Throws InputError unless each group keeps as many findings as it states, each with its pair.
void check_counts(const SqliteFile& file) {
  for (const KeptCounts& k : file.rows<KeptCounts>(count_kept)) {
    const bool enough = k.kept >= std::min(k.stated, representatives_cap);
    if (enough && k.kept <= std::min(k.stated, kept_cap) && k.with_pair == k.kept) continue;
    throw InputError(
        fmt::format("{}: it counts {} findings of {} ({}, {}, {}), has rows of {}, and pairs of {}: it is "
                    "damaged or forged",
                    file.name(), k.stated, k.method, to_string(k.kind), in_words(k.severity), k.family,
                    k.kept, k.with_pair));
  }
}

/// Refuses JSON that is_too_deep().
std::vector<FindingRecord> without_deep_texts(const SqliteFile& file, std::vector<FindingRecord> findings) {
  for (const FindingRecord& f : findings)
    for (const std::string* text : {&f.pair, &f.answers, &f.truth})
      if (is_too_deep(*text))
        throw InputError(fmt::format("{}: finding {} has JSON that is nested more than {} deep: it is forged",
                                     file.name(), f.id, json_depth_cap));
  return findings;
}

/// Adds the counts of a batch to the stored counts.
void add_cells(SqliteFile& file, const std::vector<CellRecord>& cells) {
  Query stored = file.query("SELECT * FROM cell WHERE plane=? AND x=? AND y=?");
  Query replace = file.insertion<CellRecord>("INSERT OR REPLACE");
  for (const CellRecord& cell : cells) {
    CellTable sum;
    sum.add(cell);
    for (const CellRecord& before : stored.rows<CellRecord>(cell.plane, cell.x, cell.y)) sum.add(before);
    replace.run(sum.records().front());
  }
}

}  // namespace

Counts& Counts::operator+=(const Counts& other) {
  asked += other.asked;
  declined += other.declined;
  failed += other.failed;
  contract += other.contract;
  resolution += other.resolution;
  undecided += other.undecided;
  nanoseconds += other.nanoseconds;
  hung_nanoseconds += other.hung_nanoseconds;
  return *this;
}

RunStore::RunStore(std::unique_ptr<SqliteFile> file) : file_(std::move(file)) {}
RunStore::RunStore(RunStore&&) noexcept = default;
RunStore::~RunStore() = default;

// The file appears under its name when it is complete, so a kill before that leaves no half run.
RunStore RunStore::create(const std::string& folder, const Config& config,
                          const std::vector<MethodRecord>& methods) {
  namespace fs = std::filesystem;
  fs::create_directories(folder);
  if (holds_run(folder)) throw UsageError(folder + " already holds a run");
  const std::string unfinished = file_of(folder) + ".new";
  fs::remove(unfinished);
  {
    SqliteFile file(unfinished, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    file.script(fmt::format("PRAGMA page_size={}", page_bytes));
    file.transaction([&] {
      file.script(tables);
      Query set = file.insertion<ConfigEntry>();
      for (const auto& [key, value] : config) set.run(key, value);
      Query add = file.insertion<MethodRecord>();
      for (const MethodRecord& method : methods) add.run(method);
      file.script(fmt::format("PRAGMA user_version={}", store_version));
    });
  }
  fs::rename(unfinished, file_of(folder));
  return open(folder);
}

RunStore RunStore::open(const std::string& folder) {
  if (!holds_run(folder)) throw UsageError(folder + " holds no run");
  auto file = std::make_unique<SqliteFile>(file_of(folder), SQLite::OPEN_READWRITE);
  if (const int version = file->rows<int>("PRAGMA user_version").front(); version != store_version) {
    throw std::runtime_error(fmt::format(
        "{} was written in store version {}; this build reads version {}: use the build that wrote it",
        file->name(), version, store_version));
  }
  file->check_schema(tables);
  file->write_ahead();
  check_counts(*file);
  return RunStore(std::move(file));
}

Config RunStore::config() const {
  Config config;
  for (const ConfigEntry& entry : file_->all<ConfigEntry>("rowid")) config[entry.key] = entry.value.text;
  return config;
}

std::vector<MethodRecord> RunStore::methods() const { return file_->all<MethodRecord>("rowid"); }

Progress RunStore::progress() const { return file_->rows<Progress>("SELECT * FROM progress").front(); }

void RunStore::set(const std::string& key, const std::string& value) {
  file_->replace(ConfigEntry{key, {value}});
}

void RunStore::commit(const BatchRecord& batch, std::uint64_t milliseconds) {
  file_->transaction([&] {
    if (const std::uint64_t next = progress().next; next != batch.first) {
      throw std::runtime_error(
          fmt::format("{}: batch {} offered where {} is next; another process writes to this run",
                      file_->name(), batch.first, next));
    }
    Representatives kept;
    for (const GroupRecord& group : groups()) kept.add(group);

    constexpr std::optional<std::int64_t> next_id;  // NULL: SQLite gives it
    Query keep = file_->query("INSERT INTO wrong_answer VALUES(?,?,?,?,?,?,?,?,?,?)");
    Query keep_pair = file_->query("INSERT OR IGNORE INTO judged_pair VALUES(?,?,?,?)");
    for (const FindingRecord& f : batch.findings) {
      if (!kept.admit(f)) continue;
      keep_pair.run(f.index, f.pair, f.answers, f.truth);
      keep.run(next_id, f.index, f.family, f.family_index, f.method, f.kind, f.severity, f.margin, f.reason);
    }

    Query count = file_->insertion<GroupRecord>(
        "INSERT",
        " ON CONFLICT DO UPDATE SET count=count+excluded.count, binade=max(binade, excluded.binade)");
    for (const GroupRecord& group : batch.groups) count.run(group);

    Query tally = file_->insertion<TallyRecord>(
        "INSERT",
        " ON CONFLICT DO UPDATE SET asked=asked+excluded.asked, declined=declined+excluded.declined, "
        "failed=failed+excluded.failed, contract=contract+excluded.contract, "
        "resolution=resolution+excluded.resolution, undecided=undecided+excluded.undecided, "
        "nanoseconds=nanoseconds+excluded.nanoseconds,"
        "hung_nanoseconds=hung_nanoseconds+excluded.hung_nanoseconds");
    for (const TallyRecord& record : batch.tallies) tally.run(record);

    add_cells(*file_, batch.cells);
    file_->run("UPDATE progress SET next=?, milliseconds=milliseconds+?", batch.next, milliseconds);
  });
}

std::vector<TallyRecord> RunStore::tallies() const { return file_->all<TallyRecord>("rowid"); }

std::vector<GroupRecord> RunStore::groups() const {
  return file_->all<GroupRecord>("method, kind, severity, family");
}

std::vector<FindingRecord> RunStore::findings() const {
  return without_deep_texts(*file_, file_->all<FindingRecord>("id"));
}

std::vector<CellRecord> RunStore::cells() const { return file_->all<CellRecord>("plane, x, y"); }

std::optional<FindingRecord> RunStore::finding(std::int64_t id) const {
  const auto found =
      without_deep_texts(*file_, file_->rows<FindingRecord>("SELECT * FROM finding WHERE id=?", id));
  return found.empty() ? std::nullopt : std::optional(found.front());
}

bool holds_run(const std::string& folder) { return std::filesystem::exists(file_of(folder)); }

std::vector<std::string> runs_in(const std::string& folder) {
  namespace fs = std::filesystem;
  std::vector<std::string> runs;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (!entry.is_symlink() && holds_run(entry.path().string())) runs.push_back(entry.path().string());
  }
  std::sort(runs.begin(), runs.end());
  return runs;
}

}  // namespace cyl
