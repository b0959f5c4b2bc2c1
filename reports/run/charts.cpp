// SPDX-License-Identifier: MIT
#include "reports/run/charts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "base/json.hpp"
#include "bench/curves.hpp"
#include "corpus/pairs/pair_io.hpp"
#include "oracles/trial/finding_text.hpp"

namespace cyl {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

constexpr int last_honest_bin = touching_bin - 1;

bool is_wrong_or_failed(const CellCounts& c) {
  return c.wrong_disjoint + c.wrong_intersecting + c.failed > 0;
}

bool is_counted(const std::string& kind) {
  const auto k = from_word<FindingKind>(kind);
  return k == FindingKind::wrong_disjoint || k == FindingKind::wrong_intersecting || (k && is_failure(*k));
}

Verdict proved_verdict(const std::string& truth) {
  const std::string word = describe_truth(truth).verdict;
  return from_word<Verdict>(word).value_or(Verdict::undecided);
}

using Place = std::tuple<std::string, std::size_t, int, int>;  // method, plane, x, y

/// The first finding kept in each cell of each method. What is wrong with undecided or invalid pairs is in
/// none.
std::map<Place, std::int64_t> first_findings(const RunStore& run) {
  std::map<Place, std::int64_t> first;
  for (const FindingRecord& f : run.findings()) {
    if (!is_counted(f.kind)) continue;
    const Verdict truth = proved_verdict(f.truth);
    const CaseLine line = parse_case(f.pair, 1);
    if (truth == Verdict::undecided || truth == Verdict::invalid || !line.value) continue;
    const auto cells = cells_of(line.value->pair, truth);
    for (std::size_t p = 0; p < planes.size(); ++p)
      first.try_emplace({f.method, p, cells[p].x, cells[p].y}, f.id);
  }
  return first;
}

json axis_json(const CellAxis& axis) { return {{"title", axis.title}, {"labels", axis.labels}}; }

json counts_json(const CellCounts& c) {
  return {{"asked", c.asked},
          {"wrong_disjoint", c.wrong_disjoint},
          {"wrong_intersecting", c.wrong_intersecting},
          {"undecided", c.undecided}};
}

json map_json(const FailureMap& map) {
  json cells = json::array();
  for (const MapCell& c : map.cells) {
    json cell = counts_json(c.counts);
    cell["x"] = c.at.x;
    cell["y"] = c.at.y;
    cell["failed"] = c.counts.failed;
    if (c.finding) cell["finding"] = *c.finding;
    cells.push_back(std::move(cell));
  }
  return {{"method", map.method},
          {"plane", to_string(map.plane)},
          {"x", axis_json(x_axis(map.plane))},
          {"y", axis_json(y_axis(map.plane))},
          {"cells", std::move(cells)}};
}

json honesty_json(const Honesty& honesty) {
  json bins = json::array();
  for (const auto& [decade, counts] : honesty.bins) {
    json bin = counts_json(counts);
    bin["decade"] = decade;
    bins.push_back(std::move(bin));
  }
  return {{"method", honesty.method}, {"family", nullptr}, {"bins", std::move(bins)}};
}

json number(double x) { return std::isfinite(x) ? json(x) : json(nullptr); }
json number(const std::optional<int>& x) { return x ? json(*x) : json(nullptr); }

json speed_json(const SpeedPoint& p) {
  return {{"method", p.method},
          {"curve", p.name.curve},
          {"setting", p.name.setting},
          {"family", p.family},
          {"query", p.query},
          {"ns", number(p.ns)},
          {"p99", number(p.p99_ns)},
          {"max", number(p.max_ns)},
          {"asked", p.asked},
          {"wrong_disjoint", p.wrong_disjoint},
          {"wrong_intersecting", p.wrong_intersecting},
          {"digits", number(p.digits.right)},
          {"digits_low", number(p.digits.low)}};
}

json cost_json(const CostPoint& p) {
  return {{"method", p.method},
          {"decade", p.decade},
          {"p50", number(p.p50_ns)},
          {"p99", number(p.p99_ns)},
          {"max", number(p.max_ns)}};
}

template <class Things, class ToJson>
json list(const Things& things, ToJson to_json) {
  json all = json::array();
  for (const auto& thing : things) all.push_back(to_json(thing));
  return all;
}

json read_json(const fs::path& file) try {
  std::ifstream in(file);
  return json::parse(in);
} catch (const json::exception& e) {
  throw std::runtime_error(file.string() + " cannot be read: " + e.what());
}

double measured(const json& x) { return x.is_null() ? not_measured : x.get<double>(); }

}  // namespace

