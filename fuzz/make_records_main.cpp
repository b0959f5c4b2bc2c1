// SPDX-License-Identifier: MIT
// Turns a case file into inputs of a fuzz target, one file a pair:   make_records FOLDER < cases.jsonl
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

#include "corpus/pair_io.hpp"
#include "fuzz/record.hpp"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: make_records FOLDER < cases.jsonl\n";
    return 64;
  }
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder);
  cyl::CaseReader reader(std::cin);
  while (const auto line = reader.next()) {
    if (!line->value) {
      std::cerr << line->error << '\n';
      return 65;
    }
    std::string name = line->value->id.empty() ? "line-" + std::to_string(line->line) : line->value->id;
    std::replace(name.begin(), name.end(), '/', '-');
    const cyl::Record record = cyl::encode_record(line->value->pair);
    std::ofstream out(folder / name, std::ios::binary);
    out.write(reinterpret_cast<const char*>(record.data()), std::ssize(record));
    if (!out.flush()) {
      std::cerr << name << ": cannot be written\n";
      return 1;
    }
  }
}
