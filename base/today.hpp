// SPDX-License-Identifier: MIT
// The day, where the machine is.
#pragma once

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>
#include <string>

namespace cyl {

/// YYYY-MM-DD.
inline std::string today() { return fmt::format("{:%Y-%m-%d}", fmt::localtime(std::time(nullptr))); }

}  // namespace cyl
