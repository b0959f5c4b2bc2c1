// SPDX-License-Identifier: MIT
// make_records CASES FOLDER makes the first inputs of a fuzzing engine. FOLDER gets a record of every case
// of the case files in CASES, and of the first pairs of every family. FOLDER.dict gets the numbers that
// occur in several cases, as the eight bytes they have in a record.
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <set>
#include <stdexcept>
#include <string>

#include "corpus/pairs/families.hpp"
#include "corpus/store/case_files.hpp"
#include "fuzz/guided/record.hpp"

namespace {

/// A gap and a penetration of each family whose indices alternate between them.
constexpr std::uint64_t pairs_of_a_family = 2;
constexpr std::uint64_t seed = 1;
/// Cases with a number, from which on it goes into the dictionary.
constexpr std::size_t common_cases = 3;

using Numbers = std::array<std::uint64_t, cyl::record_size / 8>;

void write(const std::filesystem::path& file, const char* bytes, std::size_t size) {
  std::ofstream out(file, std::ios::binary);
  out.write(bytes, static_cast<std::streamsize>(size));
  if (!out.flush()) throw std::runtime_error(file.string() + ": cannot be written");
}

void write_record(const std::filesystem::path& folder, std::string name, const cyl::Record& record) {
  std::replace(name.begin(), name.end(), '/', '-');
  write(folder / name, reinterpret_cast<const char*>(record.data()), record.size());
}

/// "\x00..": a line of the dictionaries of libFuzzer and AFL.
std::string entry(std::uint64_t number) {
  constexpr char digits[] = "0123456789abcdef";
  std::string line = "\"";
  for (const auto byte : std::bit_cast<std::array<std::uint8_t, 8>>(number))
    line.append("\\x").append(1, digits[byte >> 4]).append(1, digits[byte & 15]);
  return line + "\"\n";
}

void make(const std::string& cases, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  std::map<std::uint64_t, std::size_t> cases_with;
  for (const cyl::Case& c : cyl::read_case_folder(cases)) {
    const std::string place = std::filesystem::path(c.file).stem().string() + "-" + std::to_string(c.line);
    const cyl::Record record = cyl::encode_record(c.pair);
    write_record(folder, c.id.empty() ? place : c.id, record);
    const auto numbers = std::bit_cast<Numbers>(record);
    for (const std::uint64_t number : std::set<std::uint64_t>(numbers.begin(), numbers.end()))
      ++cases_with[number];
  }
  for (const cyl::Family& family : cyl::campaign_families())
    for (std::uint64_t i = 0; i < pairs_of_a_family; ++i)
      write_record(folder, std::string(family.name) + "-" + std::to_string(seed) + "-" + std::to_string(i),
                   cyl::encode_record(family.generate(seed, i)));
  std::string dictionary;
  for (const auto& [number, count] : cases_with)
    if (count >= common_cases) dictionary += entry(number);
  write(folder.string() + ".dict", dictionary.data(), dictionary.size());
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
