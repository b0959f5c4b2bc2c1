// SPDX-License-Identifier: MIT
#include "corpus/store/run_store.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "base/usage_error.hpp"
#include "corpus/pairs/pair_io.hpp"

namespace cyl {
namespace {

constexpr int store_version = 1;  ///< of the tables below, in PRAGMA user_version
/// Milliseconds to wait for another process that reads or writes the same run.
constexpr int busy_cap = 10000;

constexpr const char* tables = R"(
CREATE TABLE run(key TEXT PRIMARY KEY, value TEXT NOT NULL);
CREATE TABLE method(name TEXT PRIMARY KEY, version TEXT NOT NULL, relative TEXT NOT NULL, absolute TEXT NOT NULL,
  source TEXT NOT NULL, share INTEGER NOT NULL);
CREATE TABLE progress(next INTEGER NOT NULL, milliseconds INTEGER NOT NULL);
CREATE TABLE tally(method TEXT NOT NULL, family TEXT NOT NULL, asked INTEGER NOT NULL, declined INTEGER NOT NULL,
  failed INTEGER NOT NULL, contract INTEGER NOT NULL, resolution INTEGER NOT NULL, undecided INTEGER NOT NULL,
  nanoseconds INTEGER NOT NULL, PRIMARY KEY(method, family));
CREATE TABLE finding_group(method TEXT NOT NULL, kind TEXT NOT NULL, severity TEXT NOT NULL, family TEXT NOT NULL,
  count INTEGER NOT NULL, binade INTEGER NOT NULL, PRIMARY KEY(method, kind, severity, family));
CREATE TABLE finding(id INTEGER PRIMARY KEY, pair_index INTEGER NOT NULL, family TEXT NOT NULL,
  family_index INTEGER NOT NULL, method TEXT NOT NULL, kind TEXT NOT NULL, severity TEXT NOT NULL,
  margin_lo TEXT, margin_hi TEXT, pair TEXT NOT NULL, answers TEXT NOT NULL, truth TEXT NOT NULL,
  stage TEXT NOT NULL, reason TEXT NOT NULL);
INSERT INTO progress VALUES(0, 0);
)";
/// Not in stores of before there were maps: made where one of them is opened.
constexpr const char* cell_table =
    "CREATE TABLE IF NOT EXISTS cell(plane TEXT NOT NULL, x INTEGER NOT NULL, y INTEGER NOT NULL, "
    "methods TEXT NOT NULL, PRIMARY KEY(plane, x, y)) WITHOUT ROWID";

/// Made with the first alarm: runs without any are what they always were.
constexpr const char* alarm_table = R"(
CREATE TABLE IF NOT EXISTS alarm(start INTEGER PRIMARY KEY, mutant INTEGER NOT NULL, what TEXT NOT NULL,
  found INTEGER NOT NULL, pairs INTEGER NOT NULL, usual INTEGER NOT NULL, milliseconds INTEGER NOT NULL,
  said TEXT NOT NULL);
)";

constexpr const char* finding_columns =
    "id, pair_index, family, family_index, method, kind, severity, margin_lo, margin_hi, pair, answers, "
    "truth, "
    "stage, reason";

std::int64_t to_sql(std::uint64_t x) { return static_cast<std::int64_t>(x); }
std::uint64_t from_sql(const SQLite::Column& column) { return static_cast<std::uint64_t>(column.getInt64()); }

double parse_double(const std::string& text) {
  double x = 0;
  std::from_chars(text.data(), text.data() + text.size(), x);
  return x;
}

FindingRecord read_finding(SQLite::Statement& row) {
  FindingRecord f;
  f.id = row.getColumn(0).getInt64();
  f.index = from_sql(row.getColumn(1));
  f.family = row.getColumn(2).getString();
  f.family_index = from_sql(row.getColumn(3));
  f.method = row.getColumn(4).getString();
  f.kind = row.getColumn(5).getString();
  f.severity = row.getColumn(6).getString();
  if (!row.isColumnNull(7)) {
    f.margin =
        MarginRecord{parse_double(row.getColumn(7).getString()), parse_double(row.getColumn(8).getString())};
  }
  f.pair = row.getColumn(9).getString();
  f.answers = row.getColumn(10).getString();
  f.truth = row.getColumn(11).getString();
  f.stage = row.getColumn(12).getString();
  f.reason = row.getColumn(13).getString();
  return f;
}

void write_finding(SQLite::Statement& insert, const FindingRecord& f) {
  insert.reset();
  insert.clearBindings();
  insert.bind(1, to_sql(f.index));
  insert.bind(2, f.family);
  insert.bind(3, to_sql(f.family_index));
  insert.bind(4, f.method);
  insert.bind(5, f.kind);
  insert.bind(6, f.severity);
  if (f.margin) {
    insert.bind(7, format_double(f.margin->lo));
    insert.bind(8, format_double(f.margin->hi));
  }
  insert.bind(9, f.pair);
  insert.bind(10, f.answers);
  insert.bind(11, f.truth);
  insert.bind(12, f.stage);
  insert.bind(13, f.reason);
  insert.exec();
}

