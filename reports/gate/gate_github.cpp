// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "base/safe_text.hpp"
#include "reports/gate/failure_text.hpp"
#include "reports/gate/gate_writers.hpp"

namespace cyl {
namespace {

/// Replaces each character of `special` with the percent sign and its two hexadecimal digits.
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

std::string annotation(const Alike& alike) {
  const FailureView f = view_of(alike);
  const std::string place =
      f.place ? fmt::format("file={},line={},", property(one_line(f.place->file)), f.place->line) : "";
  return fmt::format("::error {}title={}::{}\n", place,
                     property(fmt::format("{} breaks {}", f.method, f.law)),
                     message(fmt::format("{}\n{}, the first: {}\ncause: {}{}{}\n{}", f.what, f.pairs,
                                         f.origin, f.cause, f.again.empty() ? "" : "\n", f.again, f.replay)));
}

}  // namespace

std::string gate_github(const JudgedGate& gate) {
  const std::vector<Alike> failing = alike_failures(gate, true);
  std::string text;
  for (std::size_t i = 0; i < std::min(annotations_cap, failing.size()); ++i) text += annotation(failing[i]);
  if (failing.size() > annotations_cap)
    text += fmt::format("::notice title=daylight gate::{} more that fail the gate are not shown here\n",
                        grouped(failing.size() - annotations_cap));
  for (const std::string& line : gate.not_asked)
    text += fmt::format("::warning title=daylight gate, not asked::{}\n", message(one_line(line)));
  for (const GateRemark& r : gate.remarks)
    text += fmt::format("::{} title=daylight gate::{}\n",
                        r.exit_code == exit_findings    ? "error"
                        : r.exit_code == exit_undecided ? "warning"
                                                        : "notice",
                        message(one_line(r.text)));
  return text;
}

}  // namespace cyl
