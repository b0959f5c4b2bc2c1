// SPDX-License-Identifier: MIT
#include "reports/run/run_summary.hpp"

#include <gtest/gtest.h>

#include "corpus/pairs/pair_io.hpp"

namespace cyl {
namespace {

FindingRecord finding(double size, Severity severity, double margin) {
  FindingRecord f;
  f.kind = FindingKind::wrong_disjoint;
  f.severity = severity;
  f.margin = Enclosure{margin, margin};
  f.pair = format_pair({{{0, 0, 0}, {0, 0, 1}, size, size}, {{size, 0, 0}, {0, 1, 0}, size, size}});
  return f;
}

TEST(RunSummary, TheWorstIsOfOrdinarySizeIfOneIs) {
  RunData run;
  run.findings = {finding(1e200, Severity::contract, 0.9), finding(1, Severity::resolution, 0.8),
                  finding(1e-9, Severity::contract, 0.7)};
  const auto order = [&] {
    run.pairs.clear();
    for (const FindingRecord& f : run.findings) run.pairs.push_back({parse_case(f.pair, 1).value, {}});
    return worst_first(run);
  };
  EXPECT_EQ(order(), (std::vector<std::size_t>{0, 2, 1}));
  run.findings.push_back(finding(1, Severity::contract, 0.1));
  run.findings.push_back(finding(1, Severity::contract, 0.2));
  run.findings.push_back(finding(0.001, Severity::contract, 0.5));
  EXPECT_EQ(order(), (std::vector<std::size_t>{4, 3, 0, 2, 5, 1})) << "0.001 is no ordinary radius";
}

TEST(RunSummary, CountsFindingsAsThePageDoes) {
  RunData run;
  run.folder = ".";
  run.groups = {{{"m", FindingKind::crash, Severity::contract, "f"}, 75, 0},
                {{"m", FindingKind::wrong_disjoint, Severity::resolution, "f"}, 41, 0}};
  EXPECT_NE(format_summary(run).find("\nfindings: 116\n"), std::string::npos);
}

}  // namespace
}  // namespace cyl
