// SPDX-License-Identifier: MIT
#include "reports/kill_section.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "reports/page.hpp"

namespace cyl {
namespace {

/// In the order in which they are run.
constexpr std::string_view detectors[] = {"laws", "corpus", "differential", "fuzz", "gate", "tests"};

struct Row {
  int number = 0;
  std::string file, what, like, equivalent;
  std::map<std::string, double, std::less<>> caught_after;  ///< seconds, by detector
  std::set<std::string, std::less<>> ran;
};

Row row_of(const nlohmann::json& line) {
  Row row;
  row.number = line.at("mutant").get<int>();
  row.file = line.at("file").get<std::string>();
  row.what = line.at("what").get<std::string>();
  row.like = line.at("like").get<std::string>();
  row.equivalent = line.value("equivalent", "");
  for (const std::string_view detector : detectors) {
    const auto at = line.find(detector);
    if (at == line.end()) continue;
    row.ran.emplace(detector);
    if (at->at("fate") != "survived") row.caught_after.emplace(detector, at->at("seconds").get<double>());
  }
  return row;
}

std::vector<Row> read_rows(const std::string& file) {
  std::vector<Row> rows;
  std::ifstream in(file);
  std::string line;
  for (std::size_t number = 1; std::getline(in, line); ++number) {
    try {
      Row row = row_of(nlohmann::json::parse(line));
      if (row.number != 0) rows.push_back(std::move(row));  // 0: the program as it is
    } catch (const nlohmann::json::exception& error) {
      throw std::runtime_error(
          fmt::format("{}, line {} is no row of a kill matrix: {}", file, number, error.what()));
    }
  }
  if (in.bad() || rows.empty()) throw std::runtime_error(file + " holds no kill matrix");
  return rows;
}

std::string part_of(const Row& row) {
  if (row.like.find("seed") != std::string::npos || row.file.find("seed_") != std::string::npos)
    return "methods of the documents, as printed";
  if (row.file.starts_with("solver/")) return "solver";
  for (const char* of_the_referee : {"search", "certificate", "referee", "enclosure", "tangency", "root_sum"})
    if (row.file.starts_with(std::string("oracles/") + of_the_referee)) return "referee";
  return "harness";
}

struct Sums {
  int all = 0, caught = 0, equivalent = 0;
  std::map<std::string, int, std::less<>> by_detector;
};

std::string summary(const std::vector<Row>& rows) {
  std::map<std::string, Sums> parts;
  for (const Row& row : rows) {
    for (Sums* sums : {&parts[part_of(row)], &parts["~"]}) {
      ++sums->all;
      sums->caught += !row.caught_after.empty();
      sums->equivalent += row.caught_after.empty() && !row.equivalent.empty();
      for (const auto& [detector, seconds] : row.caught_after) ++sums->by_detector[detector];
    }
  }
  std::string text =
      "<div class=\"wide\"><table>\n<tr><th>fault planted in</th><th>faults</th><th>caught</th>"
      "<th>argued equivalent</th><th>missed</th>";
  for (const std::string_view detector : detectors) text += fmt::format("<th>by {}</th>", detector);
  text += "</tr>\n";
  for (auto& [part, sums] : parts) {
    text +=
        fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td>", part == "~" ? "all" : part,
                    sums.all, sums.caught, sums.equivalent, sums.all - sums.caught - sums.equivalent);
    for (const std::string_view detector : detectors)
      text += fmt::format("<td>{}</td>", sums.by_detector[std::string(detector)]);
    text += "</tr>\n";
  }
  return text + "</table></div>\n";
}

std::string cell(const Row& row, std::string_view detector) {
  const auto caught = row.caught_after.find(detector);
  if (caught != row.caught_after.end()) return fmt::format("<td>{:.1f} s</td>", caught->second);
  return row.ran.contains(detector) ? "<td>no</td>" : "<td></td>";
}

}  // namespace

std::string kill_section(const std::string& file) {
  if (!std::filesystem::exists(file)) return {};
  const std::vector<Row> rows = read_rows(file);
  std::string text =
      "<h2>Is the harness awake?</h2>\n<p class=\"soft\">Faults planted one at a time, and which part of the "
      "harness "
      "caught each, after how many seconds. As last measured with <code>daylight mutants matrix</code>, not "
      "in this "
      "run.</p>\n" +
      summary(rows) +
      "<details><summary>Every fault</summary>\n<div "
      "class=\"wide\"><table>\n<tr><th></th><th>file</th><th>fault</th>";
  for (const std::string_view detector : detectors) text += fmt::format("<th>{}</th>", detector);
  text += "</tr>\n";
  for (const Row& row : rows) {
    const std::string argued =
        row.equivalent.empty()
            ? ""
            : "<br/><span class=\"soft\">equivalent: " + escape_html(row.equivalent) + "</span>";
    text += fmt::format("<tr><td>{}</td><td class=\"text\">{}</td><td class=\"text\">{}{}</td>", row.number,
                        escape_html(row.file), escape_html(row.what), argued);
    for (const std::string_view detector : detectors) text += cell(row, detector);
    text += "</tr>\n";
  }
  return text + "</table></div></details>\n";
}

}  // namespace cyl
