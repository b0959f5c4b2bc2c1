// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>

namespace cyl {

/// An error in the user's command: an unknown name, a number out of range, a folder without a run. The
/// program prints the text and ends with exit code 64. Any other exception except InputError, even
/// std::invalid_argument, is a fault of the harness with exit code 1.
struct UsageError : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// An error in a file: a line that is not a pair, or invalid results. Exit code 65.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace cyl
