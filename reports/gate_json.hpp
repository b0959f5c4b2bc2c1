// SPDX-License-Identifier: MIT
// The gate's result as one JSON document, complete; and what a later gate reads back of it.
#pragma once

#include <set>
#include <string>

#include "props/gate.hpp"

namespace cyl {

/// Every field of the report under its own name. Pairs are written as in the case files; numbers that are no
/// JSON are the strings "nan", "inf", "-inf".
std::string gate_json(const GateReport& report);

/// The buckets of the failures that gate_json() wrote to `file`. Throws std::runtime_error naming the file,
/// what is wrong with it and the remedy.
std::set<std::string> read_buckets(const std::string& file);

/// Marks the failures whose bucket is in `base`, and no others. One without a bucket is never known.
void mark_known(GateReport& report, const std::set<std::string>& base);

}  // namespace cyl
