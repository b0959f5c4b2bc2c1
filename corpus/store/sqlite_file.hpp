// SPDX-License-Identifier: MIT
// One SQLite file, its rows as records. A record names its table and ties its members in the order of the
// columns:
//
//   static constexpr const char* table = "tally";
//   static auto columns(auto& row) { return std::tie(row.method, row.family, row.counts); }
//
// 1. A member that is a record itself stands for all its columns, and an empty optional one for as many
//    NULLs.
// 2. Doubles are stored as their shortest text, because a column has no infinity and no -0. Unsigned numbers
//    are stored by their bits, enums by their words.
// 3. If the file cannot be read or written, a call throws std::runtime_error, which names the file. If the
//    content is at fault, that is an InputError.
//
// A stranger may have made the file, so
// 4. no trigger fires, no view answers before check_schema() has seen it, and no query takes longer or
//    returns more than the size of the file explains;
// 5. text is read with its control characters escaped, so that no name steers a terminal or forges a line.
//    JSON keeps its meaning. A member of type Lines keeps line breaks and tabs, which separate its parts.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>
#include <sqlite3.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/enum_words.hpp"
#include "base/files.hpp"
#include "base/number_text.hpp"
#include "base/safe_text.hpp"
#include "base/usage_error.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "corpus/store/cell_counts.hpp"

namespace cyl {

namespace sqlite {

/// The current row of a statement, and how many bytes of text were read from its rows.
struct Row {
  SQLite::Statement& statement;
  std::size_t bytes = 0;

  std::string text(int at) {
    std::string text = statement.getColumn(at).getString();
    bytes += text.size();
    return text;
  }
};

template <class T>
concept Record = requires(T& row) {
  T::columns(row);
};

/// The number of columns that a value takes.
template <class T>
struct Width : std::integral_constant<int, 1> {};
template <class... T>
struct Width<std::tuple<T...>> : std::integral_constant<int, (Width<std::remove_cvref_t<T>>::value + ...)> {};
template <class T>
struct Width<std::optional<T>> : Width<T> {};
template <Record T>
struct Width<T> : Width<decltype(T::columns(std::declval<T&>()))> {};

template <class T>
void write(SQLite::Statement& to, int& at, const std::optional<T>& value);
template <class T>
void read(Row& row, int& at, std::optional<T>& value);

template <class... T>
void write(SQLite::Statement& to, int& at, const std::tuple<const T&...>& values);

template <class T>
void write(SQLite::Statement& to, int& at, const T& value) {
  if constexpr (Record<T>) {
    write(to, at, T::columns(value));
  } else if constexpr (std::is_same_v<T, double>) {
    to.bind(at++, format_double(value));
  } else if constexpr (std::is_same_v<T, std::vector<CellCounts>>) {
    to.bind(at++, format_cell_counts(value));
  } else if constexpr (std::is_same_v<T, Lines>) {
    to.bind(at++, value.text);
  } else if constexpr (Worded<T>) {
    to.bind(at++, to_string(value));
  } else if constexpr (std::is_integral_v<T>) {
    to.bind(at++, static_cast<std::int64_t>(value));
  } else {
    to.bind(at++, value);
  }
}

template <class... T>
void write(SQLite::Statement& to, int& at, const std::tuple<const T&...>& values) {
  std::apply([&](const auto&... value) { (write(to, at, value), ...); }, values);
}

template <class T>
void write(SQLite::Statement& to, int& at, const std::optional<T>& value) {
  if (value) {
    write(to, at, *value);
  } else {
    at += Width<T>::value;  // what is not bound is NULL
  }
}

template <class T>
void read(Row& row, int& at, T& value) {
  if constexpr (Record<T>) {
    std::apply([&](auto&... member) { (read(row, at, member), ...); }, T::columns(value));
  } else if constexpr (std::is_integral_v<T>) {
    value = static_cast<T>(row.statement.getColumn(at++).getInt64());
  } else {
    const std::string text = row.text(at++);
    if constexpr (std::is_same_v<T, double>) {
      const std::optional<double> number = number_in<double>(text);
      if (!number) throw SQLite::Exception("'" + escaped_controls(text) + "' is not a number");
      value = *number;
    } else if constexpr (std::is_same_v<T, Lines>) {
      value.text = escaped_controls(text, "\n\t");
    } else if constexpr (std::is_same_v<T, std::vector<CellCounts>>) {
      value = parse_cell_counts(text);
    } else if constexpr (Worded<T>) {
      const std::optional<T> known = from_word<T>(text);
      if (!known)
        throw SQLite::Exception("'" + escaped_controls(text) + "' is not a word that this version writes");
      value = *known;
    } else {
      value = escaped_controls(text);
    }
  }
}

template <class T>
void read(Row& row, int& at, std::optional<T>& value) {
  if (row.statement.isColumnNull(at)) {
    at += Width<T>::value;
  } else {
    read(row, at, value.emplace());
  }
}

/// The limits of one query. A damaged file can name a page many times, so that its rows never end.
class Work {
 public:
  explicit Work(std::string file) : file_(std::move(file)) {}

