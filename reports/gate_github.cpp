// SPDX-License-Identifier: MIT
#include "reports/gate_github.hpp"

#include <fmt/format.h>

#include <string_view>

#include "reports/gate_words.hpp"

namespace cyl {
namespace {

/// Each character of `special` as the percent sign and its two hexadecimal digits.
std::string escaped(std::string_view text, std::string_view special) {
  std::string safe;
  for (const char c : text) {
    if (special.find(c) == std::string_view::npos) {
      safe += c;
    } else {
      safe += fmt::format("%{:02X}", static_cast<unsigned>(c));
    }
  }
  return safe;
}

std::string message(std::string_view text) { return escaped(text, "%\r\n"); }
std::string property(std::string_view text) { return escaped(text, "%\r\n:,"); }

std::string annotation(const char* command, const GateFailure& f) {
  const SourceLine place = place_of(f);
  std::string text = fmt::format("{}\n{}, the first: {}\nbucket: {}", one_line(f.what),
                                 pairs_in_words(f.count), one_line(f.origin), one_line(f.bucket));
  if (const std::string luck = luck_in_words(f); !luck.empty()) text += '\n' + luck;
  if (f.known) text += "\nknown: the base has it";
  text += '\n' + replay_command(f);
  return fmt::format("::{} file={},line={},title={}::{}\n", command, property(one_line(place.file)),
                     place.line, property(fmt::format("{} breaks {}", one_line(f.method), law_title(*f.law))),
                     message(text));
}

std::string annotations(const GateReport& report, bool errors) {
  std::string text;
  std::size_t count = 0;
  for (const GateFailure& f : report.failures) {
    if (fails_gate(f) != errors) continue;
    if (++count <= annotations_cap) text += annotation(errors ? "error" : "notice", f);
  }
  if (count > annotations_cap) {
    text += fmt::format("::notice title=daylight gate::{} more {} not shown here\n",
                        grouped(count - annotations_cap),
                        errors ? "that fail the gate are" : "within claims or known are");
  }
  return text;
}

}  // namespace

std::string gate_github(const GateReport& report) {
  return annotations(report, true) + annotations(report, false);
}

}  // namespace cyl
