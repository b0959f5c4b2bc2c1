// SPDX-License-Identifier: MIT
// The data of the charts on a run's page. RUN/charts.json stores them as one JSON object, for other
// programs and for later commands that write the page again. The names of its fields must not
// change.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "bench/bench.hpp"
#include "oracles/trial/cells.hpp"
#include "reports/run/run_data.hpp"

namespace cyl {

/// Returns a map for each method and plane in which it was asked, in the run's order: its axes, and its cells
/// with their counts. A cell has the first stored finding that is counted as wrong or failed there.
nlohmann::json failure_maps(const RunData& run);

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