  /// SQLite calls the handler after this many of its own steps, some milliseconds.
  static constexpr int steps_between = 100'000;

  void begin() { steps_ = 0; }
  /// Returns whether the steps are more than the file explains. A row takes 30 bytes or more and less than a
  /// hundred steps.
  bool is_too_much() { return (steps_ += steps_between) > 2'000'000 + 10 * size(); }
  /// Throws SQLite::Exception if the text is more than the file explains. A finding repeats the text of its
  /// pair, and there are not more than a hundred methods.
  void check_text(std::size_t bytes) const {
    if (bytes > (std::size_t(32) << 20) && bytes > 100 * size()) throw SQLite::Exception(excess);
  }
  static constexpr const char* excess = "it holds more than its size explains: it is damaged or forged";

 private:
  std::size_t size() const {
    std::size_t sum = 0;
    for (const std::string& file : {file_, file_ + "-wal"}) {
      std::error_code none;
      if (const auto size = std::filesystem::file_size(file, none); !none) sum += size;
    }
    return sum;
  }
  std::string file_;
  std::size_t steps_ = 0;
};

}  // namespace sqlite

/// Returns whether the system is at fault, or another process, and not the content of the file.
inline bool is_of_system(int code) {
  constexpr int known[] = {SQLITE_PERM,  SQLITE_BUSY, SQLITE_LOCKED,   SQLITE_NOMEM,   SQLITE_READONLY,
                           SQLITE_IOERR, SQLITE_FULL, SQLITE_CANTOPEN, SQLITE_PROTOCOL};
  return std::ranges::find(known, code & 0xff) != std::end(known);
}

/// Returns the result of `work`. The errors of SQLite do not name the file, so this adds it.
template <class Work>
auto naming(const std::string& file, Work work) {
  try {
    return work();
  } catch (const SQLite::Exception& error) {
    const int code = error.getErrorCode();
    const bool interrupted = code == SQLITE_INTERRUPT;
    const std::string what = file + ": " + (interrupted ? sqlite::Work::excess : error.what());
    if (code >= 0 && is_of_system(code)) throw std::runtime_error(what);
    throw InputError(what);
  }
}

/// A statement that may be run many times.
class Query {
 public:
  Query(SQLite::Database& database, sqlite::Work& work, const std::string& sql)
      : work_(work), statement_(database, sql) {}

  /// Runs it with these values for its question marks; a record gives all its columns.
  template <class... Values>
  void run(const Values&... values) {
    bind(values...);
    statement_.exec();
  }
  template <class Row, class... Values>
  std::vector<Row> rows(const Values&... values) {
    bind(values...);
    std::vector<Row> all;
    for (sqlite::Row row{statement_}; statement_.executeStep(); work_.check_text(row.bytes)) {
      int at = 0;
      sqlite::read(row, at, all.emplace_back());
    }
    return all;
  }

 private:
  template <class... Values>
  void bind(const Values&... values) {
    work_.begin();
    statement_.reset();
    statement_.clearBindings();
    [[maybe_unused]] int at = 1;
    (sqlite::write(statement_, at, values), ...);
  }
  sqlite::Work& work_;
  SQLite::Statement statement_;
};

/// Returns the name. A rollback journal may end in the name of a super-journal, which SQLite deletes once it
/// has played the journal back; ours name none, since no database is ever attached.
inline std::string own_file(const std::string& name) {
  namespace fs = std::filesystem;
  const std::string journal = name + "-journal";
  for (const std::string& file : {name, journal})
    if (fs::is_symlink(fs::symlink_status(file)))
      throw std::runtime_error(file + " is a symbolic link; a run holds its own files");
  constexpr std::string_view magic("\xd9\xd5\x05\xf9\x20\xa1\x63\xd7", 8);
  const std::string bytes = read_file(journal);
  if (bytes.size() > magic.size() && bytes.ends_with(magic))
    throw std::runtime_error(journal + " names another file, which SQLite would delete; remove the journal");
  return name;
}

class SqliteFile {
 public:
  /// Throws std::runtime_error if the file is a symbolic link, or if a journal beside it would have SQLite
  /// delete another file: a stranger may have made the folder.
  SqliteFile(const std::string& name, int flags)
      : name_(own_file(name)),
        database_(naming(name, [&] { return SQLite::Database(name, flags, busy_cap); })) {
    sqlite3* handle = database_.getHandle();
    sqlite3_limit(handle, SQLITE_LIMIT_LENGTH, value_cap);
    sqlite3_limit(handle, SQLITE_LIMIT_SQL_LENGTH, sql_cap);
    sqlite3_limit(handle, SQLITE_LIMIT_ATTACHED, 0);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    for (const int off :
         {SQLITE_DBCONFIG_TRUSTED_SCHEMA, SQLITE_DBCONFIG_ENABLE_TRIGGER, SQLITE_DBCONFIG_ENABLE_VIEW})
      sqlite3_db_config(handle, off, 0, nullptr);
    sqlite3_progress_handler(
        handle, sqlite::Work::steps_between,
        [](void* work) -> int { return static_cast<sqlite::Work*>(work)->is_too_much(); }, &work_);
    script("PRAGMA cell_size_check=ON");
  }
  SqliteFile(const SqliteFile&) = delete;
  SqliteFile& operator=(const SqliteFile&) = delete;

