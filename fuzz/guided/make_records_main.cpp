// SPDX-License-Identifier: MIT
// make_records CASES FOLDER makes the first inputs of a fuzzing engine. FOLDER gets a record of every case
// of the case files in CASES, and of the first pairs of every family.
#include <algorithm>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>

#include "corpus/pairs/families.hpp"
#include "corpus/store/case_files.hpp"
#include "fuzz/guided/record.hpp"

namespace {

/// A gap and a penetration of each family whose indices alternate between them.
constexpr std::uint64_t pairs_of_a_family = 2;
constexpr std::uint64_t seed = 1;

void write_record(const std::filesystem::path& folder, std::string name, const cyl::Pair& pair) {
  std::replace(name.begin(), name.end(), '/', '-');
  const cyl::Record record = cyl::encode_record(pair);
  std::ofstream out(folder / name, std::ios::binary);
  out.write(reinterpret_cast<const char*>(record.data()), static_cast<std::streamsize>(record.size()));
  if (!out.flush()) throw std::runtime_error((folder / name).string() + ": cannot be written");
}

void make(const std::string& cases, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  for (const cyl::Case& c : cyl::read_case_folder(cases)) {
    const std::string place = std::filesystem::path(c.file).stem().string() + "-" + std::to_string(c.line);
    write_record(folder, c.id.empty() ? place : c.id, c.pair);
  }
  for (const cyl::Family& family : cyl::campaign_families())
    for (std::uint64_t i = 0; i < pairs_of_a_family; ++i)
      write_record(folder, std::string(family.name) + "-" + std::to_string(seed) + "-" + std::to_string(i),
                   family.generate(seed, i));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: make_records CASES FOLDER\n";
    return 64;
  }
  try {
    make(argv[1], argv[2]);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
