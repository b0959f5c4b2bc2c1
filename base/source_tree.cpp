// SPDX-License-Identifier: MIT
#include "base/source_tree.hpp"

#include <filesystem>
#include <system_error>

namespace cyl {

namespace fs = std::filesystem;

std::string in_source_tree(const std::string& name) {
  std::error_code error;
  for (fs::path at = fs::read_symlink("/proc/self/exe", error); at.has_relative_path();) {
    at = at.parent_path();
    for (const fs::path& folder : {at, at.parent_path() / "share/daylight"})
      if (fs::exists(folder / name)) return folder / name;
  }
  const fs::path here = fs::current_path() / name;
  return fs::exists(here) ? here.string() : std::string();
}

}  // namespace cyl
