// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

namespace cyl {

/// Returns the message of what `act` throws.
template <class Error = std::runtime_error, class Act>
std::string error_of(const Act& act) {
  try {
    act();
  } catch (const Error& error) {
    return error.what();
  }
  return "nothing thrown";
}

}  // namespace cyl
