// SPDX-License-Identifier: MIT
// The data of the charts on a run's page. RUN/charts.json stores them as one JSON object, for other
// programs and for later commands that write the page again. The names of its fields must not
// change.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "bench/bench.hpp"
#include "oracles/trial/cells.hpp"
#include "reports/run/run_data.hpp"

namespace cyl {

struct MapCell {
  Cell at;
  CellCounts counts;
  std::optional<std::int64_t> finding;  ///< the first stored finding that is counted as wrong or failed here
};

/// The cells of a plane in which a method was asked.
struct FailureMap {
  std::string method;
  Plane plane;
  std::vector<MapCell> cells;
};

/// By method, in the run's order, and plane; methods that no cell was asked of are left out.
std::vector<FailureMap> failure_maps(const RunData& run);

/// The rows in a file that `daylight bench --json` wrote. Throws InputError that names the file.
std::vector<BenchRow> read_bench(const std::filesystem::path& file);

/// The machine, the compiler and the date of such a file, as far as it states them.
std::string origin_of_bench(const std::filesystem::path& file);

/// Returns the content of RUN/charts.json, or {} if there is no such file. Throws std::runtime_error that
/// names the file.
nlohmann::json read_charts(const std::filesystem::path& run);

/// Sets fields of `run.charts` and writes RUN/charts.json; other fields stay as they are.
void set_charts(RunData& run, const nlohmann::json& fields);

/// Sets the chart "maps" from the run, and "speed" from `bench`, if there are rows.
void write_charts(RunData& run, const std::vector<BenchRow>& bench);

}  // namespace cyl
