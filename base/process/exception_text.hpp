// SPDX-License-Identifier: MIT
// What an interpreter prints when an exception ends its program: the line that matters is neither the first
// nor the last.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace cyl {

/// Returns "ValueError: no such shape (mine.py:12)" of a traceback of Python or node: the first line of the
/// exception, at most `cap` bytes with the file and line where it was thrown. Empty where there is none.
std::string exception_text(std::string_view printed, std::size_t cap);

}  // namespace cyl
