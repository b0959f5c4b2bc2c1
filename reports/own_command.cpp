// SPDX-License-Identifier: MIT
#include "reports/own_command.hpp"

#include <filesystem>
#include <system_error>

namespace cyl {

std::string own_command() {
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
  return std::filesystem::exists(program.parent_path() / "CMakeCache.txt", error) ? "./daylight" : "daylight";
}

}  // namespace cyl