GroupRecord read_group(SQLite::Statement& row) {
  GroupRecord g;
  g.method = row.getColumn(0).getString();
  g.kind = row.getColumn(1).getString();
  g.severity = row.getColumn(2).getString();
  g.family = row.getColumn(3).getString();
  g.count = from_sql(row.getColumn(4));
  g.binade = row.getColumn(5).getInt();
  return g;
}

std::string file_of(const std::string& folder) { return folder + "/run.sqlite"; }

/// What `work` gives; SQLite's own errors say what went wrong, not where.
template <class Work>
auto naming(const std::string& file, Work work) {
  try {
    return work();
  } catch (const SQLite::Exception& error) {
    throw std::runtime_error(file + ": " + error.what());
  }
}

std::unique_ptr<SQLite::Database> connect(const std::string& folder) {
  auto database = std::make_unique<SQLite::Database>(file_of(folder), SQLite::OPEN_READWRITE, busy_cap);
  database->exec("PRAGMA journal_mode=WAL");
  database->exec("PRAGMA synchronous=NORMAL");
  return database;
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
  return *this;
}

Representatives::Key Representatives::key_of(const FindingRecord& f) {
  return {f.method, f.kind, f.severity, f.family};
}

// The first rule keeps by place in the group, the second by the running maximum of the binade. A piece knows
// less of both than the whole, so it admits a superset, and every finding that raised the whole's maximum is
// in it. That holds of shards, whose pieces lie between each other, as of stretches: let S be a group's
// findings in index order, S_i those of shard i, and U the union of what the shards keep. Who is among the
// first ten of S is among the first ten of its S_i, and who exceeds all before it in S exceeds those before
// it in S_i: U holds both. As U is part of S and holds the first ten of S, those are the first ten of U; as U
// holds every finding that raised the maximum of S, the maximum before any place is the same in U and in S.
// So U, filtered in index order, keeps what S does.
bool Representatives::admit(const FindingRecord& f) {
  GroupRecord& group =
      groups_.try_emplace(key_of(f), GroupRecord{f.method, f.kind, f.severity, f.family}).first->second;
  const double margin = f.margin ? f.margin->lo : 0;
  const int binade =
      margin > 0 ? std::min(std::ilogb(margin), -(GroupRecord::no_binade + 1)) : GroupRecord::no_binade;
  const bool worse = binade > group.binade;
  if (worse) group.binade = binade;
  return ++group.count <= representatives_cap || worse;
}

void Representatives::add(const GroupRecord& g) {
  GroupRecord& group = groups_
                           .try_emplace({g.method, g.kind, g.severity, g.family},
                                        GroupRecord{g.method, g.kind, g.severity, g.family})
                           .first->second;
  group.count += g.count;
  group.binade = std::max(group.binade, g.binade);
}

std::vector<GroupRecord> Representatives::groups() const {
  std::vector<GroupRecord> all;
  for (const auto& [key, group] : groups_) all.push_back(group);
  return all;
}

RunStore::RunStore(std::unique_ptr<SQLite::Database> database) : database_(std::move(database)) {}
RunStore::RunStore(RunStore&&) noexcept = default;
RunStore::~RunStore() = default;

