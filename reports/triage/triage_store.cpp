// SPDX-License-Identifier: MIT
#include "reports/triage/triage_store.hpp"

#include <filesystem>

#include "corpus/store/sqlite_file.hpp"

namespace cyl {
namespace {

constexpr const char* notes = "CREATE TABLE IF NOT EXISTS note(key TEXT PRIMARY KEY, value TEXT NOT NULL)";

/// The tables are made anew, because those of another build may differ.
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

struct Note {
  std::string key, value;

  static constexpr const char* table = "note";
  static auto columns(auto& n) { return std::tie(n.key, n.value); }
};

std::string note(const SqliteFile& file, const std::string& key) {
  const auto found = file.rows<Note>("SELECT * FROM note WHERE key = ?", key);
  return found.empty() ? std::string() : found.front().value;
}

std::string stored_note(const std::string& folder, const std::string& key) {
  const std::string name = file_of(folder);
  if (!std::filesystem::exists(name)) return {};
  const SqliteFile file(name, SQLite::OPEN_READWRITE);
  return file.has(Note::table) ? note(file, key) : std::string();
}

}  // namespace

TriageStore::TriageStore(const std::string& folder, const std::string& asked)
    : file_(std::make_unique<SqliteFile>(file_of(folder), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE)) {
  file_->write_ahead();
  file_->script(notes);
  if (note(*file_, "asked") == asked) return;
  file_->transaction([&] {
    file_->script(tables);
    file_->replace(Note{"asked", asked});
  });
}

void TriageStore::expect(const std::string& guest, const std::string& version,
                         std::span<const std::int64_t> findings) {
  const std::string key = "guest " + guest;
  if (note(*file_, key) == version) return;
  file_->transaction([&] {
    for (const char* table : {CauseRecord::table, SimpleRecord::table}) {
      Query drop = file_->query(std::string("DELETE FROM ") + table + " WHERE finding = ?");
      for (const std::int64_t finding : findings) drop.run(finding);
    }
    file_->run("DELETE FROM worst WHERE method = ?", guest);
    file_->replace(Note{key, version});
  });
}

TriageStore::TriageStore(TriageStore&&) noexcept = default;
TriageStore::~TriageStore() = default;

std::vector<CauseRecord> TriageStore::causes() const { return file_->all<CauseRecord>("finding"); }
std::vector<SimpleRecord> TriageStore::simples() const { return file_->all<SimpleRecord>("finding"); }
std::vector<WorstRecord> TriageStore::worsts() const { return file_->all<WorstRecord>("bucket"); }

void TriageStore::add(std::span<const CauseRecord> causes) {
  file_->transaction([&] {
    Query replace = file_->insertion<CauseRecord>("INSERT OR REPLACE");
    for (const CauseRecord& cause : causes) replace.run(cause);
  });
}

void TriageStore::add(const SimpleRecord& simple) { file_->replace(simple); }
void TriageStore::add(const WorstRecord& worst) { file_->replace(worst); }

std::string TriageStore::summary() const { return note(*file_, "buckets"); }
void TriageStore::set_summary(const std::string& json, double part) {
  file_->transaction([&] {
    file_->replace(Note{"buckets", json});
    file_->replace(Note{"part", std::to_string(part)});
  });
}

std::string stored_summary(const std::string& folder) { return stored_note(folder, "buckets"); }

std::vector<CauseRecord> stored_causes(const std::string& folder) {
  const SqliteFile file(file_of(folder), SQLite::OPEN_READWRITE);
  return file.all<CauseRecord>("finding");
}

double stored_part(const std::string& folder) {
  const std::string text = stored_note(folder, "part");
  return text.empty() ? 1 : std::stod(text);
}

}  // namespace cyl
