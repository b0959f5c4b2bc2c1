// SPDX-License-Identifier: MIT
// A batch as bytes (CBOR), for its way from the process that made it to the one that stores it. Both are of
// one build: nothing keeps these bytes.
#pragma once

#include <string>
#include <string_view>

#include "corpus/store/run_store.hpp"

namespace cyl {

/// Returns all of a batch except first and next. In foreign texts, bytes that are not UTF-8 become U+FFFD.
std::string format_batch(const BatchRecord& batch);

/// Returns what format_batch() was given. Throws std::runtime_error on other bytes.
BatchRecord parse_batch(std::string_view bytes);

}  // namespace cyl
