// SPDX-License-Identifier: MIT
// The failures of a gate and what it asked as one JSON document, which a later gate reads back.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "props/gate/gate.hpp"
#include "reports/gate/judged_gate.hpp"

namespace cyl {

/// Returns fields of the report under their own names. Pairs are written as in the case files. Numbers that
/// JSON does not have are the strings "nan", "inf", "-inf".
std::string gate_json(const JudgedGate& gate);

/// The base that a gate is compared with.
struct GateBase {
  std::uint64_t seed = 1;
  std::uint64_t pairs = 0;  ///< that were to be drawn
  GateAmount amount;        ///< what was drawn
  std::vector<std::string> methods;
  std::vector<int> laws;
  std::vector<std::string> cases;               ///< digests
  std::map<GatePhase, std::string> digests;     ///< of the pairs of each phase that draws
  std::map<std::string, std::uint64_t> causes;  ///< of failures beyond claims, and on how many pairs
};

/// Reads what gate_json() wrote to `file`. Throws std::runtime_error naming the file, what is wrong with it
/// and the remedy.
GateBase read_base(const std::string& file);

/// Adds to what was not asked: methods, laws, cases and drawn pairs of the base that are none of the
/// report's. If all was asked, adds a remark on the failures of the base that are gone.
void note_gaps(JudgedGate& gate, const GateBase& base);

/// Marks the failures whose cause is in the base as known. It does not mark a cause that has more pairs
/// now, unless chance or a slower machine explains it: a hang, or a failure that is not deterministic. A
/// failure of the base within the claim excuses nothing.
void mark_known(JudgedGate& gate, const GateBase& base);

}  // namespace cyl
