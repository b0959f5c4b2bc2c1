// SPDX-License-Identifier: MIT
// What the page of a run is given, as JSON: interface Report of reports/web/data.ts.
#pragma once

#include <string>

namespace cyl {

/// From the store of the run, the earlier runs beside it, what triage left (buckets_json() of triage.hpp) and
/// the file FOLDER/charts.json (an object with maps, honesty, speed, cost, paths, backward, builds) where
/// they are there, and the kill matrix in the file of that name, if any. A finding whose record holds no pair
/// is counted, not told. One line of valid UTF-8. Distances are enclosed anew, nearest points are the
/// solver's and approximate. Cost: some 0.1 ms a pair. Throws std::runtime_error that names the file where
/// one cannot be read or holds something else.
std::string report_json(const std::string& run_folder, const std::string& kill_matrix = {});

}  // namespace cyl
