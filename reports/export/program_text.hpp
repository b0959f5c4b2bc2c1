// SPDX-License-Identifier: MIT
// Text of programs that are written for others to run.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace cyl {

/// Returns the file of that name in templates/, which is part of this program. Throws std::out_of_range if
/// there is none.
std::string_view template_text(std::string_view name);

using Words = std::map<std::string, std::string, std::less<>>;

/// Returns `text` with every @word@ replaced.
std::string filled(std::string_view text, const Words& words);

/// Returns a literal of C, C++ and Python that is this double: no integer that a type could be too small for,
/// and -0 stays it.
std::string literal(double x);

/// The same for a bound of doubles: the largest one if it is infinite.
std::string bound(double x);

/// Returns "1, 2.5, -0.0".
std::string listed(const double* numbers, int count);

}  // namespace cyl
