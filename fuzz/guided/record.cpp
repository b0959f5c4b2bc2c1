// SPDX-License-Identifier: MIT
#include "fuzz/guided/record.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "corpus/pairs/pair_numbers.hpp"

namespace cyl {

using Numbers = std::array<double, 2 * core_number_count>;
static_assert(sizeof(Numbers) == record_size);

Record encode_record(const Pair& pair) { return std::bit_cast<Record>(core_numbers_of(pair)); }

Pair decode_record(std::span<const std::uint8_t, record_size> bytes) {
  Numbers n;
  std::memcpy(n.data(), bytes.data(), record_size);
  return pair_of(n.data(), core_number_count);
}

std::vector<Case> read_corpus(const std::string& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<Case> cases;
  for (const auto& file : files) {
    Record record;
    if (std::filesystem::file_size(file) != record_size ||
        !std::ifstream(file, std::ios::binary).read(reinterpret_cast<char*>(record.data()), record_size))
      throw std::runtime_error(file.string() + ": a record has " + std::to_string(record_size) + " bytes");
    Case& c = cases.emplace_back();
    c.pair = decode_record(record);
    c.id = file.filename().string();
    c.source = "fuzz";
    const Numbers numbers = std::bit_cast<Numbers>(record);
    if (!std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); }))
      cases.pop_back();
  }
  return cases;
}

}  // namespace cyl
