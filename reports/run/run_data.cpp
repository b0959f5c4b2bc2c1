// SPDX-License-Identifier: MIT
#include "reports/run/run_data.hpp"

#include "reports/run/charts.hpp"

namespace cyl {
RunData read_run(const std::string& folder, std::vector<FindingRecord> findings) {
  const RunStore store = RunStore::open(folder);
  RunData run;
  run.folder = folder;
  run.config = store.config();
  run.progress = store.progress();
  run.methods = store.methods();
  run.tallies = store.tallies();
  run.groups = store.groups();
  run.findings = findings.empty() ? store.findings() : std::move(findings);
  for (const FindingRecord& finding : run.findings)  // those of one pair follow each other
    run.pairs.push_back(!run.pairs.empty() && (&finding)[-1].index == finding.index
                            ? run.pairs.back()
                            : FoundPair{parse_case(finding.pair, 1).value, proved_verdict(finding)});
  run.cells = store.cells();
  run.charts = read_charts(folder);
  return run;
}

}  // namespace cyl
