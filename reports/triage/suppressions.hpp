// SPDX-License-Identifier: MIT
// Known causes that are shown but do not fail a run or a gate. One JSON object a line:
//
//   {"cause":"fcl-libccd/absolute-length","reason":"...","link":"https://...","owner":"...","expires":"2027-01-31"}
//
// Every field is a required string. No other field is allowed. A cause has one line.
//
// Triage compares them with causes, the gate with its failures, and both with the stored cases.
#pragma once

#include <cstddef>
#include <istream>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "corpus/store/case_files.hpp"
#include "oracles/methods/method.hpp"
#include "oracles/trial/mechanism.hpp"
#include "reports/gate/judged_gate.hpp"

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

/// Returns the causes, by cause_key(), of what methods get wrong on the cases; contained. Asks only methods
/// of libraries that a suppression names, because the causes of others do not matter. Cost: up to some
/// seconds for each of these.
std::set<std::string> causes_of(const GroupedMethods& of, std::span<const Case> cases,
                                const std::vector<Suppression>& suppressions);

/// Marks a failure of a gate as known if its cause is suppressed, or the cause of each answer beyond the
/// claim that its law compares. Such answers explain no failure of a law that repeats a question. Cost: up to
/// some tenths of a second for a law of several answers. Adds the remarks on suppressions. `methods` holds
/// the methods of this build and the guests, because a key does not depend on which of them the gate tests.
void judge_suppressions(JudgedGate& gate, std::span<const std::unique_ptr<Method>> methods,
                        std::span<const Case> cases, const std::vector<Suppression>& suppressions,
                        std::string_view today);

/// Returns a remark for each suppression that has expired. Returns one that fails the gate for each
/// suppression whose cause is not in `causes`, those of the stored cases.
std::vector<GateRemark> suppression_remarks(const std::vector<Suppression>& suppressions,
                                            std::string_view today, const std::set<std::string>& causes);

}  // namespace cyl
