// SPDX-License-Identifier: MIT
// What every writer of the gate's result says in the same words: the law, the place, the luck, the replay.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "props/gate/gate.hpp"

namespace cyl {

/// Whether the method broke more than its own claim allows.
bool is_error(const GateFailure& failure);
/// An error that the base of --against does not have.
bool fails_gate(const GateFailure& failure);
/// Found while a kept case was held to some law: `origin` is "FILE:LINE id".
bool is_from_case(const GateFailure& failure);

/// Failures of one method, law and kind, in different buckets: told together.
using Alike = std::vector<const GateFailure*>;
/// Those that fail the gate, or all others (known ones apart), in the order of the first of each.
std::vector<Alike> alike_failures(const GateReport& report, bool failing);
std::uint64_t pairs_of(const Alike& alike);

struct SourceLine {
  std::string file;   ///< from the current folder where it lies below it, else as it was given
  unsigned line = 1;  ///< from 1
};
/// The line of the case, else that of the law.
SourceLine place_of(const GateFailure& failure);

std::string law_title(const Law& law);  ///< "law 10 growth"
/// Whether a break shows in the answer to the pair itself, so that no law need be named to see it again.
bool is_told_by_answer(const Law& law);
/// "fails 10 of 10 times", or "depends on luck: 3 of 10"; empty where it was not run again.
std::string luck_in_words(const GateFailure& failure);
/// A line for a shell: asks the method the simplest pair, beside what is true, and holds it to the law.
std::string replay_command(const GateFailure& failure);
/// 1234567 as 1,234,567.
std::string grouped(std::uint64_t n);
/// "1 pair", "17 pairs".
std::string pairs_in_words(std::uint64_t n);

/// Each byte that is no UTF-8 becomes U+FFFD.
std::string valid_utf8(std::string_view text);
/// `text` as one line of valid UTF-8 that steers no terminal.
std::string one_line(std::string_view text);

}  // namespace cyl
