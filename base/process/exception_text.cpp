// SPDX-License-Identifier: MIT
#include "base/process/exception_text.hpp"

#include <algorithm>
#include <regex>
#include <vector>

namespace cyl {
namespace {

using Lines = std::vector<std::string>;

/// The bytes of a line that are searched.
constexpr std::size_t line_cap = 1000;

Lines lines_of(std::string_view text) {
  Lines lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    lines.emplace_back(text.substr(at, std::min(end - at, line_cap)));
    at = end + 1;
  }
  return lines;
}

/// Returns the line of the exception. In a traceback of Python, that is the first line that is not indented.
/// In the output of node, it is a line like "RangeError: ..".
std::size_t exception_line(const Lines& lines) {
  static const std::regex error(R"((Uncaught )?[\w.$]*(Error|Exception)( \[\w+\])?(:.*)?)");
  bool traceback = false;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (std::regex_match(lines[i], error)) return i;
    if (traceback && !lines[i].empty() && lines[i][0] != ' ') return i;
    traceback = traceback || lines[i].starts_with("Traceback (most recent call last)");
  }
  return lines.size();
}

/// Returns a place like "mine.py:12". For Python, it is the last file named before the exception. For node,
/// it is the first line of all, or the first after the exception.
std::string place_of(const Lines& lines, std::size_t exception) {
  static const std::regex python(R"re( *File "(?:.*/)?([^"/]+)", line (\d+).*)re"),
      node(R"((?:.*[/\\( ])?([\w.-]+\.\w+:\d+)(?::\d+)?\)?)");
  std::smatch found;
  for (std::size_t i = exception; i-- > 0;)
    if (std::regex_match(lines[i], found, python)) return found.str(1) + ':' + found.str(2);
  if (exception > 0 && std::regex_match(lines[0], found, node)) return found.str(1);
  for (std::size_t i = exception + 1; i < lines.size(); ++i)
    if (lines[i].starts_with("    at ") && std::regex_match(lines[i], found, node)) return found.str(1);
  return {};
}

}  // namespace

std::string exception_text(std::string_view printed, std::size_t cap) {
  const Lines lines = lines_of(printed);
  const std::size_t at = exception_line(lines);
  if (at == lines.size()) return {};
  std::string place = place_of(lines, at);
  if (!place.empty()) place = " (" + place + ')';
  if (place.size() > cap / 2) place.clear();
  return lines[at].substr(0, cap - place.size()) + place;
}

}  // namespace cyl
