// SPDX-License-Identifier: MIT
#include "reports/triage/triage_store.hpp"

#include <filesystem>
#include <optional>

#include "base/number_text.hpp"
#include "base/usage_error.hpp"
#include "corpus/store/sqlite_file.hpp"

namespace cyl {
namespace {

constexpr const char* note_table = "CREATE TABLE note(key TEXT PRIMARY KEY, value TEXT NOT NULL);";
constexpr const char* other_tables = R"(
CREATE TABLE cause(finding INTEGER PRIMARY KEY, cause TEXT NOT NULL, mechanism TEXT NOT NULL,
  labels TEXT NOT NULL);
CREATE TABLE simple(finding INTEGER PRIMARY KEY, pair TEXT NOT NULL, ended INTEGER NOT NULL);
)";

std::string file_of(const std::string& folder) { return folder + "/triage.sqlite"; }

struct Note {
  std::string key;
  Lines value;

  static constexpr const char* table = "note";
  static auto columns(auto& n) { return std::tie(n.key, n.value); }
};

std::string note(const SqliteFile& file, const std::string& key) {
  const auto found = file.rows<Note>("SELECT * FROM note WHERE key = ?", key);
  return found.empty() ? std::string() : found.front().value.text;
}

std::string stored_note(const std::string& folder, const std::string& key) {
  const std::string name = file_of(folder);
  if (!std::filesystem::exists(name)) return {};
  SqliteFile file(name, SQLite::OPEN_READWRITE);
  if (file.is_empty()) return {};
  file.check_schema(note_table, true);
  return note(file, key);
}

/// Opens or creates the file. The tables are made anew if another build made them, or a stranger.
std::unique_ptr<SqliteFile> open_or_create(const std::string& name) {
  const std::string tables = std::string(note_table) + other_tables;
  const auto open = [&] {
    auto file = std::make_unique<SqliteFile>(name, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    file->write_ahead();
    file->transaction([&] {
      if (file->is_empty()) file->script(tables);
    });
    file->check_schema(tables);
    return file;
  };
  try {
    return open();
  } catch (const InputError&) {
    for (const char* part : {"", "-wal", "-shm"}) std::filesystem::remove(name + part);
    return open();
  }
}

}  // namespace

TriageStore::TriageStore(const std::string& folder, const std::string& asked)
    : file_(open_or_create(file_of(folder))) {
  if (note(*file_, "asked") == asked) return;
  file_->transaction([&] {
    for (const char* table : {Note::table, CauseRecord::table, SimpleRecord::table})
      file_->script(std::string("DELETE FROM ") + table);
    file_->replace(Note{"asked", {asked}});
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
    file_->replace(Note{key, {version}});
  });
}

TriageStore::TriageStore(TriageStore&&) noexcept = default;
TriageStore::~TriageStore() = default;

std::vector<CauseRecord> TriageStore::causes() const { return file_->all<CauseRecord>("finding"); }
std::vector<SimpleRecord> TriageStore::simples() const { return file_->all<SimpleRecord>("finding"); }

void TriageStore::add(std::span<const CauseRecord> causes) {
  file_->transaction([&] {
    Query replace = file_->insertion<CauseRecord>("INSERT OR REPLACE");
    for (const CauseRecord& cause : causes) replace.run(cause);
  });
}

void TriageStore::add(const SimpleRecord& simple) { file_->replace(simple); }

void TriageStore::set_summary(const std::string& json, double part) {
  file_->transaction([&] {
    file_->replace(Note{"causes", {json}});
    file_->replace(Note{"part", {format_double(part)}});
  });
}

std::string stored_summary(const std::string& folder) { return stored_note(folder, "causes"); }

double stored_part(const std::string& folder) {
  const std::string text = stored_note(folder, "part");
  if (text.empty()) return 1;
  const std::optional<double> part = number_in<double>(text);
  if (!part) throw InputError(file_of(folder) + ": part is '" + text + "', no number");
  return *part;
}

}  // namespace cyl
