// SPDX-License-Identifier: MIT
// The gate's result as one JSON document, complete; and what a later gate reads back of it.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <string>

#include "props/gate/gate.hpp"

namespace cyl {

/// Every field of the report under its own name. Pairs are written as in the case files; numbers that are no
/// JSON are the strings "nan", "inf", "-inf".
std::string gate_json(const GateReport& report);

/// What a gate is held against.
struct GateBase {
  std::uint64_t seed = 1;
  std::chrono::milliseconds budget{0};
  GateAmount amount;
  std::map<std::string, std::uint64_t> buckets;  ///< of failures beyond claims, and on how many pairs
};

/// Of what gate_json() wrote to `file`. Throws std::runtime_error naming the file, what is wrong with it and
/// the remedy.
GateBase read_base(const std::string& file);

/// Marks as known the failures whose bucket is in the base, but not those that are seen on more pairs now,
/// where that cannot be luck or a slower machine: a hang, or what does not fail each time.
void mark_known(GateReport& report, const GateBase& base);

}  // namespace cyl
