// SPDX-License-Identifier: MIT
#include "props/mutants/kill_data.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string_view>

#include "base/json.hpp"

namespace cyl {
namespace {

using json = nlohmann::ordered_json;

/// In the order in which they are run.
constexpr std::string_view detectors[] = {"laws", "corpus", "differential", "fuzz", "gate", "tests"};

json row_of(const json& line) {
  json row = {{"mutant", line.at("mutant").get<int>()},
              {"file", line.at("file").get<std::string>()},
              {"what", line.at("what").get<std::string>()},
              {"caught_by", json::array()}};
  for (const std::string_view detector : detectors) {
    const auto at = line.find(std::string(detector));
    if (at != line.end() && at->at("fate") != "survived") row["caught_by"].push_back(detector);
  }
  if (const std::string why = line.value("equivalent", ""); !why.empty()) row["equivalent"] = why;
  return row;
}

}  // namespace

json kill_data(const std::string& file) {
  if (!std::filesystem::exists(file)) return nullptr;
  int caught = 0, equivalent = 0;
  json rows = json::array();
  std::ifstream in(file);
  std::string line;
  for (std::size_t number = 1; std::getline(in, line); ++number) {
    try {
      json row = row_of(parse_ordered_json(line));
      if (row["mutant"] == 0) continue;  // the program as it is
      caught += !row["caught_by"].empty();
      equivalent += row["caught_by"].empty() && row.contains("equivalent");
      rows.push_back(std::move(row));
    } catch (const json::exception& error) {
      throw std::runtime_error(
          fmt::format("{}, line {} is no row of a kill matrix: {}", file, number, error.what()));
    }
  }
  if (in.bad() || rows.empty()) throw std::runtime_error(file + " holds no kill matrix");
  return {{"mutants", rows.size()}, {"caught", caught}, {"equivalent", equivalent}, {"rows", rows}};
}

}  // namespace cyl
