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
// 3. If the file cannot be read or written, a call throws std::runtime_error, which names the file.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <charconv>
#include <cstdint>
#include <filesystem>
#include <fstream>
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
#include "corpus/pairs/pair_io.hpp"
#include "corpus/store/cell_counts.hpp"

namespace cyl {

namespace sqlite {

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
void read(SQLite::Statement& row, int& at, std::optional<T>& value);

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
void read(SQLite::Statement& row, int& at, T& value) {
  if constexpr (Record<T>) {
    std::apply([&](auto&... member) { (read(row, at, member), ...); }, T::columns(value));
  } else if constexpr (std::is_integral_v<T>) {
    value = static_cast<T>(row.getColumn(at++).getInt64());
  } else {
    const std::string text = row.getColumn(at++).getString();
    if constexpr (std::is_same_v<T, double>) {
      std::from_chars(text.data(), text.data() + text.size(), value);
    } else if constexpr (std::is_same_v<T, std::vector<CellCounts>>) {
      value = parse_cell_counts(text);
    } else if constexpr (Worded<T>) {
      const std::optional<T> known = from_word<T>(text);
      if (!known) throw SQLite::Exception("'" + text + "' is not a word that this version writes");
      value = *known;
    } else {
      value = text;
    }
  }
}

template <class T>
void read(SQLite::Statement& row, int& at, std::optional<T>& value) {
  if (row.isColumnNull(at)) {
    at += Width<T>::value;
  } else {
    read(row, at, value.emplace());
  }
}

}  // namespace sqlite

/// Returns the result of `work`. The errors of SQLite do not name the file, so this adds it.
template <class Work>
auto naming(const std::string& file, Work work) {
  try {
    return work();
  } catch (const SQLite::Exception& error) {
    throw std::runtime_error(file + ": " + error.what());
  }
}

/// A statement that may be run many times.
class Query {
 public:
  Query(SQLite::Database& database, const std::string& sql) : statement_(database, sql) {}

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
    while (statement_.executeStep()) {
      int at = 0;
      sqlite::read(statement_, at, all.emplace_back());
    }
    return all;
  }

 private:
  template <class... Values>
  void bind(const Values&... values) {
    statement_.reset();
    statement_.clearBindings();
    [[maybe_unused]] int at = 1;
    (sqlite::write(statement_, at, values), ...);
  }
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
  std::ifstream in(journal, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
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
        database_(naming(name, [&] { return SQLite::Database(name, flags, busy_cap); })) {}

  const std::string& name() const { return name_; }
  bool has(const char* table) const {
    return naming(name_, [&] { return database_.tableExists(table); });
  }
  /// Runs statements without values.
  void script(const std::string& sql) {
    naming(name_, [&] { database_.exec(sql); });
  }
  /// Committed data survives the death of the process.
  void write_ahead() { script("PRAGMA journal_mode=WAL; PRAGMA synchronous=NORMAL"); }

  template <class... Values>
  void run(const std::string& sql, const Values&... values) {
    naming(name_, [&] { Query(database_, sql).run(values...); });
  }
  template <class Row, class... Values>
  std::vector<Row> rows(const std::string& sql, const Values&... values) const {
    return naming(name_, [&] { return Query(database_, sql).rows<Row>(values...); });
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
    return {database_, std::string(verb) + " INTO " + Row::table + " VALUES(" + marks + ")" + conflict};
  }
  Query query(const std::string& sql) { return {database_, sql}; }
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

  std::string name_;
  mutable SQLite::Database database_;  ///< a reading statement wants it, too
};

}  // namespace cyl
