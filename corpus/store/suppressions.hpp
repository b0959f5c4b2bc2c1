// SPDX-License-Identifier: MIT
// Known causes that are shown but do not fail a run or a gate. One JSON object a line:
//
//   {"bucket":"fcl-libccd/absolute-length","reason":"...","link":"https://...","owner":"...","expires":"2027-01-31"}
//
// Every field is a required string. No other field is allowed. A cause has one line.
#pragma once

#include <cstddef>
#include <istream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cyl {

struct Suppression {
  std::string cause, reason, link, owner;
  std::string expires;   ///< YYYY-MM-DD, the last day on which it holds
  std::size_t line = 0;  ///< from 1
};

/// Throws std::invalid_argument "line 3, column 17: ..." at the first bad line; columns count bytes from 1.
std::vector<Suppression> read_suppressions(std::istream& in);
/// Reads the given file, else the usual one, which may be absent. An empty name means none. Throws UsageError
/// if the given file does not exist, or with the file's name before the text above.
std::vector<Suppression> read_suppressions(const std::optional<std::string>& given, const std::string& usual);

/// Returns the line that it is read from.
std::string line_of(const Suppression& suppression);

/// Whether it holds no more on a day, YYYY-MM-DD.
bool is_expired(const Suppression& suppression, std::string_view today);

/// Returns the suppression of a cause that is valid on a day, or nullptr.
const Suppression* find_suppression(const std::vector<Suppression>& suppressions, std::string_view cause,
                                    std::string_view today);

}  // namespace cyl
