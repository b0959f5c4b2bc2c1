// SPDX-License-Identifier: MIT
// The data of the charts on a run's page: RUN/charts.json, one JSON object. The names of its fields are the
// page's contract.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "bench/bench.hpp"
#include "corpus/store/run_store.hpp"
#include "oracles/trial/cells.hpp"

namespace cyl {

struct MapCell {
  Cell at;
  CellCounts counts;
  std::optional<std::int64_t> finding;  ///< the first kept one of those counted as wrong or failed here
};

/// Of one method; cells in which it was not asked are left out.
struct FailureMap {
  std::string method;
  Plane plane;
  std::vector<MapCell> cells;
};

/// By method, in the run's order, and plane; methods that no cell was asked of are left out.
std::vector<FailureMap> failure_maps(const RunStore& run);

/// The rows of plane angle-margin: bin d holds margins in (10^(-d-1), 10^-d], the last, 16, all below, and
/// what touches.
struct Honesty {
  std::string method;
  std::vector<std::pair<int, CellCounts>> bins;  ///< by decade, those that were asked about
};
std::vector<Honesty> honesty_of(const std::vector<FailureMap>& maps);

/// The rows in a file that `daylight bench --json` wrote. Throws std::runtime_error that names the file.
std::vector<BenchRow> read_bench(const std::filesystem::path& file);

/// Sets fields of the object in RUN/charts.json; others stay as they are.
void set_charts(const std::filesystem::path& run, const nlohmann::json& fields);

/// Writes RUN/charts.json: "maps" and "honesty" from the run, "speed" and "cost" from `bench`, if there are
/// rows. What is in the file under other names, and under these two where there are none, stays.
void write_charts(const std::filesystem::path& run, const std::vector<BenchRow>& bench);

}  // namespace cyl
