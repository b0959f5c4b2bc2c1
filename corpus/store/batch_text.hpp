// SPDX-License-Identifier: MIT
// A batch as one text, for its way from the process that made it to the one that stores it.
#pragma once

#include <string>
#include <string_view>

#include "corpus/store/run_store.hpp"

namespace cyl {

/// Everything but first and next. Bytes that are no UTF-8 become U+FFFD.
std::string format_batch(const BatchRecord& batch);

/// What format_batch wrote. Throws std::runtime_error on anything else.
BatchRecord parse_batch(std::string_view text);

}  // namespace cyl