// The file appears under its name when it is complete: a kill before leaves no half a run.
RunStore RunStore::create(const std::string& folder, const Config& config,
                          const std::vector<MethodRecord>& methods) {
  namespace fs = std::filesystem;
  fs::create_directories(folder);
  if (holds_run(folder)) throw std::runtime_error(folder + " already holds a run");
  const std::string unfinished = file_of(folder) + ".new";
  fs::remove(unfinished);
  naming(unfinished, [&] {
    SQLite::Database database(unfinished, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    SQLite::Transaction transaction(database);
    database.exec(tables);
    database.exec(cell_table);
    SQLite::Statement insert(database, "INSERT INTO run VALUES(?, ?)");
    for (const auto& [key, value] : config) {
      insert.reset();
      insert.bind(1, key);
      insert.bind(2, value);
      insert.exec();
    }
    SQLite::Statement add(database, "INSERT INTO method VALUES(?, ?, ?, ?, ?, ?)");
    for (const MethodRecord& m : methods) {
      add.reset();
      add.bind(1, m.name);
      add.bind(2, m.version);
      add.bind(3, format_double(m.relative));
      add.bind(4, format_double(m.absolute));
      add.bind(5, m.source);
      add.bind(6, m.share);
      add.exec();
    }
    database.exec(fmt::format("PRAGMA user_version={}", store_version));
    transaction.commit();
  });
  fs::rename(unfinished, file_of(folder));
  return open(folder);
}

RunStore RunStore::open(const std::string& folder) {
  if (!holds_run(folder)) throw UsageError(folder + " holds no run");
  RunStore store(naming(file_of(folder), [&] { return connect(folder); }));
  const int version =
      naming(file_of(folder), [&] { return store.database_->execAndGet("PRAGMA user_version").getInt(); });
  if (version != store_version) {
    throw std::runtime_error(fmt::format("{} was written in store version {}, this build reads {}",
                                         file_of(folder), version, store_version));
  }
  naming(file_of(folder), [&] { return store.database_->exec(cell_table); });
  return store;
}

Config RunStore::config() const {
  return naming(database_->getFilename(), [&] {
    Config config;
    SQLite::Statement row(*database_, "SELECT key, value FROM run");
    while (row.executeStep()) config[row.getColumn(0).getString()] = row.getColumn(1).getString();
    return config;
  });
}

std::vector<MethodRecord> RunStore::methods() const {
  return naming(database_->getFilename(), [&] {
    std::vector<MethodRecord> all;
    SQLite::Statement row(
        *database_, "SELECT name, version, relative, absolute, source, share FROM method ORDER BY rowid");
    while (row.executeStep()) {
      all.push_back({row.getColumn(0).getString(), row.getColumn(1).getString(),
                     parse_double(row.getColumn(2).getString()), parse_double(row.getColumn(3).getString()),
                     row.getColumn(4).getString(), row.getColumn(5).getUInt()});
    }
    return all;
  });
}

Progress RunStore::progress() const {
  return naming(database_->getFilename(), [&]() -> Progress {
    SQLite::Statement row(*database_, "SELECT next, milliseconds FROM progress");
    row.executeStep();
    return {from_sql(row.getColumn(0)), from_sql(row.getColumn(1))};
  });
}

void RunStore::set(const std::string& key, const std::string& value) {
  naming(database_->getFilename(), [&] {
    SQLite::Statement replace(*database_, "INSERT OR REPLACE INTO run VALUES(?, ?)");
    replace.bind(1, key);
    replace.bind(2, value);
    replace.exec();
  });
}

void RunStore::commit(const BatchRecord& batch, std::uint64_t milliseconds) {
  naming(database_->getFilename(), [&] {
    SQLite::Transaction transaction(*database_, SQLite::TransactionBehavior::IMMEDIATE);
    if (const std::uint64_t next = progress().next; next != batch.first) {
      throw std::runtime_error(
          fmt::format("{}: batch {} offered where {} is next; another process writes to this run",
                      database_->getFilename(), batch.first, next));
    }
    Representatives kept;
    for (const GroupRecord& group : groups()) kept.add(group);

    SQLite::Statement insert(
        *database_,
        fmt::format("INSERT INTO finding({}) VALUES(NULL,?,?,?,?,?,?,?,?,?,?,?,?,?)", finding_columns));
    for (const FindingRecord& f : batch.findings) {
      if (kept.admit(f)) write_finding(insert, f);
    }

    SQLite::Statement count(*database_,
                            "INSERT INTO finding_group VALUES(?,?,?,?,?,?) ON CONFLICT DO UPDATE SET "
                            "count=count+excluded.count, binade=max(binade, excluded.binade)");
    for (const GroupRecord& g : batch.groups) {
      count.reset();
      count.bind(1, g.method);
      count.bind(2, g.kind);
      count.bind(3, g.severity);
      count.bind(4, g.family);
      count.bind(5, to_sql(g.count));
      count.bind(6, g.binade);
      count.exec();
    }

    SQLite::Statement tally(
        *database_,
        "INSERT INTO tally VALUES(?,?,?,?,?,?,?,?,?) ON CONFLICT DO UPDATE SET "
        "asked=asked+excluded.asked, declined=declined+excluded.declined, "
        "failed=failed+excluded.failed, contract=contract+excluded.contract, "
        "resolution=resolution+excluded.resolution, undecided=undecided+excluded.undecided, "
        "nanoseconds=nanoseconds+excluded.nanoseconds");
    for (const auto& [method, family, c] : batch.tallies) {
      tally.reset();
      tally.bind(1, method);
      tally.bind(2, family);
      int column = 3;
      for (const std::uint64_t n :
           {c.asked, c.declined, c.failed, c.contract, c.resolution, c.undecided, c.nanoseconds}) {
        tally.bind(column++, to_sql(n));
      }
      tally.exec();
    }

    SQLite::Statement counted(*database_, "SELECT methods FROM cell WHERE plane=? AND x=? AND y=?");
    SQLite::Statement recount(*database_, "INSERT OR REPLACE INTO cell VALUES(?,?,?,?)");
    for (const CellRecord& cell : batch.cells) {
      for (SQLite::Statement* s : {&counted, &recount}) {
        s->reset();
        s->bind(1, cell.plane);
        s->bind(2, cell.x);
        s->bind(3, cell.y);
      }
      CellTable sum;
      sum.add(cell);
      if (counted.executeStep())
        sum.add({cell.plane, cell.x, cell.y, parse_cell_counts(counted.getColumn(0).getString())});
      counted.reset();
      recount.bind(4, format_cell_counts(sum.records().front().methods));
      recount.exec();
    }

    SQLite::Statement advance(*database_, "UPDATE progress SET next=?, milliseconds=milliseconds+?");
    advance.bind(1, to_sql(batch.next));
    advance.bind(2, to_sql(milliseconds));
    advance.exec();
    transaction.commit();
  });
}

std::vector<TallyRecord> RunStore::tallies() const {
  return naming(database_->getFilename(), [&] {
    std::vector<TallyRecord> all;
    SQLite::Statement row(
        *database_,
        "SELECT method, family, asked, declined, failed, contract, resolution, undecided, nanoseconds "
        "FROM tally ORDER BY rowid");
    while (row.executeStep()) {
      all.push_back(
          {row.getColumn(0).getString(), row.getColumn(1).getString(),
           Counts{from_sql(row.getColumn(2)), from_sql(row.getColumn(3)), from_sql(row.getColumn(4)),
                  from_sql(row.getColumn(5)), from_sql(row.getColumn(6)), from_sql(row.getColumn(7)),
                  from_sql(row.getColumn(8))}});
    }
    return all;
  });
}

std::vector<GroupRecord> RunStore::groups() const {
  return naming(database_->getFilename(), [&] {
    std::vector<GroupRecord> all;
    SQLite::Statement row(*database_,
                          "SELECT method, kind, severity, family, count, binade FROM finding_group ORDER BY "
                          "method, kind, severity, family");
    while (row.executeStep()) all.push_back(read_group(row));
    return all;
  });
}

std::vector<FindingRecord> RunStore::findings() const {
  return naming(database_->getFilename(), [&] {
    std::vector<FindingRecord> all;
    SQLite::Statement row(*database_, fmt::format("SELECT {} FROM finding ORDER BY id", finding_columns));
    while (row.executeStep()) all.push_back(read_finding(row));
    return all;
  });
}

std::vector<CellRecord> RunStore::cells() const {
  return naming(database_->getFilename(), [&] {
    std::vector<CellRecord> all;
    SQLite::Statement row(*database_, "SELECT plane, x, y, methods FROM cell ORDER BY plane, x, y");
    while (row.executeStep()) {
      all.push_back({row.getColumn(0).getString(), row.getColumn(1).getInt(), row.getColumn(2).getInt(),
                     parse_cell_counts(row.getColumn(3).getString())});
    }
    return all;
  });
}

std::optional<FindingRecord> RunStore::finding(std::int64_t id) const {
  return naming(database_->getFilename(), [&]() -> std::optional<FindingRecord> {
    SQLite::Statement row(*database_, fmt::format("SELECT {} FROM finding WHERE id=?", finding_columns));
    row.bind(1, id);
    if (!row.executeStep()) return {};
    return read_finding(row);
  });
}

void RunStore::add(const AlarmRecord& a) {
  naming(database_->getFilename(), [&] {
    database_->exec(alarm_table);
    SQLite::Statement replace(*database_, "INSERT OR REPLACE INTO alarm VALUES(?,?,?,?,?,?,?,?)");
    replace.bind(1, to_sql(a.start));
    replace.bind(2, a.mutant);
    replace.bind(3, a.what);
    replace.bind(4, a.found ? 1 : 0);
    replace.bind(5, to_sql(a.pairs));
    replace.bind(6, to_sql(a.usual));
    replace.bind(7, to_sql(a.milliseconds));
    replace.bind(8, a.said);
    replace.exec();
  });
}

std::vector<AlarmRecord> RunStore::alarms() const {
  return naming(database_->getFilename(), [&] {
    std::vector<AlarmRecord> all;
    if (!database_->tableExists("alarm")) return all;
    SQLite::Statement row(
        *database_,
        "SELECT start, mutant, what, found, pairs, usual, milliseconds, said FROM alarm ORDER BY start");
    while (row.executeStep()) {
      all.push_back({from_sql(row.getColumn(0)), row.getColumn(1).getInt(), row.getColumn(2).getString(),
                     row.getColumn(3).getInt() != 0, from_sql(row.getColumn(4)), from_sql(row.getColumn(5)),
                     from_sql(row.getColumn(6)), row.getColumn(7).getString()});
    }
    return all;
  });
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
