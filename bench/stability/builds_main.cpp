// SPDX-License-Identifier: MIT
// For bench/stability/builds.sh. "pairs FILE" writes the pairs for the builds. "compare PAIRS NAME ANSWERS
// NAME ANSWERS .." compares every build with the first and prints a line of JSON for each build and method.
#include <cstdio>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/json.hpp"
#include "bench/stability/build_pairs.hpp"
#include "bench/stability/builds.hpp"

namespace cyl {
namespace {

template <class T>
std::vector<T> read_all(const char* file) {
  std::ifstream in(file, std::ios::binary);
  std::vector<T> all;
  for (T one; in.read(reinterpret_cast<char*>(&one), sizeof one);) all.push_back(one);
  if (all.empty()) throw std::runtime_error(std::string(file) + " holds nothing");
  return all;
}

struct Numbers {
  double of[doubles_per_pair];
};

void write_pairs(const char* file) {
  std::ofstream out(file, std::ios::binary);
  for (const Pair& pair : build_pairs()) {
    Numbers numbers;
    numbers_of(pair, numbers.of);
    out.write(reinterpret_cast<const char*>(&numbers), sizeof numbers);
  }
  if (!out.flush()) throw std::runtime_error(std::string(file) + " cannot be written");
}

void compare_files(const char* pairs_file, std::span<char*> builds) {
  std::vector<Pair> pairs;
  for (const Numbers& numbers : read_all<Numbers>(pairs_file))
    pairs.push_back(pair_of(numbers.of, cylinder_number_count));
  const auto methods = built_methods();
  BuildComparison comparison(methods, pairs);
  const auto reference = read_all<MethodAnswer>(builds[1]);
  for (std::size_t b = 2; b + 1 < builds.size(); b += 2) {
    for (BuildDifference& d : comparison.compare(reference, read_all<MethodAnswer>(builds[b + 1]))) {
      d.build = builds[b];
      d.against = builds[0];
      std::puts(to_json(d).dump().c_str());
    }
  }
}

}  // namespace
}  // namespace cyl

int main(int count, char** arguments) try {
  const std::string what = count > 2 ? arguments[1] : "";
  if (what == "pairs")
    cyl::write_pairs(arguments[2]);
  else if (what == "compare" && count > 4)
    cyl::compare_files(arguments[2], {arguments + 3, static_cast<std::size_t>(count - 3)});
  else
    return 64;
} catch (const std::exception& e) {
  std::fprintf(stderr, "%s\n", e.what());
  return 1;
}