std::vector<FailureMap> failure_maps(const RunStore& run) {
  const std::map<Place, std::int64_t> findings = first_findings(run);
  const std::vector<CellRecord> records = run.cells();
  const std::vector<MethodRecord> methods = run.methods();
  std::vector<FailureMap> maps;
  for (std::size_t m = 0; m < methods.size(); ++m) {
    for (const Plane plane : planes) {
      FailureMap map{methods[m].name, plane, {}};
      for (const CellRecord& r : records) {
        if (r.plane != to_string(plane) || m >= r.methods.size() || r.methods[m].asked == 0) continue;
        MapCell cell{{r.x, r.y}, r.methods[m], {}};
        const auto first = findings.find({map.method, static_cast<std::size_t>(plane), r.x, r.y});
        if (first != findings.end() && is_wrong_or_failed(cell.counts)) cell.finding = first->second;
        map.cells.push_back(cell);
      }
      if (!map.cells.empty()) maps.push_back(std::move(map));
    }
  }
  return maps;
}

std::vector<Honesty> honesty_of(const std::vector<FailureMap>& maps) {
  std::vector<Honesty> all;
  for (const FailureMap& map : maps) {
    if (map.plane != Plane::angle_margin) continue;
    std::map<int, CellCounts> bins;
    for (const MapCell& cell : map.cells) bins[std::min(cell.at.y, last_honest_bin)] += cell.counts;
    all.push_back({map.method, {bins.begin(), bins.end()}});
  }
  return all;
}

std::vector<BenchRow> read_bench(const fs::path& file) {
  const json bench = read_json(file);
  std::vector<BenchRow> rows;
  try {
    for (const json& r : bench.at("results")) {
      BenchRow row;
      row.method = r.at("method");
      row.family = r.at("family");
      row.query = r.at("query");
      row.foreign = r.at("foreign");
      row.pairs = r.at("n");
      row.median_ns = measured(r.at("median_ns"));
      row.p50_ns = measured(r.at("p50_ns"));
      row.p99_ns = measured(r.at("p99_ns"));
      row.max_ns = measured(r.at("max_ns"));
      row.wrong_disjoint = r.at("wrong_disjoint");
      row.wrong_intersecting = r.at("wrong_intersecting");
      row.undecided = r.at("undecided");
      row.failed = r.at("failed");
      rows.push_back(std::move(row));
    }
  } catch (const json::exception& e) {
    throw std::runtime_error(file.string() + " is no result of a bench: " + e.what());
  }
  return rows;
}

void set_charts(const fs::path& run, const json& fields) {
  const fs::path file = run / "charts.json";
  json charts = fs::exists(file) ? read_json(file) : json::object();
  charts.update(fields);
  for (const char* other : {"speed", "cost"})
    if (!charts.contains(other)) charts[other] = json::array();
  const fs::path unfinished = file.string() + ".new";
  std::ofstream out(unfinished);
  out << charts.dump() << '\n';
  if (!out.flush()) throw std::runtime_error(unfinished.string() + " cannot be written");
  fs::rename(unfinished, file);
}

void write_charts(const fs::path& run, const std::vector<BenchRow>& bench) {
  const std::vector<FailureMap> maps = failure_maps(RunStore::open(run));
  json fields = {{"maps", list(maps, map_json)}, {"honesty", list(honesty_of(maps), honesty_json)}};
  if (!bench.empty()) {
    fields["speed"] = list(speed_points(bench), speed_json);
    fields["cost"] = list(cost_points(bench), cost_json);
  }
  set_charts(run, fields);
}

}  // namespace cyl
