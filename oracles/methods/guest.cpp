// SPDX-License-Identifier: MIT
#include "oracles/methods/guest.hpp"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "base/fnv.hpp"
#include "base/safe_text.hpp"
#include "base/usage_error.hpp"
#include "corpus/pairs/pair_io.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;

/// The cap on the bytes of a name, for which the tables have room.
constexpr std::size_t name_cap = 40;

constexpr char separator = '\t';  // of the fields that format_guests writes. No guest contains it

bool is_letter_or_digit(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

/// Letters and digits, and after the first one also - _ and dots. Lists of names and options stay readable.
bool will_do(std::string_view name) {
  return !name.empty() && name.size() <= name_cap && is_letter_or_digit(name[0]) &&
         std::all_of(name.begin(), name.end(),
                     [](char c) { return is_letter_or_digit(c) || c == '-' || c == '_' || c == '.'; });
}

void check_name(const std::string& name) {
  if (will_do(name)) return;
  throw UsageError("'" + name + "' is no name for a method: it takes at most " + std::to_string(name_cap) +
                   " letters, digits, - _ and dots");
}

/// If `text` begins with a name and '=', returns the length before '='. The name may contain ':' and the
/// name of a method of its library. Otherwise returns 0, as for FOO=1, a variable of the shell.
std::size_t given_name(std::string_view text) {
  const std::size_t equals = text.find('=');
  if (equals == text.npos || text.empty() || text[0] < 'a' || text[0] > 'z') return 0;
  const std::string_view name = text.substr(0, equals);
  const std::size_t colon = std::min(name.find(':'), name.size());
  if (colon < name.size() && !will_do(name.substr(colon + 1))) return 0;
  return will_do(name.substr(0, colon)) ? equals : 0;
}

const char* option_of(GuestKind kind) { return kind == GuestKind::plugin ? "--plugin" : "--command"; }

}  // namespace

bool has_control_character(std::string_view text) {
  return std::ranges::any_of(text, [](char c) { return std::iscntrl(static_cast<unsigned char>(c)) != 0; });
}

Guest read_guest(GuestKind kind, const std::string& text) {
  if (has_control_character(text))
    throw UsageError(std::string(option_of(kind)) + " has a control character in it");
  const std::size_t name = given_name(text);
  Guest guest{kind, text.substr(0, name), text.substr(name == 0 ? 0 : name + 1), {}};
  if (const std::size_t colon = guest.name.find(':'); colon != guest.name.npos) {
    guest.method = guest.name.substr(colon + 1);
    guest.name.resize(colon);
  }
  if (guest.what.find_first_not_of(' ') == guest.what.npos)
    throw UsageError(std::string(option_of(kind)) + " names nothing");
  if (kind == GuestKind::plugin) {
    guest.what = fs::absolute(guest.what).lexically_normal().string();
  } else {
    guest.folder = fs::current_path().string();
  }
  if (has_control_character(guest.what + guest.folder))
    throw UsageError(std::string(option_of(kind)) +
                     ": the name of this folder has a control character in it");
  return guest;
}

std::string options_for(const Guest& guest) {
  const std::string of = guest.method.empty() ? "" : ':' + guest.method;
  const std::string claim = guest.claim ? " --claim " + guest.name + '=' + format_double(*guest.claim) : "";
  const std::string word = guest.name + of + '=' + guest.what;  // a name needs no quotes
  return option_of(guest.kind) +
         (' ' + (shell_quoted(guest.what) == guest.what ? word : shell_quoted(word))) + claim;
}

std::string format_guests(const std::vector<Guest>& guests) {
  std::string text;
  for (const Guest& guest : guests) {
    const bool plugin = guest.kind == GuestKind::plugin;
    text += plugin ? "plugin" : "command";
    if (guest.claim) text += ' ' + format_double(*guest.claim);
    for (const std::string* part : {&guest.name, plugin ? &guest.method : &guest.folder, &guest.what})
      (text += separator) += *part;
    text += '\n';
  }
  return text;
}

std::vector<Guest> parse_guests(std::string_view text) {
  std::vector<Guest> guests;
  while (!text.empty()) {
    std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    std::vector<std::string> parts;
    while (parts.size() < 3 && line.find(separator) != line.npos) {
      parts.emplace_back(line.substr(0, line.find(separator)));
      line.remove_prefix(parts.back().size() + 1);
    }
    const std::string kind = parts.empty() ? "" : parts[0].substr(0, parts[0].find(' '));
    if (parts.size() != 3 || (kind != "plugin" && kind != "command"))
      throw std::runtime_error("'" + std::string(line) + "' names no guest");
    const bool plugin = kind == "plugin";
    Guest guest{plugin ? GuestKind::plugin : GuestKind::command, parts[1], std::string(line),
                plugin ? "" : parts[2], plugin ? parts[2] : ""};
    if (kind.size() < parts[0].size()) guest.claim = std::strtod(parts[0].c_str() + kind.size(), nullptr);
    guests.push_back(std::move(guest));
  }
  return guests;
}

std::string fingerprint(std::span<const std::string> files) {
  std::uint64_t hash = fnv1a("");
  for (const std::string& file : files) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream bytes;
    bytes << in.rdbuf();
    hash = fnv1a(bytes.str(), hash);
  }
  char digits[24];
  std::snprintf(digits, sizeof digits, "%08x", static_cast<unsigned>(hash));
  return digits;
}

std::vector<OpenedGuest> open_guest(const Guest& guest) {
  try {
    std::vector<OpenedGuest> opened;
    if (guest.kind == GuestKind::plugin)
      opened = open_plugins(guest);
    else
      opened.push_back(open_command(guest));
    for (const OpenedGuest& each : opened) check_name(each.guest.name);
    return opened;
  } catch (const std::exception& error) {
    throw std::runtime_error(std::string(option_of(guest.kind)) + " '" + guest.what + "': " + error.what());
  }
}

}  // namespace cyl
