// SPDX-License-Identifier: MIT
#include "cli/build_info.hpp"

#include <fstream>

#include "cli/built_from.hpp"

namespace cyl {

namespace {

std::string cpu_name() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "unknown";
}

}  // namespace

std::string BuildInfo::text() const {
  const std::string without = BUILT_WITHOUT;
  return "daylight " + version + " (" + commit + ", " + compiler + ", " + flags + ")" +
         (without.empty() ? "" : "\nbuilt without: " + without);
}

BuildInfo build_info() {
  std::string compiler = __VERSION__;
#ifndef __clang__
  compiler = "gcc " + compiler;
#endif
  return {BUILT_FROM_VERSION, BUILT_FROM_COMMIT, compiler, BUILT_WITH_FLAGS, cpu_name()};
}

}  // namespace cyl
