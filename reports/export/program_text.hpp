// SPDX-License-Identifier: MIT
// Text of programs that are written for others to run.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace cyl {

using Words = std::map<std::string, std::string, std::less<>>;

/// `text` with every @word@ replaced.
std::string filled(std::string_view text, const Words& words);

/// A literal of C, C++ and Python that is this double: no integer that a type could be too small for, and -0
/// stays it.
std::string literal(double x);

/// "1, 2.5, -0.0".
std::string listed(const double* numbers, int count);

}  // namespace cyl
