// SPDX-License-Identifier: MIT
// The one reader and writer of pairs as JSON Lines. One line in, one record out, in order. A malformed line
// becomes a record with an error, and the lines after it are read as usual.
//
//   {"a":{"center":[0,0,0],"axis":[0,0,1],"radius":1,"height":2},"b":{...},"id":"...","truth":"disjoint"}
//
// 1. A cylinder has these four fields, and may have "rounding", which is 0 by default. Other solids name
//    their shape: {"shape":"sphere","center","radius"},
//    {"shape":"capsule","center","axis","radius","height"},
//    {"shape":"half_space","point","normal"} and {"shape":"box","center","edges","quaternion"}. The
//    quaternion [w,x,y,z] of a box is 1,0,0,0 by default, and its "rounding" is 0. "quaternion" may replace
//    an axis, which is then computed in doubles.
// 2. A line may also have the strings id, source, truth (a verdict) and note. Other keys of any type are
//    skipped, but a key within one edit of source, truth or note is an error.
// 3. Every number is read as the nearest double, with the sign of zero. Integers beyond 2^53 are rounded like
//    any other number.
// 4. A number that overflows is an error, in any field. In a cylinder, a nonzero number that rounds to 0,
//    such as 1e-999, is an error too.
#pragma once

#include <cstddef>
#include <istream>
#include <optional>
#include <string>
#include <string_view>

#include "solver/solid.hpp"

namespace cyl {

/// A pair with its origin. An optional field is empty if the line does not have it.
struct Case {
  Pair pair;
  std::string id;
  std::string source;
  std::optional<Verdict> truth;  ///< the truth that the line states
  std::string note;
  std::string file{};    ///< the file, if read_case_folder read it; else empty
  std::size_t line = 0;  ///< of that file, from 1
};

/// The most bytes of a line that are read; a longer line is an error.
inline constexpr std::size_t line_cap = std::size_t{1} << 20;

/// The result of one line: a case, or an error text "line 3, column 17: a.radius is negative (-1)". Columns
/// count bytes from 1, without a byte order mark.
struct CaseLine {
  std::size_t line = 0;  ///< 1-based line number in its file
  std::optional<Case> value;
  std::string error;  ///< empty iff value is set
};

/// Reads one non-blank line at a time; lines may end in \n or \r\n, and the first may begin with a byte order
/// mark. Never throws on content.
class LineReader {
 public:
  explicit LineReader(std::istream& in) : in_(in), buffer_(line_cap + 2, '\0') {}
  /// Returns whether there is another line. If not, the stream has ended or cannot be read (then in.bad()).
  bool next();
  std::string_view text() const { return text_; }  ///< cut after line_cap + 1 bytes
  std::size_t line() const { return line_; }       ///< from 1

 private:
  std::istream& in_;
  std::string buffer_;  ///< one line, its \r and a terminating zero
  std::string_view text_;
  std::size_t line_ = 0;
};

/// Reads the cases of a stream, a line each.
class CaseReader {
 public:
  explicit CaseReader(std::istream& in) : lines_(in) {}
  /// Returns the next line, or nothing if there is none.
  std::optional<CaseLine> next();

 private:
  LineReader lines_;
};

/// Parses one line (without its newline); `line` is only used in error texts.
CaseLine parse_case(std::string_view text, std::size_t line);

/// One line without newline, numbers in the shortest decimals that read back to the same double. Empty
/// optional fields are left out.
std::string format_case(const Case& c);
std::string format_pair(const Pair& p);  ///< {"a":{...},"b":{...}}
/// Returns the shortest decimals that read back as the double, by std::to_chars ("0.1", "1e-300", "-0"). Also
/// returns "nan", "inf" and "-inf", which are not JSON.
std::string format_double(double x);
/// Returns the same as JSON. A number that JSON does not have becomes a string, which the reader of pairs
/// rejects.
std::string format_number(double x);
/// A JSON string literal with quotes; invalid UTF-8 becomes U+FFFD.
std::string quote_json(std::string_view text);

}  // namespace cyl
