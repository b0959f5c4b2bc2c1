// SPDX-License-Identifier: MIT
// Text from anywhere, made safe to show in a line or to paste into a shell.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

namespace cyl {

/// The character that reorders what is shown around it (U+202A..202E, U+2066..2069) and that begins `text` as
/// UTF-8, or 0. It takes three bytes.
inline unsigned leading_bidi_control(std::string_view text) {
  if (text.size() < 3 || text[0] != '\xe2') return 0;
  const unsigned last = static_cast<unsigned char>(text[2]);
  if (text[1] == '\x80' && last >= 0xaa && last <= 0xae) return 0x2000 + (last & 0x3f);
  if (text[1] == '\x81' && last >= 0xa6 && last <= 0xa9) return 0x2040 + (last & 0x3f);
  return 0;
}

/// As JSON has it: \u202e.
inline std::string escaped_code(unsigned code) {
  char escaped[8];
  std::snprintf(escaped, sizeof escaped, "\\u%04x", code & 0xffffu);
  return escaped;
}

/// `text` with each character escaped that could begin a line, steer a terminal or reorder what is shown:
/// \n, \t, \r, else as escaped_code() has it. Backslashes stay as they are: this is to be read, not parsed.
/// Text that was escaped before stays the same, and JSON on one line keeps its meaning. The characters in
/// `kept` stay too.
inline std::string escaped_controls(std::string_view text, std::string_view kept = "") {
  // Most texts are long and need nothing: only these bytes can begin what is escaped.
  const auto may_need = [](unsigned char byte) {
    return byte < 0x20 || byte == 0x7f || byte == 0xc2 || byte == 0xe2;
  };
  std::size_t i = 0;
  while (i < text.size() && !may_need(static_cast<unsigned char>(text[i]))) ++i;
  std::string safe(text.substr(0, i));
  safe.reserve(text.size());
  for (; i < text.size(); ++i) {
    const unsigned byte = static_cast<unsigned char>(text[i]);
    const unsigned next = i + 1 < text.size() ? static_cast<unsigned char>(text[i + 1]) : 0;
    if (kept.find(text[i]) != std::string_view::npos) {
      safe += text[i];
    } else if (byte == '\n' || byte == '\t' || byte == '\r') {
      safe += byte == '\n' ? "\\n" : byte == '\t' ? "\\t" : "\\r";
    } else if (byte < 0x20 || byte == 0x7f) {
      safe += escaped_code(byte);
    } else if (byte == 0xc2 && next >= 0x80 && next <= 0x9f) {  // the other controls of Latin-1
      safe += escaped_code(next);
      ++i;
    } else if (const unsigned control = leading_bidi_control(text.substr(i))) {
      safe += escaped_code(control);
      i += 2;
    } else {
      safe += text[i];
    }
  }
  return safe;
}

/// Text of several lines, or of parts that tabs separate.
struct Lines {
  std::string text;
};

/// `text` as one word of a POSIX shell.
inline std::string shell_quoted(std::string_view text) {
  constexpr std::string_view plain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_./:-";
  if (!text.empty() && text.find_first_not_of(plain) == std::string_view::npos) return std::string(text);
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? "'\\''" : std::string(1, c);
  return word + '\'';
}

/// Returns `text` with U+FFFD for each byte that is not UTF-8.
std::string valid_utf8(std::string_view text);

/// Returns `text` as one line of valid UTF-8 that steers no terminal.
std::string one_line(std::string_view text);

/// Returns 1234567 as 1,234,567.
std::string grouped(std::uint64_t n);

/// Returns "1 pair", "1,234 pairs" or "2 boxes".
std::string counted(std::uint64_t n, std::string_view thing);

}  // namespace cyl
