// SPDX-License-Identifier: MIT
#include "reports/run/run_data.hpp"

#include <filesystem>

#include "reports/run/charts.hpp"

namespace cyl {
namespace {

FoundPair found_pair(const FindingRecord& finding) {
  FoundPair pair{parse_case(finding.pair, 1).value, {}};
  const auto truth = nlohmann::json::parse(finding.truth, nullptr, false);
  if (!truth.is_object() || !truth.contains("verdict") || !truth["verdict"].is_string()) return pair;
  pair.truth = from_word<Verdict>(truth["verdict"].get_ref<const std::string&>());
  if (pair.truth == Verdict::undecided || pair.truth == Verdict::invalid) pair.truth.reset();
  return pair;
}

}  // namespace

RunData read_run(const std::string& folder, std::span<const Family> families) {
  const RunStore store = RunStore::open(folder);
  RunData run;
  run.folder = folder;
  run.families = families;
  run.config = store.config();
  run.progress = store.progress();
  run.methods = store.methods();
  run.tallies = store.tallies();
  run.groups = store.groups();
  run.findings = store.findings();
  for (const FindingRecord& finding : run.findings) run.pairs.push_back(found_pair(finding));
  run.cells = store.cells();
  run.history = compare_with_earlier(run);
  run.charts = read_charts(folder);
  return run;
}

}  // namespace cyl
