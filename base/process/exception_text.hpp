// SPDX-License-Identifier: MIT
// Finds the line that matters in the text that an interpreter prints when an exception ends its program. It
// is neither the first nor the last line.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace cyl {

/// Returns "ValueError: no such shape (mine.py:12)" from a traceback of Python or node: the first line of the
/// exception, at most `cap` bytes, with the file and line that threw it. Empty if there is none.
std::string exception_text(std::string_view printed, std::size_t cap);

}  // namespace cyl
