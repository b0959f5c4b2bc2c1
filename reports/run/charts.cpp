// SPDX-License-Identifier: MIT
#include "reports/run/charts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "base/files.hpp"
#include "base/json.hpp"
#include "base/usage_error.hpp"
#include "bench/curves.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;

bool is_counted(FindingKind k) {
  return k == FindingKind::wrong_disjoint || k == FindingKind::wrong_intersecting || is_failure(k);
}

using MapPlace = std::tuple<std::string, std::size_t, int, int>;  // method, plane, x, y

/// Returns the first kept finding in each cell of each method. Findings on undecided or invalid pairs are in
/// no cell.
std::map<MapPlace, std::int64_t> first_findings(const RunData& run) {
  std::map<MapPlace, std::int64_t> first;
  for (std::size_t i = 0; i < run.findings.size(); ++i) {
    const FindingRecord& f = run.findings[i];
    const auto& [line, truth] = run.pairs[i];
    if (!is_counted(f.kind) || !truth || !line) continue;
    const auto cells = cells_of(line->pair, *truth);
    for (std::size_t p = 0; p < planes.size(); ++p)
      first.try_emplace({f.method, p, cells[p].x, cells[p].y}, f.id);
  }
  return first;
}

nlohmann::json axis_json(const CellAxis& axis) { return {{"title", axis.title}, {"labels", axis.labels}}; }

/// Leaves out counts of 0, because most counts are 0.
nlohmann::json cell_json(const CellRecord& r, const CellCounts& n) {
  nlohmann::json cell{{"x", r.x}, {"y", r.y}};
  for (const auto& [name, count] : {std::pair("asked", n.asked),
                                    {"wrong_disjoint", n.wrong_disjoint},
                                    {"wrong_intersecting", n.wrong_intersecting},
                                    {"within_disjoint", n.within_disjoint},
                                    {"within_intersecting", n.within_intersecting},
                                    {"declined", n.declined},
                                    {"failed", n.failed},
                                    {"undecided", n.undecided}})
    if (count != 0) cell[name] = count;
  return cell;
}

nlohmann::json speed_json(const SpeedPoint& p) {
  return {{"method", p.method},
          {"curve", p.curve},
          {"setting", p.setting},
          {"family", "all"},
          {"query", p.query},
          {"ns", number_or_null(p.ns)},
          {"p99", number_or_null(p.p99_ns)},
          {"asked", p.asked},
          {"wrong_disjoint", p.wrong_disjoint},
          {"wrong_intersecting", p.wrong_intersecting},
          {"digits", number_or_null(p.digits.right)},
          {"digits_low", number_or_null(p.digits.low)}};
}

nlohmann::json read_json(const fs::path& file) try {
  return parse_foreign_json(read_file(file));
} catch (const std::exception& e) {
  throw InputError(file.string() + " cannot be read: " + e.what());
}

double measured(const nlohmann::json& x) { return x.is_null() ? not_measured : x.get<double>(); }

}  // namespace

nlohmann::json failure_maps(const RunData& run) {
  const std::map<MapPlace, std::int64_t> findings = first_findings(run);
  nlohmann::json maps = nlohmann::json::array();
  for (std::size_t m = 0; m < run.methods.size(); ++m) {
    for (const Plane plane : planes) {
      nlohmann::json cells = nlohmann::json::array();
      for (const CellRecord& r : run.cells) {
        if (r.plane != to_string(plane) || m >= r.methods.size() || r.methods[m].asked == 0) continue;
        const CellCounts& n = r.methods[m];
        const auto first = findings.find({run.methods[m].name, static_cast<std::size_t>(plane), r.x, r.y});
        cells.push_back(cell_json(r, n));
        if (first != findings.end() && n.wrong_disjoint + n.wrong_intersecting + n.failed > 0)
          cells.back()["finding"] = first->second;
      }
      if (cells.empty()) continue;
      maps.push_back({{"method", run.methods[m].name},
                      {"plane", to_string(plane)},
                      {"x", axis_json(x_axis(plane))},
                      {"y", axis_json(y_axis(plane))},
                      {"cells", std::move(cells)}});
    }
  }
  return maps;
}

std::vector<BenchRow> read_bench(const fs::path& file) {
  std::vector<BenchRow> rows;
  try {
    const nlohmann::json bench = read_json(file);
    for (const nlohmann::json& r : bench.at("results")) {
      BenchRow row;
      row.method = r.at("method");
      row.name = {r.at("library"), r.at("algorithm"), r.at("setting")};
      row.family = r.at("family");
      row.query = r.at("query");
      row.pairs = r.at("n");
      row.median_ns = measured(r.at("median_ns"));
      row.p99_ns = measured(r.at("p99_ns"));
      row.wrong_disjoint = r.at("wrong_disjoint");
      row.wrong_intersecting = r.at("wrong_intersecting");
      row.undecided = r.at("undecided");
      row.failed = r.at("failed");
      rows.push_back(std::move(row));
    }
  } catch (const nlohmann::json::exception&) {
    throw InputError(file.string() + " is not a result of `daylight bench --json`");
  }
  return rows;
}

std::string origin_of_bench(const fs::path& file) {
  const nlohmann::json bench = read_json(file);
  std::vector<std::string> stated;
  for (const char* key : {"cpu", "compiler", "date"})
    if (bench.contains(key)) stated.push_back(bench.at(key));
  return fmt::format("{}", fmt::join(stated, ", "));
}

nlohmann::json read_charts(const fs::path& run) {
  const fs::path file = run / "charts.json";
  nlohmann::json charts = fs::exists(file) ? read_json(file) : nlohmann::json::object();
  if (!charts.is_object()) throw std::runtime_error(file.string() + " holds no object");
  return charts;
}

void set_charts(RunData& run, const nlohmann::json& fields) {
  run.charts.update(fields);
  replace_file(fs::path(run.folder) / "charts.json", run.charts.dump() + '\n');
}

void write_charts(RunData& run, const std::vector<BenchRow>& bench) {
  nlohmann::json fields = {{"maps", failure_maps(run)}};
  for (const SpeedPoint& p : speed_points(bench))
    if (p.query != "distance") fields["speed"].push_back(speed_json(p));
  set_charts(run, fields);
}

}  // namespace cyl
