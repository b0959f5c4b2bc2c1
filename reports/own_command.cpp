// SPDX-License-Identifier: MIT
#include "reports/own_command.hpp"

#include <cstdlib>

#include "corpus/shell_words.hpp"

namespace cyl {

std::string own_command() {
  const char* called = std::getenv("DAYLIGHT_COMMAND");
  return called != nullptr ? shell_quoted(called) : "daylight";
}

}  // namespace cyl
