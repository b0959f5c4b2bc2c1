// SPDX-License-Identifier: MIT
// For tests: an export as its receiver has it.
#pragma once

#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <string_view>

#include "base/safe_text.hpp"
#include "base/scratch_test.hpp"
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
class Folder : Scratch {
 public:
  explicit Folder(const Export& files) { write_export(files, folder.string()); }

  Ran run(const std::string& command) const {
    const std::string all = "cd " + shell_quoted(folder.string()) + " && { " + command + "; } >printed 2>&1";
    const int status = std::system(all.c_str());
    std::ifstream in(folder / "printed");
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
            {std::istreambuf_iterator<char>(in), {}}};
  }
};

}  // namespace cyl