  const std::string& name() const { return name_; }
  bool is_empty() const { return schema().empty(); }
  /// Throws InputError unless the tables, indices and views are those that `tables`, a script, makes, and
  /// then lets the views answer. With `others`, other tables may be there too.
  void check_schema(const std::string& tables, bool others = false) {
    SqliteFile made(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    made.script(tables);
    std::vector<SchemaEntry> wanted = made.schema();
    for (const SchemaEntry& entry : schema()) {
      const bool known = std::erase(wanted, entry) > 0;
      const bool runs = entry.type != "table" && entry.type != "index";
      if (!known && (!others || runs || made.has(entry.table)))
        throw InputError(
            fmt::format("{}: its {} '{}' is none that this build writes: another build or a "
                        "stranger made the file",
                        name_, entry.type, entry.name));
    }
    if (!wanted.empty())
      throw InputError(fmt::format("{}: its {} '{}' is missing", name_, wanted[0].type, wanted[0].name));
    sqlite3_db_config(database_.getHandle(), SQLITE_DBCONFIG_ENABLE_VIEW, 1, nullptr);
  }
  /// Runs statements without values.
  void script(const std::string& sql) {
    work_.begin();
    naming(name_, [&] { database_.exec(sql); });
  }
  /// Committed data survives the death of the process.
  void write_ahead() { script("PRAGMA journal_mode=WAL; PRAGMA synchronous=NORMAL"); }

  template <class... Values>
  void run(const std::string& sql, const Values&... values) {
    naming(name_, [&] { query(sql).run(values...); });
  }
  template <class Row, class... Values>
  std::vector<Row> rows(const std::string& sql, const Values&... values) const {
    return naming(name_, [&] { return Query(database_, work_, sql).rows<Row>(values...); });
  }
  /// The rows of the record's table.
  template <class Row>
  std::vector<Row> all(const char* order) const {
    return rows<Row>(std::string("SELECT * FROM ") + Row::table + " ORDER BY " + order);
  }
  /// A statement that puts a record, or the values of its columns, into its table.
  template <class Row>
  Query insertion(const char* verb = "INSERT", const char* conflict = "") {
    std::string marks = "?";
    for (int i = 1; i < sqlite::Width<Row>::value; ++i) marks += ",?";
    return query(std::string(verb) + " INTO " + Row::table + " VALUES(" + marks + ")" + conflict);
  }
  Query query(const std::string& sql) { return {database_, work_, sql}; }
  /// Puts a record over the one with the same key.
  template <class Row>
  void replace(const Row& row) {
    naming(name_, [&] { insertion<Row>("INSERT OR REPLACE").run(row); });
  }
  /// Commits all of `work`, or nothing if it throws.
  template <class Work>
  void transaction(Work work) {
    naming(name_, [&] {
      SQLite::Transaction transaction(database_, SQLite::TransactionBehavior::IMMEDIATE);
      work();
      transaction.commit();
    });
  }

 private:
  /// Milliseconds to wait for another process that reads or writes the same file.
  static constexpr int busy_cap = 10000;
  /// Bytes of the largest value or row. The causes of a triage are the largest value, some megabytes.
  static constexpr int value_cap = 64 << 20;
  /// Bytes of the longest statement, also of a table in the file. Ours have less than 1000.
  static constexpr int sql_cap = 100'000;

  struct SchemaEntry {
    std::string type, name, table, sql;

    bool operator==(const SchemaEntry&) const = default;
    static auto columns(auto& e) { return std::tie(e.type, e.name, e.table, e.sql); }
  };
  std::vector<SchemaEntry> schema() const {
    return rows<SchemaEntry>("SELECT type, name, tbl_name, sql FROM sqlite_master ORDER BY type DESC, name");
  }
  bool has(const std::string& table) const {
    return std::ranges::any_of(schema(), [&](const SchemaEntry& e) { return e.name == table; });
  }

  std::string name_;
  mutable sqlite::Work work_{name_};
  mutable SQLite::Database database_;  ///< a reading statement wants it, too
};

}  // namespace cyl
