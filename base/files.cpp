// SPDX-License-Identifier: MIT
#include "base/files.hpp"

#include <fstream>
#include <stdexcept>

namespace cyl {

void write_file(const std::string& name, const std::string& text) {
  std::ofstream out(name);
  out << text;
  out.close();
  if (!out) throw std::runtime_error(name + " cannot be written");
}

}  // namespace cyl
