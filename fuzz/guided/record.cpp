// SPDX-License-Identifier: MIT
#include "fuzz/guided/record.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <set>
#include <stdexcept>

#include "corpus/pairs/pair_numbers.hpp"

namespace cyl {
namespace {

struct SolidRecord {
  std::uint64_t shape = 0;  ///< a Shape
  std::array<double, solid_number_count> numbers;
};
using PairRecord = std::array<SolidRecord, 2>;
static_assert(sizeof(PairRecord) == record_size);

}  // namespace

Record encode_record(const Pair& pair) {
  const PairRecord solids{SolidRecord{static_cast<std::uint64_t>(pair.a.shape), numbers_of(pair.a)},
                          SolidRecord{static_cast<std::uint64_t>(pair.b.shape), numbers_of(pair.b)}};
  Record record;
  std::memcpy(record.data(), solids.data(), record_size);
  return record;
}

std::optional<Pair> decode_record(std::span<const std::uint8_t> bytes) {
  if (bytes.size() != record_size) return {};
  PairRecord solids;
  std::memcpy(solids.data(), bytes.data(), record_size);
  for (const SolidRecord& solid : solids)
    if (solid.shape >= words_of(Shape{}).size()) return {};
  const auto solid_of = [](const SolidRecord& r) {
    Solid solid;
    for (const std::size_t i : places_of(static_cast<Shape>(r.shape))) *numbers_of(solid)[i] = r.numbers[i];
    solid.shape = static_cast<Shape>(r.shape);
    return solid;
  };
  return Pair{solid_of(solids[0]), solid_of(solids[1])};
}

std::vector<Pair> read_corpus(const std::string& folder) {
  namespace fs = std::filesystem;
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::set<Record> known;
  std::vector<Pair> pairs;
  for (const fs::path& file : files) {
    Record record;
    std::optional<Pair> pair;
    if (fs::file_size(file) == record_size &&
        std::ifstream(file, std::ios::binary).read(reinterpret_cast<char*>(record.data()), record_size))
      pair = decode_record(record);
    if (!pair)
      throw std::runtime_error(file.string() + " is not a record of this version of daylight: those have " +
                               std::to_string(record_size) + " bytes and a known shape. Remove the folder; " +
                               "`fuzz` makes a new one");
    const auto numbers = numbers_of(*pair);
    if (std::ranges::all_of(numbers, [](double x) { return std::isfinite(x); }) &&
        known.insert(record).second)
      pairs.push_back(*pair);
  }
  return pairs;
}

}  // namespace cyl
