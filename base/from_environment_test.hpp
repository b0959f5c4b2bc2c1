// SPDX-License-Identifier: MIT
// The amount of a test, which the label deep asks for more of.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <string>

namespace cyl {

inline std::uint64_t from_environment(const char* name, std::uint64_t otherwise) {
  const char* const value = std::getenv(name);
  return value ? std::stoull(value) : otherwise;
}

}  // namespace cyl
