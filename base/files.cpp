// SPDX-License-Identifier: MIT
#include "base/files.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace cyl {

std::string read_file(const std::string& name) {
  std::ifstream in(name, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void write_file(const std::string& name, const std::string& text) {
  std::ofstream out(name);
  out << text;
  out.close();
  if (!out) throw std::runtime_error(name + " cannot be written");
}

void replace_file(const std::string& name, const std::string& text) {
  std::string unfinished = name + ".XXXXXX";
  const int made = mkstemp(unfinished.data());  // a name that no file has
  if (made < 0) throw std::runtime_error(name + " cannot be written");
  const mode_t mask = umask(0);
  umask(mask);
  fchmod(made, 0666 & ~mask);
  close(made);
  try {
    write_file(unfinished, text);
  } catch (...) {
    unlink(unfinished.c_str());
    throw;
  }
  if (std::rename(unfinished.c_str(), name.c_str()) == 0) return;
  unlink(unfinished.c_str());
  throw std::runtime_error(name + " cannot be written");
}

}  // namespace cyl
