// SPDX-License-Identifier: MIT
#include "corpus/store/case_files.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "base/usage_error.hpp"

namespace cyl {

std::vector<Case> read_case_folder(const std::string& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code fault;
  for (auto entry = std::filesystem::directory_iterator(folder, fault);
       !fault && entry != std::filesystem::directory_iterator(); entry.increment(fault))
    if (entry->path().extension() == ".jsonl") files.push_back(entry->path());
  if (fault) throw UsageError(folder + ": " + fault.message());
  std::sort(files.begin(), files.end());

  std::vector<Case> cases;
  for (const auto& file : files) {
    std::ifstream in(file);
    if (!in) throw std::runtime_error(file.string() + ": cannot be opened");
    CaseReader reader(in);
    while (auto line = reader.next()) {
      if (!line->value) throw InputError(file.string() + ": " + line->error);
      line->value->file = file.string();
      line->value->line = line->line;
      cases.push_back(std::move(*line->value));
    }
    if (in.bad()) throw std::runtime_error(file.string() + ": cannot be read");
  }
  return cases;
}

}  // namespace cyl
