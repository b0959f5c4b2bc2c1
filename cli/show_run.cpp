// SPDX-License-Identifier: MIT
#include "cli/show_run.hpp"

#include <fmt/format.h>

#include <system_error>
#include <tuple>

#include "base/own_command.hpp"
#include "base/safe_text.hpp"
#include "base/source_tree.hpp"
#include "fuzz/campaign/self_check.hpp"
#include "reports/run/charts.hpp"
#include "reports/run/report_data.hpp"
#include "reports/run/tally_table.hpp"

namespace cyl {
namespace {

namespace fs = std::filesystem;

/// Returns the finding to look at first: beyond a claim before within, a wrong verdict before anything else,
/// then by margin.
const FindingRecord* worst_finding(const RunData& run) {
  const FindingRecord* worst = nullptr;
  const auto key = [](const FindingRecord& f) {
    return std::tuple(f.severity == "contract", f.severity == "resolution", f.kind.starts_with("wrong_"),
                      f.margin ? f.margin->lo : 0.0);
  };
  for (const FindingRecord& f : run.findings) {
    if (!worst || key(f) > key(*worst)) worst = &f;
  }
  return worst;
}

}  // namespace

void point_latest_at(const fs::path& run) {
  const fs::path folder = fs::absolute(run).parent_path(), link = folder / "latest",
                 unfinished = folder / ".latest";
  if (folder.filename() != "runs" || (fs::exists(fs::symlink_status(link)) && !fs::is_symlink(link))) return;
  std::error_code error;  // a file system without symbolic links does without
  fs::remove(unfinished, error);
  fs::create_directory_symlink(run.filename(), unfinished, error);
  if (!error) fs::rename(unfinished, link, error);
}

void show_run(const std::string& folder, std::uint64_t pairs) {
  RunData run = read_run(folder);
  write_charts(run, {});
  write_page(run, in_source_tree("props/mutants/kill_matrix.jsonl"));
  fmt::print("{}", format_tallies(tally_methods(run.tallies)));
  if (run.history.runs + run.history.unreadable > 0) fmt::print("{}\n", format_history(run.history));
  if (const std::string checks = format_self_checks(run.self_checks); !checks.empty())
    fmt::print("{}\n", checks);
  fmt::print("{} pairs; page: {}/report.html\n", pairs, folder);
  if (const auto worst = worst_finding(run)) {
    fmt::print("the worst, {} {} ({}): {} replay {}\n", worst->method, worst->kind, worst->severity,
               own_command(), shell_quoted(fmt::format("{}:{}", folder, worst->id)));
  }
}

}  // namespace cyl
