// SPDX-License-Identifier: MIT
// A folder for the files of one test.
#pragma once

#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

namespace cyl {

/// A new and empty folder, removed with the object.
class Scratch {
 public:
  Scratch() = default;
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  ~Scratch() { std::filesystem::remove_all(folder); }

  /// Writes a file in the folder and returns its path.
  std::string write(const std::string& name, const std::string& content) const {
    std::ofstream(folder / name, std::ios::binary) << content;
    return folder / name;
  }

  const std::filesystem::path folder = make();

 private:
  static std::filesystem::path make() {
    std::string name = std::filesystem::temp_directory_path() / "daylight_test_XXXXXX";
    if (!mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
    return name;
  }
};

}  // namespace cyl
