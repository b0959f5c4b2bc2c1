// SPDX-License-Identifier: MIT
#include "corpus/store/triage_store.hpp"

#include <SQLiteCpp/SQLiteCpp.h>

#include <filesystem>
#include <stdexcept>

namespace cyl {
namespace {

/// Milliseconds to wait for another process that writes the same file.
constexpr int busy_cap = 10000;

constexpr const char* notes = "CREATE TABLE IF NOT EXISTS note(key TEXT PRIMARY KEY, value TEXT NOT NULL)";

/// Made anew, since another build may have made others.
constexpr const char* tables = R"(
DELETE FROM note;
DROP TABLE IF EXISTS cause;
DROP TABLE IF EXISTS simple;
DROP TABLE IF EXISTS worst;
CREATE TABLE cause(finding INTEGER PRIMARY KEY, bucket TEXT NOT NULL, mechanism TEXT NOT NULL,
  labels TEXT NOT NULL);
CREATE TABLE simple(finding INTEGER PRIMARY KEY, pair TEXT NOT NULL, key TEXT NOT NULL,
  questions INTEGER NOT NULL, ended INTEGER NOT NULL);
CREATE TABLE worst(bucket TEXT PRIMARY KEY, method TEXT NOT NULL, kind TEXT NOT NULL,
  pair TEXT NOT NULL, ended INTEGER NOT NULL);
)";

std::string file_of(const std::string& folder) { return folder + "/triage.sqlite"; }

template <class Work>
auto naming(const std::string& file, Work work) {
  try {
    return work();
  } catch (const SQLite::Exception& error) {
    throw std::runtime_error(file + ": " + error.what());
  }
}

std::string note(SQLite::Database& database, const char* key) {
  SQLite::Statement query(database, "SELECT value FROM note WHERE key = ?");
  query.bind(1, key);
  return query.executeStep() ? query.getColumn(0).getString() : std::string();
}

void set_note(SQLite::Database& database, const char* key, const std::string& value) {
  SQLite::Statement insert(database, "INSERT OR REPLACE INTO note VALUES(?, ?)");
  insert.bind(1, key);
  insert.bind(2, value);
  insert.exec();
}

}  // namespace

TriageStore::TriageStore(const std::string& folder, const std::string& asked) : file_(file_of(folder)) {
  naming(file_, [&] {
    database_ =
        std::make_unique<SQLite::Database>(file_, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE, busy_cap);
    database_->exec("PRAGMA journal_mode=WAL");
    database_->exec("PRAGMA synchronous=NORMAL");
    database_->exec(notes);
    if (note(*database_, "asked") == asked) return;
    SQLite::Transaction transaction(*database_, SQLite::TransactionBehavior::IMMEDIATE);
    database_->exec(tables);
    set_note(*database_, "asked", asked);
    transaction.commit();
  });
}

void TriageStore::expect(const std::string& guest, const std::string& version,
                         std::span<const std::int64_t> findings) {
  naming(file_, [&] {
    const std::string key = "guest " + guest;
    if (note(*database_, key.c_str()) == version) return;
    SQLite::Transaction transaction(*database_, SQLite::TransactionBehavior::IMMEDIATE);
    for (const char* table : {"cause", "simple"}) {
      SQLite::Statement drop(*database_, std::string("DELETE FROM ") + table + " WHERE finding = ?");
      for (const std::int64_t finding : findings) {
        drop.reset();
        drop.bind(1, finding);
        drop.exec();
      }
    }
    SQLite::Statement drop(*database_, "DELETE FROM worst WHERE method = ?");
    drop.bind(1, guest);
    drop.exec();
    set_note(*database_, key.c_str(), version);
    transaction.commit();
  });
}

TriageStore::TriageStore(TriageStore&&) noexcept = default;
TriageStore::~TriageStore() = default;

std::vector<CauseRecord> TriageStore::causes() const {
  return naming(file_, [&] {
    std::vector<CauseRecord> all;
    SQLite::Statement row(*database_,
                          "SELECT finding, bucket, mechanism, labels FROM cause ORDER BY finding");
    while (row.executeStep())
      all.push_back({row.getColumn(0).getInt64(), row.getColumn(1).getString(), row.getColumn(2).getString(),
                     row.getColumn(3).getString()});
    return all;
  });
}

std::vector<SimpleRecord> TriageStore::simples() const {
  return naming(file_, [&] {
    std::vector<SimpleRecord> all;
    SQLite::Statement row(*database_,
                          "SELECT finding, pair, key, questions, ended FROM simple ORDER BY finding");
    while (row.executeStep())
      all.push_back({row.getColumn(0).getInt64(), row.getColumn(1).getString(), row.getColumn(2).getString(),
                     static_cast<std::uint64_t>(row.getColumn(3).getInt64()),
                     row.getColumn(4).getInt() != 0});
    return all;
  });
}

std::vector<WorstRecord> TriageStore::worsts() const {
  return naming(file_, [&] {
    std::vector<WorstRecord> all;
    SQLite::Statement row(*database_, "SELECT bucket, method, kind, pair, ended FROM worst ORDER BY bucket");
    while (row.executeStep())
      all.push_back({row.getColumn(0).getString(), row.getColumn(1).getString(), row.getColumn(2).getString(),
                     row.getColumn(3).getString(), row.getColumn(4).getInt() != 0});
    return all;
  });
}

void TriageStore::add(std::span<const CauseRecord> causes) {
  naming(file_, [&] {
    SQLite::Transaction transaction(*database_, SQLite::TransactionBehavior::IMMEDIATE);
    SQLite::Statement insert(*database_, "INSERT OR REPLACE INTO cause VALUES(?, ?, ?, ?)");
    for (const CauseRecord& c : causes) {
      insert.reset();
      insert.bind(1, c.finding);
      insert.bind(2, c.bucket);
      insert.bind(3, c.mechanism);
      insert.bind(4, c.labels);
      insert.exec();
    }
    transaction.commit();
  });
}

void TriageStore::add(const SimpleRecord& simple) {
  naming(file_, [&] {
    SQLite::Statement insert(*database_, "INSERT OR REPLACE INTO simple VALUES(?, ?, ?, ?, ?)");
    insert.bind(1, simple.finding);
    insert.bind(2, simple.pair);
    insert.bind(3, simple.key);
    insert.bind(4, static_cast<std::int64_t>(simple.questions));
    insert.bind(5, simple.ended ? 1 : 0);
    insert.exec();
  });
}

void TriageStore::add(const WorstRecord& worst) {
  naming(file_, [&] {
    SQLite::Statement insert(*database_, "INSERT OR REPLACE INTO worst VALUES(?, ?, ?, ?, ?)");
    insert.bind(1, worst.bucket);
    insert.bind(2, worst.method);
    insert.bind(3, worst.kind);
    insert.bind(4, worst.pair);
    insert.bind(5, worst.ended ? 1 : 0);
    insert.exec();
  });
}

std::string TriageStore::buckets() const {
  return naming(file_, [&] { return note(*database_, "buckets"); });
}

void TriageStore::set_buckets(const std::string& json) {
  naming(file_, [&] { set_note(*database_, "buckets", json); });
}

std::string stored_buckets(const std::string& folder) {
  const std::string file = file_of(folder);
  if (!std::filesystem::exists(file)) return {};
  return naming(file, [&] {
    SQLite::Database database(file, SQLite::OPEN_READWRITE, busy_cap);
    return database.tableExists("note") ? note(database, "buckets") : std::string();
  });
}

}  // namespace cyl
