// SPDX-License-Identifier: MIT
#include "base/own_command.hpp"

#include <cstdlib>

#include "base/safe_text.hpp"

namespace cyl {

std::string own_command() {
  const char* called = std::getenv("DAYLIGHT_COMMAND");
  return called != nullptr ? shell_quoted(called) : "daylight";
}

}  // namespace cyl
