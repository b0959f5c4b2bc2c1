// SPDX-License-Identifier: MIT
// Replaces a fuzzing engine: runs a target once on each named file and on each file of a named folder. Exits
// with 1 if a file cannot be read, if the target rejects one, or if there are none. Aborts at a finding.
// --cases FOLDER runs it on every case of the case files in the folder, and on the first pairs of every
// family.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <stdexcept>
#include <string>

#include "corpus/pairs/families.hpp"
#include "corpus/store/case_files.hpp"
#include "fuzz/guided/record.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

void run(std::span<const std::uint8_t> bytes) {
  if (LLVMFuzzerTestOneInput(bytes.data(), bytes.size()) != 0)
    throw std::runtime_error("no input of this target, by its " + std::to_string(bytes.size()) + " bytes");
}

void replay(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file)) throw std::runtime_error("cannot be read");
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  if (in.bad()) throw std::runtime_error("cannot be read");
  std::fprintf(stderr, "%s\n", file.c_str());
  run({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
}

/// Returns the number of pairs.
int run_on_cases(const std::string& folder) {
  int count = 0;
  const auto run_on = [&](const cyl::Pair& pair) { run(cyl::encode_record(pair)), ++count; };
  for (const cyl::Case& c : cyl::read_case_folder(folder)) run_on(c.pair);
  for (const cyl::Family& family : cyl::campaign_families())
    for (const std::uint64_t index : {0, 1}) run_on(family.generate(1, index));  // often a gap and an overlap
  return count;
}

}  // namespace

int main(int argc, char** argv) {
  setenv("DAYLIGHT_FUZZ_ABORT", "1", 0);  // a finding is a failure here
  int count = 0, failures = 0;
  const auto attempt = [&](const std::filesystem::path& file) {
    try {
      replay(file);
      ++count;
    } catch (const std::exception& error) {
      std::fprintf(stderr, "%s: %s\n", file.c_str(), error.what());
      ++failures;
    }
  };
  const bool of_cases = argc == 3 && std::string(argv[1]) == "--cases";
  if (of_cases) count = run_on_cases(argv[2]);
  for (int i = 1; i < argc && !of_cases; ++i) {
    std::error_code no_folder;
    std::filesystem::directory_iterator entries(argv[i], no_folder);
    if (no_folder) attempt(argv[i]);
    for (const auto& entry : entries) attempt(entry.path());
  }
  std::fprintf(stderr, "%d inputs\n", count);
  return count > 0 && failures == 0 ? 0 : 1;
}
