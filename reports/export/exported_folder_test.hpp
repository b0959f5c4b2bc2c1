// SPDX-License-Identifier: MIT
// For tests: an export as its receiver has it.
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <string_view>

#include "base/safe_text.hpp"
#include "reports/export/export.hpp"

namespace cyl {

inline bool has(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

struct Ran {
  int status;
  std::string printed;
};

/// A folder of its own, with an export in it.
class Folder {
 public:
  explicit Folder(const Export& files) {
    std::string name = (std::filesystem::temp_directory_path() / "daylight-export-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = name;
    write_export(files, name);
  }
  ~Folder() { std::filesystem::remove_all(path_); }

  Ran run(const std::string& command) const {
    const std::string all = "cd " + shell_quoted(path_.string()) + " && { " + command + "; } >printed 2>&1";
    const int status = std::system(all.c_str());
    std::ifstream in(path_ / "printed");
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
            {std::istreambuf_iterator<char>(in), {}}};
  }

 private:
  std::filesystem::path path_;
};

}  // namespace cyl
