// SPDX-License-Identifier: MIT
#include "props/mutants/kill_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "base/json.hpp"

namespace cyl {
namespace {

using json = nlohmann::ordered_json;

/// In the order in which they are run.
constexpr const char* detectors[] = {"laws", "corpus", "differential", "fuzz", "gate", "tests"};

/// A fault is not planted if the kill matrix found it only from this pair of a family on. With bad luck it
/// could take more than self_check_pairs_cap pairs.
constexpr std::uint64_t rare_from = 50;

KillMatrixRow row_of(const nlohmann::json& line) {
  KillMatrixRow row{.mutant = line.at("mutant"),
                    .file = line.at("file"),
                    .what = line.at("what"),
                    .asks = line.value("asks", ""),
                    .equivalent = line.value("equivalent", ""),
                    .caught_by = {}};
  for (const std::string detector : detectors) {
    const auto at = line.find(detector);
    if (at != line.end() && at->at("fate") != "survived") row.caught_by.push_back(detector);
    if (at != line.end() && at->contains("family_index")) row.family_index = at->at("family_index");
  }
  return row;
}

}  // namespace

std::vector<KillMatrixRow> read_kill_matrix(const std::string& file) {
  std::vector<KillMatrixRow> rows;
  std::ifstream in(file);
  std::string line;
  while (std::getline(in, line)) {
    try {
      rows.push_back(row_of(parse_json(line)));
    } catch (const nlohmann::json::exception& error) {
      throw std::runtime_error(
          fmt::format("{}, line {} is not a row of a kill matrix: {}", file, rows.size() + 1, error.what()));
    }
  }
  if (in.bad() || rows.empty()) throw std::runtime_error(file + " holds no kill matrix");
  return rows;
}

std::vector<KillMatrixRow> faults_soon_found(const std::vector<KillMatrixRow>& rows,
                                             std::span<const std::unique_ptr<Method>> methods) {
  const auto names_of = [](std::span<const std::unique_ptr<Method>> some) {
    std::vector<std::string> names;
    for (const auto& method : some) names.emplace_back(method->name());
    return names;
  };
  const std::vector<std::string> all = names_of(all_methods()), here = names_of(methods);
  const auto is_here = [&](std::size_t i) {
    return std::find(here.begin(), here.end(), all[i]) != here.end();
  };
  std::vector<KillMatrixRow> faults;
  for (const KillMatrixRow& row : rows) {
    if (row.family_index.value_or(rare_from) >= rare_from) continue;
    const std::vector<std::size_t> asked = select_names(all, row.asks);
    if (std::all_of(asked.begin(), asked.end(), is_here)) faults.push_back(row);
  }
  return faults;
}

json kill_data(const std::string& file) {
  if (!std::filesystem::exists(file)) return nullptr;
  int detected = 0, equivalent = 0;
  json rows = json::array();
  for (const KillMatrixRow& row : read_kill_matrix(file)) {
    if (row.mutant == 0) continue;
    detected += !row.caught_by.empty();
    equivalent += row.caught_by.empty() && !row.equivalent.empty();
    rows.push_back(
        {{"mutant", row.mutant}, {"file", row.file}, {"what", row.what}, {"caught_by", row.caught_by}});
    if (!row.equivalent.empty()) rows.back()["equivalent"] = row.equivalent;
  }
  if (rows.empty()) throw std::runtime_error(file + " holds no kill matrix");
  return {{"mutants", rows.size()}, {"caught", detected}, {"equivalent", equivalent}, {"rows", rows}};
}

}  // namespace cyl
