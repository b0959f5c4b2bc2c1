// SPDX-License-Identifier: MIT
#include "cli/known_guests.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace cyl {
namespace {

namespace fs = std::filesystem;

/// Returns the file of known guests. Empty if the system names no place for it.
fs::path record_file() {
  if (const char* state = std::getenv("XDG_STATE_HOME"); state && fs::path(state).is_absolute())
    return fs::path(state) / "daylight/guests";
  if (const char* home = std::getenv("HOME"); home && fs::path(home).is_absolute())
    return fs::path(home) / ".local/state/daylight/guests";
  return {};
}

/// Returns what starts a program, as one line.
std::string line_of(const Guest& guest) {
  return format_guests({{guest.kind, "", guest.what, guest.folder}});
}

}  // namespace

std::string record_guests(const std::vector<Guest>& guests) {
  const fs::path file = record_file();
  std::string lines;
  for (const Guest& guest : guests)
    if (!is_recorded(guest)) lines += line_of(guest);
  if (lines.empty()) return {};
  if (file.empty()) return "neither XDG_STATE_HOME nor HOME names a folder";
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  const int at = open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
  const bool written = at >= 0 && write(at, lines.data(), lines.size()) == static_cast<ssize_t>(lines.size());
  const int code = errno;
  if (at >= 0) close(at);
  return written ? "" : fmt::format("{}: {}", file.string(), std::strerror(code));
}

bool is_recorded(const Guest& guest) {
  if (has_control_character(guest.what + guest.folder)) return false;
  std::ifstream file(record_file());
  const std::string wanted = line_of(guest);
  for (std::string line; std::getline(file, line);)
    if (line + '\n' == wanted) return true;
  return false;
}

}  // namespace cyl
