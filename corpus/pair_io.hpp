// SPDX-License-Identifier: MIT
// The one reader and writer of pairs and answers as JSON Lines. One line in, one record out, in order; a malformed
// line becomes a record with an error and costs nothing after it.
#pragma once

#include <array>
#include <cstddef>
#include <istream>
#include <optional>
#include <string>
#include <string_view>

#include "solver/cylinder.hpp"

namespace cyl {

/// A pair with where it comes from. Optional fields are empty where the line has none.
struct Case {
  Pair pair;
  std::string id;
  std::string source;
  std::optional<Verdict> truth;  ///< what the line says is true
  std::string note;
};

/// What one line held: a case, or an error text "line 3, column 17: a.radius is negative (-1)".
struct CaseLine {
  std::size_t line = 0;  ///< 1-based line number in its file
  std::optional<Case> value;
  std::string error;  ///< empty iff value is set
};

/// Reads one non-blank line at a time. Never throws on content.
class CaseReader {
 public:
  explicit CaseReader(std::istream& in) : in_(in) {}
  /// The next non-blank line, or nothing at the end of the stream.
  std::optional<CaseLine> next();

 private:
  std::istream& in_;
  std::size_t line_ = 0;
};

/// Parses one line (without its newline); `line` is only used in error texts.
CaseLine parse_case(std::string_view text, std::size_t line);

/// One line without newline, numbers in the shortest decimals that read back to the same double.
std::string format_case(const Case& c);
std::string format_pair(const Pair& p);  ///< {"a":{...},"b":{...}}
/// Shortest round-trip decimals of a double, by std::to_chars ("0.1", "1e-300", "-0").
std::string format_double(double x);
/// A JSON string literal with quotes; invalid UTF-8 becomes U+FFFD.
std::string quote_json(std::string_view text);

}  // namespace cyl
