// SPDX-License-Identifier: MIT
// A failure of the gate in the words that every writer of its result uses.
#pragma once

#include <string>
#include <vector>

#include "reports/gate/judged_gate.hpp"

namespace cyl {

/// Whether it was found while a kept case was held to some law: `origin` is "FILE:LINE id".
bool is_from_case(const JudgedFailure& failure);

/// Failures of one method, law and kind, in different causes, which are shown together. Failures of the
/// method itself with one kind and reason are shown together for all laws. Failures on a
/// pair that no law had changed come first, then those that the base lacks, then the worst.
using Alike = std::vector<const JudgedFailure*>;
/// Returns those that fail the gate, or all others (known ones apart), in the order of the first of each.
std::vector<Alike> alike_failures(const JudgedGate& gate, bool failing);

/// A failure in words: each is one line of valid UTF-8 that steers no terminal.
struct FailureView {
  std::string method;
  std::string law;  ///< "law 10 growth"
  std::string what;
  std::string pairs;  ///< "17 pairs"
  std::string origin, cause;
  std::string again;            ///< "fails 10 of 10 times", ..; empty if it was not run again
  std::string found, simplest;  ///< pairs as JSON
  std::string replay;           ///< for a shell: asks the method the simplest pair, and holds it to the law
};
FailureView view_of(const JudgedFailure& failure);
FailureView view_of(const Alike& alike);  ///< the first of them, with the pairs of all

std::string law_title(const Law& law);  ///< "law 10 growth"

}  // namespace cyl
