// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>

namespace cyl {

/// What the user typed is wrong: a name that nothing has, a number out of range, a folder without a run. The
/// program prints the text and ends with exit code 64. Any other exception but InputError, a
/// std::invalid_argument too, is a fault of the harness, exit code 1.
struct UsageError : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// What a file holds is wrong: a line that is no pair, results that are none. Exit code 65.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace cyl
